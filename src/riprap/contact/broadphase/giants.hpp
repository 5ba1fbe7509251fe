// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/contact/broadphase/broadphase.hpp"

namespace riprap::contact {

/// Parts that should be treated as giants, in increasing order. Every part of infinite radius is one. Besides, with
/// the finite radii sorted downwards R_1 >= R_2 >= ..., parts 1..m are giants for the largest m <= 16 with
///
///     R_m >= 4 R_(m+1):
///
/// a few parts set apart from the rest by a wide gap, such as a platform and its walls among blocks. Equal bodies have
/// no gap; nor has a continuous grading, however wide. The rule only decides how a part is searched for; which
/// contacts are found does not depend on it.
std::vector<std::int32_t> choose_giants(std::span<const double> radius);

/// Face planes of all giants in world axes, for tests against bounding spheres.
class GiantPlanes {
 public:
    /// Reads the giants as they stand now. Buffers are kept.
    void assign(const PartBounds& bounds, std::span<const Giant> giants);

    std::int32_t size() const { return static_cast<std::int32_t>(part_.size()); }
    std::int32_t part(std::int32_t giant) const { return part_[static_cast<std::size_t>(giant)]; }

    /// No face plane of the giant separates it from the ball of radius `reach` about `point` [m]:
    /// h_j(point) > -reach for all faces j, and the ball meets the giant's bounding sphere. The second costs little
    /// and clears the regions beyond sharp edges, where the planes alone let far points pass.
    bool is_within(std::int32_t giant, const Vec3& point, double reach) const {
        const auto g = static_cast<std::size_t>(giant);
        const Vec3 from_origin = point - origin_[g];
        const double sphere_reach = radius_[g] + reach;
        if (!(norm_squared(from_origin) < sphere_reach * sphere_reach)) {
            return false;
        }
        for (std::size_t f = face_begin_[g]; f < face_begin_[g + 1]; ++f) {
            if (!(offset_[f] - dot(normal_[f], from_origin) > -reach)) {
                return false;
            }
        }
        return true;
    }

    /// Bounds how far a part's ball may have come closer to the giant since `before` was assigned, parts at rest [m]:
    ///
    ///     D = max(|o' - o|, max_j |h'_j(c) - h_j(c)| + |n'_j - n_j| rho),
    ///
    /// where primes mark this state, o is the bounding sphere's centre, and all part centres that matter lie within rho
    /// of c. Exact for a translation across a plane, and an upper bound for a turn: h'_j - h_j is affine with gradient
    /// n_j - n'_j. The first term is left out for half-spaces, which may slide along themselves for nothing.
    ///
    /// @param center, radius  c and rho: a ball around the centres of all parts now [m]
    /// @param largest_guest   radius of the largest finite part that may pair with the giant [m]; a finite giant only
    ///                        meets parts centred within its own radius plus this, used where it is the better ball
    double displacement_since(const GiantPlanes& before, std::int32_t giant, const Vec3& center, double radius,
                              double largest_guest) const;

    /// All planes and origins are as in `other`.
    bool is_at_rest(const GiantPlanes& other) const;

 private:
    double plane_change(const GiantPlanes& before, std::size_t giant, const Vec3& center, double radius) const;

    std::vector<std::int32_t> part_;
    std::vector<Vec3> origin_;             ///< centre of the bounding sphere; of a half-space, its frame's origin [m]
    std::vector<double> radius_;           ///< of the bounding sphere [m]
    std::vector<std::size_t> face_begin_;  ///< size() + 1 entries
    std::vector<Vec3> normal_;             ///< outward, world axes [-]
    std::vector<double> offset_;           ///< h(x) = offset - normal . (x - origin) [m]
};

/// May the two parts meet, one or both of them giants? A finite part is a ball to the other's planes. Two half-spaces
/// never meet: neither moves freely.
/// @param giant_a, giant_b  number of the giant in `planes`, -1 for an ordinary part
inline bool giant_within(const GiantPlanes& planes, const PartBounds& bounds, std::int32_t giant_a, std::int32_t a,
                         std::int32_t giant_b, std::int32_t b, double skin) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    return may_pair(bounds, i, j) &&
           (giant_a < 0 || planes.is_within(giant_a, bounds.center[j], bounds.radius[j] + skin)) &&
           (giant_b < 0 || planes.is_within(giant_b, bounds.center[i], bounds.radius[i] + skin));
}

}  // namespace riprap::contact
