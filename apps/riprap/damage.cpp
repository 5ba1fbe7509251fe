// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/damage/damage_report.hpp"

#include <fmt/format.h>

#include "commands.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/view/read_run.hpp"

namespace riprap {

int print_damage(const std::filesystem::path& folder, const view::DamageRequest& request,
                 const std::filesystem::path& out, bool as_json) {
    const view::RecordedRun run = view::read_run(folder);
    for (const std::string& notice : run.notices) {
        fmt::print(stderr, "riprap: {}\n", printable(notice));
    }
    const view::DamageReport report = view::damage_report(run, request);
    fmt::print("{}", as_json ? view::damage_json(report) + '\n' : view::damage_text(report));
    if (!out.empty()) {
        for (const std::filesystem::path& file : view::write_damage(out, report)) {
            fmt::print(as_json ? stderr : stdout, "{}\n", printable(file.string()));
        }
    }
    return 0;
}

}  // namespace riprap
