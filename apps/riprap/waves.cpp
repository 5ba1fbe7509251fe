// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "commands.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/view/read_run.hpp"
#include "riprap/view/wave_report.hpp"

namespace riprap {

int print_waves(const std::filesystem::path& folder, const view::WaveRequest& request, bool as_json) {
    const view::RecordedRun run = view::read_run(folder);
    for (const std::string& notice : run.notices) {
        fmt::print(stderr, "riprap: {}\n", printable(notice));
    }
    const view::WaveReport report = view::analyse_waves(run, request);
    fmt::print("{}", as_json ? view::wave_json(report) + '\n' : view::wave_text(report));
    return 0;
}

}  // namespace riprap
