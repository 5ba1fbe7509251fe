// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/scene_builder.hpp"

namespace riprap::validation {

/// Brings a scene that can stand to rest under its present gravity: mass damping c = 0.1/dt for `steps` steps, then
/// none again; what still moves is stopped. A mode ten times slower than the fastest decays by exp(-18) in 2000 steps.
/// A block that friction cannot hold creeps during this with its springs at their limit, and then starts from rest as
/// theory has it.
inline void settle(Trial& trial, int steps = 2000) {
    trial.model().dem()->mass_damping = 0.1 / trial.dt();
    for (int i = 0; i < steps; ++i) {
        trial.step();
    }
    trial.model().dem()->mass_damping = 0;
    const body::BodySet& bodies = trial.model().bodies;
    for (std::int32_t i = 0; i < bodies.size(); ++i) {
        if (body::is_free(bodies, BodyId{i}, trial.time())) {
            trial.state().bodies.velocity[static_cast<std::size_t>(i)] = {};
            trial.state().bodies.angular_momentum[static_cast<std::size_t>(i)] = {};
        }
    }
}

}  // namespace riprap::validation
