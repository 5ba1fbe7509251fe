// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/scene/text/value.hpp"

namespace riprap::scene {

/// Writes out entries of `root` that stand for several: a [[output.probe]] with a list of quantities, and a
/// [[output.gauge]] with a `count`, as so many entries of their own.
Value expand_records(Value root, std::vector<Diagnostic>& problems);

}  // namespace riprap::scene
