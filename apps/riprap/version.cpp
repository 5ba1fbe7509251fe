// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "riprap/run/folder/provenance.hpp"

namespace riprap {

int print_version(bool as_json) {
    if (as_json) {
        const nlohmann::ordered_json answer{{"build", nlohmann::ordered_json::parse(run::build_json())},
                                            {"machine", nlohmann::ordered_json::parse(run::machine_json())}};
        fmt::print("{}\n", answer.dump(2));
        return 0;
    }
    const run::BuildInfo build = run::build_info();
    fmt::print("riprap {}{} ({}, {}, -march={}, {}{})\n", build.version,
               build.commit.empty() ? "" : " at " + build.commit, build.compiler, build.build_type, build.march,
               build.parallel, build.has_assertions ? ", assertions" : "");
    return 0;
}

}  // namespace riprap
