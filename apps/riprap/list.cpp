// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "riprap/run/find_case.hpp"
#include "riprap/run/progress.hpp"
#include "riprap/run/run_cost.hpp"

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

/// Sources that a case file cites, each once, in its order; read line by line, as a listing must not fail on a case.
std::vector<std::string> citations_of(const std::string& file) {
    std::ifstream in(file);
    std::vector<std::string> found;
    for (std::string line; std::getline(in, line);) {
        const std::size_t begin = line.find('"'), end = line.rfind('"');
        if (line.rfind("citation", 0) == 0 && begin < end) {
            const std::string citation = line.substr(begin + 1, end - begin - 1);
            if (std::find(found.begin(), found.end(), citation) == found.end()) {
                found.push_back(citation);
            }
        }
    }
    return found;
}

}  // namespace

int print_published(bool as_json) {
    Json list = Json::array();
    for (const ListedCase& entry : with_files("validation")) {
        const std::vector<std::string> sources = citations_of(entry.file);
        if (sources.empty()) {
            continue;
        }
        if (as_json) {
            list.push_back(
                {{"name", entry.name}, {"title", entry.title}, {"file", entry.file}, {"citations", sources}});
            continue;
        }
        fmt::print("{}  {}\n", entry.name, entry.title);
        for (const std::string& source : sources) {
            fmt::print("    {}\n", source);
        }
    }
    if (as_json) {
        fmt::print("{}\n", list.dump(2, ' ', false, Json::error_handler_t::replace));
    } else {
        fmt::print("one of them as a case of your own: riprap new NAME --from validation/SUITE/CASE\n");
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
