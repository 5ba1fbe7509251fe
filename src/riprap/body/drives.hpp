// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/body/body_set.hpp"

namespace riprap::body {

/// Moves the correction that a fluid makes to a driven body, as an absorbing paddle's, over `dt` at the rate that the
/// fluid has set. Every solid method does so once over each of its steps, and adds the correction to the pose of the
/// motion that is given.
inline void advance_correction(BodyState& state, std::size_t body, double dt) {
    if (!state.drive_offset.empty()) {
        state.drive_offset[body] += dt * state.drive_rate[body];
    }
}

/// Moves the corrections of all bodies.
inline void advance_corrections(BodyState& state, double dt) {
    for (std::size_t b = 0; b < state.drive_offset.size(); ++b) {
        advance_correction(state, b, dt);
    }
}

}  // namespace riprap::body
