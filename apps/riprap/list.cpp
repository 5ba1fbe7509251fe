// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "riprap/run/find_case.hpp"

namespace riprap {

namespace {

nlohmann::ordered_json to_json(const std::vector<run::KnownCase>& cases) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const run::KnownCase& known : cases) {
        list.push_back({{"name", known.name}, {"title", known.title}, {"file", known.file.string()}});
    }
    return list;
}

void print(const std::string& heading, const std::vector<run::KnownCase>& cases) {
    std::size_t width = 0;
    for (const run::KnownCase& known : cases) {
        width = std::max(width, known.name.size());
    }
    fmt::print("{}\n", heading);
    for (const run::KnownCase& known : cases) {
        fmt::print("  {:<{}}  {}\n", known.name, width, known.title);
    }
    if (cases.empty()) {
        fmt::print("  none found\n");
    }
}

}  // namespace

int print_list(bool as_json) {
    const std::vector<run::KnownCase> cases = run::known_cases("cases"), suites = run::known_cases("validation");
    if (as_json) {
        const nlohmann::ordered_json answer{{"cases", to_json(cases)}, {"validation", to_json(suites)}};
        fmt::print("{}\n", answer.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
        return 0;
    }
    print("cases (riprap run NAME)", cases);
    print("validation (riprap validate SUITE/CASE)", suites);
    return 0;
}

}  // namespace riprap
