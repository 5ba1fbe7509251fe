// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "riprap/body/body_set.hpp"

namespace riprap::body {

/// Tells whether forces move a body, now or from its release on.
inline bool may_move(const BodySet& bodies, std::size_t body) {
    return bodies.drive[body] == Drive::free || std::isfinite(bodies.release_time[body]);
}

}  // namespace riprap::body
