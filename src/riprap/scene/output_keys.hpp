// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace riprap::scene {

/// Quantities of a body that a probe can record.
const std::vector<std::string_view>& probe_quantities();

}  // namespace riprap::scene
