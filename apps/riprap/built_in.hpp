// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace riprap::validation {
struct ValidateOptions;
}
namespace riprap::bench {
struct BenchOptions;
}

namespace riprap {

/// A case that `riprap list` shows.
struct ListedCase {
    std::string name, title, file;  ///< the file is empty where the case is built in code
    bool is_long{false};            ///< only run when asked for by name or with --full
};

/// Work that a program does itself. Validation and benches are half of the code and have programs of their own,
/// `riprap-validate` and `riprap-bench`, beside `riprap`: an empty function stands for starting that program.
struct BuiltIn {
    /// `riprap validate`; writes a page into the folder `report` where that is not empty. Returns the exit code.
    std::function<int(const validation::ValidateOptions& options, const std::string& report)> validate{};
    std::function<std::vector<ListedCase>()> published{};  ///< cases of the validation, for `riprap list`
    std::function<int(const bench::BenchOptions& options)> bench{};
};

/// The words of a command line, the name of the program first.
struct Words {
    int count;
    char** words;
};

/// Runs the program `name` beside this one with the same words in its place; in a folder of a build it is built first
/// where it is missing. @throws FileError where it is missing and cannot be built, or does not start
int start_program(const std::string& name, const Words& words);

/// Tells whether start_program has it without building.
bool has_program(const std::string& name);

/// Runs a command line from `main`: every refusal is told on standard error. Returns the exit code.
int run_program(const Words& words, const BuiltIn& built_in);

}  // namespace riprap
