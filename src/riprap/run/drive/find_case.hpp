// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace riprap::run {

/// A case or a suite of cases that comes with Riprap.
struct KnownCase {
    std::string name;    ///< as `riprap run` takes it: "hello_block", "zhao/sliding"
    std::string title;   ///< of the case file; empty where it has none
    std::string source;  ///< publication that it is taken from; empty where it names none
    std::filesystem::path file;
};

/// One more folder for case_roots(), the last: where a package has put its examples. Not while others look for cases.
void add_case_root(const std::filesystem::path& folder);

/// Folders that may hold `cases/` and `validation/`: the working folder, the installed share beside the program,
/// for a program run from its build tree, the source tree, and what add_case_root gave.
std::vector<std::filesystem::path> case_roots();

/// The case file that the command line means by `text`: a file, a folder with a case.toml, or the name of a known
/// case, with or without `cases/` or `validation/` before it. @throws FileError that names the nearest cases
std::filesystem::path find_case(const std::string& text);

/// A short name for the run folder of a case: that of its folder, or of its file where that is not case.toml.
std::string short_name(const std::filesystem::path& case_file);

/// Cases below `cases/` or `validation/` of all roots, sorted by name; of equal names that of the first root.
std::vector<KnownCase> known_cases(const std::string& collection);

}  // namespace riprap::run
