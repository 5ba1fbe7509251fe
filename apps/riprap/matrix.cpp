// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "commands.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/run/drive/find_case.hpp"

namespace riprap {

int print_matrix(run::MatrixOptions options, bool as_json) {
    options.case_path = run::find_case(options.case_path).string();
    bool is_first = true;
    const run::MatrixResult result = run::run_matrix(options, [&](const run::MatrixEntry& entry) {
        if (!as_json) {
            if (is_first) {
                fmt::print("{}\n", run::matrix_heading());
            }
            fmt::print("{}\n", printable(run::matrix_line(entry)));
            std::fflush(stdout);
        }
        is_first = false;
    });
    fmt::print("{}\n", as_json ? run::matrix_json(result) : run::matrix_counts(result.entries));
    const bool has_wrong = std::any_of(result.entries.begin(), result.entries.end(), [](const run::MatrixEntry& entry) {
        return entry.finding == run::Finding::wrong;
    });
    return static_cast<int>(has_wrong ? ExitCode::failed : ExitCode::success);
}

}  // namespace riprap
