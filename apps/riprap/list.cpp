// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "riprap/run/find_case.hpp"
#include "riprap/run/progress.hpp"
#include "riprap/run/run_cost.hpp"
#include "riprap/validation/registry.hpp"

namespace riprap {

namespace {

using Json = nlohmann::ordered_json;

struct Entry {
    std::string name, title, file;  ///< the file is empty where the case is built in code
    bool is_long{false};            ///< only run when asked for by name or with --full
};

std::vector<Entry> examples() {
    std::vector<Entry> entries;
    for (const run::KnownCase& known : run::known_cases("cases")) {
        entries.push_back({known.name, known.title, known.file.string()});
    }
    return entries;
}

std::vector<Entry> validations() {
    const std::vector<run::KnownCase> files = run::known_cases("validation");
    std::vector<Entry> entries;
    for (const validation::ValidationCase& one : validation::all_cases()) {
        Entry entry{fmt::format("{}/{}", one.suite, one.name), std::string(one.title), "", one.is_long};
        const auto file = std::find_if(files.begin(), files.end(),
                                       [&entry](const run::KnownCase& known) { return known.name == entry.name; });
        entry.file = file == files.end() ? "" : file->file.string();
        entries.push_back(std::move(entry));
    }
    return entries;
}

Json to_json(const std::vector<Entry>& entries) {
    Json list = Json::array();
    for (const Entry& entry : entries) {
        list.push_back({{"name", entry.name},
                        {"title", entry.title},
                        {"file", entry.file.empty() ? Json() : Json(entry.file)},
                        {"is_long", entry.is_long}});
    }
    return list;
}

void print(const std::string& heading, const std::vector<Entry>& entries) {
    std::size_t width = 0;
    for (const Entry& entry : entries) {
        width = std::max(width, entry.name.size());
    }
    fmt::print("{}\n", heading);
    for (const Entry& entry : entries) {
        fmt::print("  {:<{}}  {}{}\n", entry.name, width, entry.title, entry.is_long ? " (long)" : "");
    }
    if (entries.empty()) {
        fmt::print("  none found\n");
    }
}

}  // namespace

int print_case_names() {
    for (const Entry& entry : examples()) {
        fmt::print("{}\n", entry.name);
    }
    return 0;
}

int print_costs(bool as_json) {
    constexpr double budget = 1.5;  // [s] a case
    Json list = Json::array();
    const std::vector<Entry> cases = examples();
    if (!as_json) {
        fmt::print("{:<20} {:>9} {:>7} {:>9}  about\n", "case", "particles", "bodies", "steps");
    }
    for (const Entry& entry : cases) {
        run::RunCost cost;
        try {
            cost = run::measure_cost(scene::read_case(entry.file), budget);
        } catch (const std::exception& error) {
            cost.refusal = error.what();
        }
        const std::string about = cost.refusal.empty() ? run::duration_text(cost.seconds()) : cost.refusal;
        if (as_json) {
            list.push_back({{"name", entry.name},
                            {"particles", cost.particles},
                            {"free_bodies", cost.free_bodies},
                            {"steps", cost.steps},
                            {"seconds", cost.refusal.empty() ? Json(cost.seconds()) : Json()},
                            {"refusal", cost.refusal}});
        } else {
            fmt::print("{:<20} {:>9} {:>7} {:>9}  {}\n", entry.name, cost.particles, cost.free_bodies, cost.steps,
                       about);
            std::fflush(stdout);
        }
    }
    if (as_json) {
        fmt::print("{}\n", list.dump(2, ' ', false, Json::error_handler_t::replace));
    }
    return 0;
}

int print_list(bool as_json) {
    const std::vector<Entry> cases = examples(), suites = validations();
    if (as_json) {
        const Json answer{{"cases", to_json(cases)}, {"validation", to_json(suites)}};
        fmt::print("{}\n", answer.dump(2, ' ', false, Json::error_handler_t::replace));
        return 0;
    }
    print("cases (riprap run NAME; what each takes: riprap list --costs)", cases);
    print("validation (riprap validate SUITE/CASE)", suites);
    return 0;
}

}  // namespace riprap
