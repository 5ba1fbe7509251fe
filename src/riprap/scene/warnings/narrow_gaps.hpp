// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/core/ids.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::scene {

/// Gaps that are too wide for a joint and too narrow for particles, which come in one by one, so that the forces on
/// the bodies beside them are noisy (docs/theory/coupling.md, 6).
struct NarrowGaps {
    std::int64_t pairs{0};           ///< of convex parts
    double narrowest{0}, widest{0};  ///< [spacings]
    BodyId a, b;                     ///< of the first pair
};

/// Faces a quarter of a spacing to two apart that face each other, of bodies that water wets, one of which at least
/// is free or will be released. The case has water.
NarrowGaps find_narrow_gaps(const sim::Model& model, const sim::State& state);

/// Faces that touch, of two bodies that no force moves: particle methods take such bodies for one solid, without water
/// in the joint (docs/theory/coupling.md, 6).
struct HeldJoint {
    BodyId body, other;
};

/// First such joint of each fixed or driven body whose load by water is recorded or judged: the load lacks what water
/// in the joint would do, its uplift. Faces count that are a quarter of a spacing apart or less, or as deep in each
/// other. Empty where the water is no particles.
std::vector<HeldJoint> find_held_joints(const sim::Model& model, const sim::State& state);

}  // namespace riprap::scene
