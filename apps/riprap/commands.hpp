// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace riprap {

// One function per subcommand that is more than a call into riprap::run. All return the exit code.

int print_version(bool as_json);

/// The cases and suites that `riprap run` and `riprap validate` find by name.
int print_list(bool as_json);

/// Everything about a case short of stepping. With `as_json` a bad case is an answer as well: its problems, and the
/// exit code for a bad case.
int print_check(const std::string& case_text, const std::vector<std::string>& overrides, bool as_json);

}  // namespace riprap
