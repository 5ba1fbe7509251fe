// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "riprap/core/error.hpp"

namespace riprap::scene {

/// Refuses texts that a TOML parser should not see; see parse_toml. Appends at most one problem.
void scan_toml(std::string_view text, const std::string& name, std::vector<Diagnostic>& problems);

/// Length of the valid UTF-8 sequence at the front of `text`; 0 when it is none (overlong forms, surrogates and code
/// points above U+10FFFF are none).
int utf8_length(std::string_view text);

}  // namespace riprap::scene
