// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "riprap/core/quat.hpp"
#include "riprap/core/vec3.hpp"
#include "riprap/geometry/polyhedra/convex_view.hpp"

namespace riprap::coupling {

/// The solid about one particle, a union of convex parts, and whether the particle goes through it within a step.
///
/// A place x in the solid belongs to the side where the open water nearest to it lies. With w(x) the vector from x to
/// that water, a way from x_a to x_b through the solid is a passage where it changes sides,
///
///     w_a . w_b < 0,   L > 2 |way|,   and   n_a . n_b < -1/2   or   L > 2 max(|w_a|, |w_b|) / sin(phi),
///
/// n = w/|w|, and L the distance from the middle of the way to the end of the solid along n_a + n_b. Two faces that
/// meet in an edge at the angle 2 phi, sin(phi) = |n_a + n_b|/2, have L = |w|/sin(phi): a particle that goes around an
/// edge, a tip or the end of a plate is none, nor is one that cuts the corner of a block. Where walls meet, the faces
/// on which they meet are inside and separate no sides.
///
/// The side depends on the place alone: a wall that is crossed in many small steps is gone through in that step which
/// takes the particle past its middle.
class SolidAround {
 public:
    /// @param slack   gaps up to twice as wide between two parts are shut [m]
    /// @param within  parts up to this distance from the particle are added: water farther away is not looked for [m]
    SolidAround(double slack, double within) : slack_(slack), open_(1.001 * slack), within_(within) {}

    /// Adds a part.
    /// @param x    place of the particle, of its image that is beside the part, at the end of its way [m]
    /// @param way  of the particle relative to the part, translation alone [m]
    void add(const geometry::ConvexView& shape, const Pose& pose, const Vec3& x, const Vec3& way);

    bool is_gone_through() const;

 private:
    class Search;
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    /// Face of a part, from the particle.
    struct Face {
        Vec3 normal;   ///< out of the part [-]
        double depth;  ///< of the particle below it at the end of its way [m]
        double rate;   ///< of which it was deeper at the beginning [m]
        std::int32_t part;
        bool is_internal;  ///< to a body: no water there

        double depth_at(double s) const { return depth + (1 - s) * rate; }
    };
    /// Share of the way on which the particle is in the solid.
    struct Stretch {
        double begin, end;
        bool is_met;  ///< without the slack
    };

    std::optional<Stretch> stretch_in(std::int32_t part, double slack) const;
    std::vector<Stretch> stretches() const;
    bool holds(std::int32_t part, double s, const Vec3& place) const;
    bool is_open(double s, const Vec3& place) const;
    std::optional<Vec3> nearest_water(double s) const;
    double end_of_solid(double s, const Vec3& direction) const;
    bool changes_sides(double from, double to, const Vec3& before, const Vec3& after) const;

    double slack_, open_;  ///< beyond a face the solid ends at slack_; open_ is just outside of it [m]
    double within_;
    double way_{0};  ///< the longest, relative to a part [m]
    std::vector<Face> faces_;
    std::vector<std::int32_t> begin_{0};  ///< of each part in faces_, one more at the end
};

}  // namespace riprap::coupling
