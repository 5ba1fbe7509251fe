// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "riprap/core/error.hpp"
#include "riprap/run/drive/find_case.hpp"
#include "riprap/run/drive/progress.hpp"
#include "riprap/run/drive/published.hpp"
#include "riprap/run/drive/run_cost.hpp"

namespace riprap {

namespace {

using Json = nlohmann::ordered_json;

std::vector<ListedCase> with_files(const std::string& folder) {
    std::vector<ListedCase> cases;
    for (const run::KnownCase& known : run::known_cases(folder)) {
        cases.push_back({known.name, known.title, known.file.string()});
    }
    return cases;
}

std::vector<ListedCase> examples() { return with_files("cases"); }

Json to_json(const std::vector<ListedCase>& entries) {
    Json list = Json::array();
    for (const ListedCase& entry : entries) {
        list.push_back({{"name", entry.name},
                        {"title", entry.title},
                        {"file", entry.file.empty() ? Json() : Json(entry.file)},
                        {"is_long", entry.is_long}});
    }
    return list;
}

void print(const std::string& heading, const std::vector<ListedCase>& entries) {
    std::size_t width = 0;
    for (const ListedCase& entry : entries) {
        width = std::max(width, entry.name.size());
    }
    fmt::print("{}\n", heading);
    for (const ListedCase& entry : entries) {
        fmt::print("  {:<{}}  {}{}\n", entry.name, width, entry.title, entry.is_long ? " (long)" : "");
    }
    if (entries.empty()) {
        fmt::print("  none found\n");
    }
}

/// A name for a copy of a case.
std::string name_of_copy(const std::string& name) { return "my_" + name.substr(name.rfind('/') + 1); }

std::string run_command(const run::PublishedCase& published) { return "riprap run " + published.name; }

std::string copy_command(const run::PublishedCase& published) {
    return fmt::format("riprap new {} --from {}", name_of_copy(published.name), published.name);
}

/// Prints a case with what it is taken from, and the commands that run and copy it where `has_commands`.
void print(const run::PublishedCase& published, bool has_commands) {
    fmt::print("{}  {}\n", published.name, published.title);
    if (!published.source.empty()) {
        fmt::print("    {}\n", published.source);
    }
    for (const std::string& citation : published.source.empty() ? published.citations : std::vector<std::string>()) {
        fmt::print("    {}\n", citation);
    }
    if (has_commands) {
        fmt::print("    {}\n    {}\n", run_command(published), copy_command(published));
    }
}

Json to_json(const run::PublishedCase& published) {
    return {{"name", published.name},        {"title", published.title},         {"file", published.file.string()},
            {"source", published.source},    {"citations", published.citations}, {"run", run_command(published)},
            {"new", copy_command(published)}};
}

}  // namespace

int print_published(const std::vector<std::string>& words, bool as_json) {
    std::vector<run::PublishedCase> cases = run::published_cases();
    if (!words.empty()) {
        std::erase_if(cases, [&words](const run::PublishedCase& one) { return !run::is_about(one, words); });
    }
    if (cases.empty()) {
        throw FileError(
            fmt::format("no published case is about '{}'; `riprap list --published` without words, or with "
                        "the name of an author alone, lists what there is",
                        fmt::join(words, " ")));
    }
    if (as_json) {
        Json list = Json::array();
        for (const run::PublishedCase& one : cases) {
            list.push_back(to_json(one));
        }
        fmt::print("{}\n", list.dump(2, ' ', false, Json::error_handler_t::replace));
        return 0;
    }
    for (const run::PublishedCase& one : cases) {
        print(one, !words.empty());
    }
    if (words.empty()) {
        fmt::print(
            "one figure, one author: riprap list --published ding figure 7.8\n"
            "one of them as a case of your own: riprap new NAME --from SUITE/CASE\n");
    } else {
        const std::string folder = "runs/" + run::short_name(cases.front().file);
        fmt::print("to look at a run: riprap view {0}, riprap plot {0}\n", folder);
    }
    return 0;
}

int print_case_names() {
    for (const ListedCase& entry : examples()) {
        fmt::print("{}\n", entry.name);
    }
    return 0;
}

int print_costs(bool as_json) {
    constexpr double budget = 1.5;  // [s] a case
    Json list = Json::array();
    const std::vector<ListedCase> cases = examples();
    if (!as_json) {
        fmt::print("{:<20} {:>9} {:>7} {:>9}  about\n", "case", "particles", "bodies", "steps");
    }
    for (const ListedCase& entry : cases) {
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

int print_list(const std::function<std::vector<ListedCase>()>& published, bool as_json) {
    const std::vector<ListedCase> cases = examples(), suites = published ? published() : with_files("validation");
    if (as_json) {
        const Json answer{{"cases", to_json(cases)}, {"validation", to_json(suites)}};
        fmt::print("{}\n", answer.dump(2, ' ', false, Json::error_handler_t::replace));
        return 0;
    }
    print("cases (riprap run NAME; what each takes: riprap list --costs)", cases);
    print("validation (riprap validate SUITE/CASE)", suites);
    if (!published) {
        fmt::print("  and cases without a file, listed once `riprap validate` has built its program\n");
    }
    return 0;
}

}  // namespace riprap
