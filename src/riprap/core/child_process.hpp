// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace riprap {

/// Streams of a program that is started.
enum class ChildOutput {
    as_ours,  ///< standard output and standard error of this process
    error     ///< all that it prints goes to standard error
};

/// Runs a program, found by PATH where its name has no slash, and waits for its end.
/// @returns its exit code, 128 + n where signal n ended it; nothing where it cannot be started
std::optional<int> run_to_end(std::vector<std::string> words, ChildOutput output = ChildOutput::as_ours);

}  // namespace riprap
