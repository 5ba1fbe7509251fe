// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "command_line_parts.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/scene/text/override_paths.hpp"

namespace riprap {

namespace {

/// Path of an assignment: the tables, and the key in the last of them.
std::pair<std::string, std::string> path_of(const std::string& assignment) {
    const std::string path = assignment.substr(0, assignment.find('='));
    const std::size_t point = path.rfind('.');
    return point == std::string::npos ? std::pair(std::string(), path)
                                      : std::pair(path.substr(0, point), path.substr(point + 1));
}

}  // namespace

void refuse_second_value(const std::vector<std::string>& overrides, const std::string& assignment) {
    const auto [tables, key] = path_of(assignment);
    for (const std::string& other : overrides) {
        const auto [other_tables, other_key] = path_of(other);
        if (other != assignment && other_tables == tables && scene::gives_the_same(key, other_key)) {
            throw CLI::ValidationError(
                printable(fmt::format("'{}' and '{}' give one key two values; give it once", other, assignment)));
        }
    }
}

void add_set(CLI::App& command, std::vector<std::string>& overrides, const std::string& help) {
    command.add_option("--set", overrides, help)
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false)
        ->each([given = std::vector<std::string>()](const std::string& assignment) mutable {
            refuse_second_value(given, assignment);
            given.push_back(assignment);
        });
}

}  // namespace riprap
