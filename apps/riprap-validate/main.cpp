// SPDX-License-Identifier: Apache-2.0
// `riprap validate`: the program of `riprap` with the published cases in it.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "built_in.hpp"
#include "riprap/core/error.hpp"
#include "riprap/run/drive/find_case.hpp"
#include "riprap/validation/result.hpp"
#include "riprap/validation/validate.hpp"
#include "riprap/view/validation_report.hpp"

namespace {

using namespace riprap;

/// Validates and writes one page with every result into a folder.
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

int validate(const validation::ValidateOptions& options, const std::string& report) {
    return report.empty() ? validation::validate_main(options) : validate_with_report(options, report);
}

std::vector<ListedCase> published() {
    const std::vector<run::KnownCase> files = run::known_cases("validation");
    std::vector<ListedCase> cases;
    for (const validation::ValidationCase& one : validation::all_cases()) {
        ListedCase listed{fmt::format("{}/{}", one.suite, one.name), std::string(one.title), "", one.is_long};
        const auto file = std::find_if(files.begin(), files.end(),
                                       [&listed](const run::KnownCase& known) { return known.name == listed.name; });
        listed.file = file == files.end() ? "" : file->file.string();
        cases.push_back(std::move(listed));
    }
    return cases;
}

}  // namespace

int main(int argument_count, char** arguments) {
    return run_program({argument_count, arguments}, {.validate = validate, .published = published});
}
