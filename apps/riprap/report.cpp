// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iostream>

#include "commands.hpp"
#include "riprap/core/error.hpp"
#include "riprap/validation/result.hpp"
#include "riprap/validation/validate.hpp"
#include "riprap/view/validation_report.hpp"

namespace riprap {

int validate_with_report(const validation::ValidateOptions& options, const std::filesystem::path& folder) {
    validation::ValidateOptions asked = options;
    asked.results = folder.string();
    const auto write = [&](const std::string& results, bool is_whole) {
        return view::write_validation_report(folder, results, validation::case_folder(options), is_whole);
    };
    // After every case: a validation may take hours, and what stops it may not take the page away.
    std::string results = validation::to_json("all", {});
    asked.after_case = [&write, &results](const std::string& so_far) {
        results = so_far;
        write(so_far, false);
    };
    const int code = validation::validate(asked, validation::all_cases(), std::cout, &std::cerr);
    if (code == static_cast<int>(ExitCode::usage)) {
        return code;
    }
    const std::filesystem::path page = write(results, true);
    if (!options.as_json) {  // a document of its own, else
        fmt::print("{}\n", page.string());
    }
    return code;
}

}  // namespace riprap
