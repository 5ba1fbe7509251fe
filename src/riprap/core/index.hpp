// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace riprap {

/// A signed index as the standard containers want it: `x[at(i)]`. Indices are signed here, so that differences and
/// "none" (-1) need no care; this is the one place where the sign is given up.
constexpr std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

}  // namespace riprap
