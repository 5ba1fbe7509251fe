// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace riprap::scene {

// Everything below is made from the one key table that also checks cases.

/// JSON Schema (draft 2020-12) of the case file: `riprap schema`.
std::string case_schema();

/// The reference page docs/reference/case-file.md, complete.
std::string case_manual();

/// Keys as plain text for a terminal, one line each, in the order of the manual; `prefix` selects (for example
/// "body" or "solid."); empty = all.
std::string key_listing(const std::string& prefix = "");

}  // namespace riprap::scene
