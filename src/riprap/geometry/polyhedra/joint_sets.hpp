// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/geometry/polyhedra/outcome.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry {

/// Upward unit normal of a joint given as geologists do: x = east, y = north, z = up; `dip` is the angle below the
/// horizontal of the steepest line in the plane, 0 to pi/2; `dip_direction` is the azimuth of that line, clockwise
/// from north [rad]:
///
///     n = (sin a sin d, cos a sin d, cos d),    a = dip_direction, d = dip.
///
/// The steepest line itself points along (sin a cos d, cos a cos d, -sin d).
Vec3 joint_normal(double dip, double dip_direction);

/// A family of parallel joints. Joint k lies where normal . (x - origin) = offset + s_1 + ... + s_k (for k < 0 minus
/// the sum of as many spacings), s_k uniform in spacing * [1 - scatter, 1 + scatter].
struct JointSet {
    Vec3 normal;                  ///< unit normal [-], see joint_normal
    double spacing{1.0};          ///< mean distance of neighbouring joints along the normal [m]
    double spacing_scatter{0.0};  ///< 0 <= scatter < 1 [-]; 0 = all spacings equal
    Vec3 origin{};                ///< a point from which offsets count [m]
    double offset{0.0};           ///< distance of joint 0 from the origin, along the normal [m]
    /// Probability that a joint cuts a block that it meets [-]. A joint cuts a block through or not at all, since
    /// blocks stay convex; a persistence p leaves intact rock bridges over a share 1 - p of each joint on average.
    double persistence{1.0};
};

/// Options of the cutting of a rock mass, and its limits.
struct JointingOptions {
    std::uint64_t seed{0};  ///< decides scatter and persistence; same seed, same blocks
    /// A joint that would cut a piece smaller than this off a block leaves that block whole [m^3]. Every block is then
    /// at least this large, and stays convex. 0: every cut is made (down to cut_tolerance).
    double minimum_volume{0.0};
    std::int64_t maximum_blocks{1'000'000};  ///< more are refused
};

/// Blocks between joints.
struct JointedRock {
    std::vector<Polyhedron> blocks;
    std::int64_t joint_count{0};   ///< joints that meet the region
    std::int64_t skipped_cuts{0};  ///< cuts left out because of minimum_volume
    double smallest_volume{0.0};   ///< volume of the smallest block [m^3]
    std::int32_t smallest_block{0};
};

/// Cuts a convex region by joint sets, one set after another: a joint of a later set ends at joints of earlier sets
/// only where persistence makes it. Volume is conserved to round-off, faces between neighbours coincide. Deterministic:
/// whether a joint cuts a block depends on the seed, the joint and the earlier cuts of that block alone.
/// Refuses what is not finite, out of range, or would take more than maximum_blocks.
Outcome<JointedRock> cut_by_joint_sets(const Polyhedron& region, std::span<const JointSet> sets,
                                       const JointingOptions& options);

}  // namespace riprap::geometry
