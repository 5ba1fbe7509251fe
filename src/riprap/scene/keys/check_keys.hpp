// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/scene/keys/key_table.hpp"
#include "riprap/scene/text/value.hpp"

namespace riprap::scene {

/// Checks a tree against the key table and returns it resolved: base names without unit suffixes, numbers in SI,
/// vectors with three components, defaults filled in. Every problem is appended; a value with a problem is left out
/// of the result, so that checking can go on.
/// @param is_planar  vectors may have two components, and a third must be zero (about x and y for spins)
Value check_keys(const Value& root, const Table& table, bool is_planar, std::vector<Diagnostic>& problems);

}  // namespace riprap::scene
