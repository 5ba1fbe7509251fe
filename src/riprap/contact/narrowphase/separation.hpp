// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/narrowphase/distance_potential.hpp"

namespace riprap::contact {

/// A pair counts as apart without a closer look where a direction separates it by more than this fraction of its
/// size. It is far above the round-off that could give the full computation a piece of overlap (1e-14, over the sine
/// of half the sharpest angle between faces), so a rejection never changes a result.
inline constexpr double separation_margin = 1e-9;

/// Width of the gap between A and B along `direction` (from A to B, in the world, any length) [m x |direction|].
/// Neither may be a half-space.
double gap_along(const geometry::ConvexView& a, const Frame& frame_a, const geometry::ConvexView& b,
                 const Frame& frame_b, const Vec3& direction);

/// True where spheres or the remembered direction show a gap wide enough that a full look would find nothing. Neither
/// may be a half-space.
bool is_surely_apart(const geometry::ConvexView& a, const Frame& frame_a, const geometry::ConvexView& b,
                     const Frame& frame_b, const SeparatingCache& cache);

/// Looks for a separating direction by reflecting a trial direction at the support points it finds; `start` need not
/// separate. @returns a unit direction in the world, or zero when none was found soon: the next step looks again.
Vec3 find_separating_direction(const geometry::ConvexView& a, const Frame& frame_a, const geometry::ConvexView& b,
                               const Frame& frame_b, const Vec3& start);

}  // namespace riprap::contact
