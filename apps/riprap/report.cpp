// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>
#include <sstream>

#include "commands.hpp"
#include "riprap/core/error.hpp"
#include "riprap/validation/validate.hpp"
#include "riprap/view/validation_report.hpp"

namespace riprap {

int validate_with_report(const validation::ValidateOptions& options, const std::filesystem::path& folder) {
    validation::ValidateOptions asked = options;
    asked.as_json = true;
    asked.results = folder.string();
    const auto write = [&](const std::string& results, bool is_whole) {
        return view::write_validation_report(folder, results, validation::case_folder(options), is_whole);
    };
    // After every case: a validation may take hours, and what stops it may not take the page away.
    asked.after_case = [&write](const std::string& so_far) { write(so_far, false); };
    std::ostringstream results;
    const int code = validation::validate(asked, validation::all_cases(), results, &std::cerr);
    if (code == static_cast<int>(ExitCode::usage)) {
        return code;
    }
    const std::filesystem::path page = write(results.str(), true);
    if (options.as_json) {
        fmt::print("{}", results.str());
    } else {
        fmt::print("{}\n", page.string());
    }
    return code;
}

}  // namespace riprap
