// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/fluid/particle/sweep/fixed_point.hpp"
#include "riprap/fluid/particle/sweep/lanes.hpp"

namespace riprap::fluid {

/// Box around the ways of some particles [m]: least x, y, z, nothing, and the greatest with their signs turned.
using Motion = FloatEight;
/// Of no particles at all.
Motion no_motion();
inline Motion join(Motion a, Motion b) { return a < b ? a : b; }
/// The most by which a particle of one set and one of the other may have come closer [m].
float approach(Motion a, Motion b);

/// Box around the ways that some particles have gone, a sum over placements [m].
struct Travel {
    Vec3 low{}, high{};
};
/// Returns the box around ways from one sum to a later one.
Motion motion_between(const Travel& then, const Travel& now);

/// Particles in clusters of four that follow each other in the State. Entry [cluster][axis][member]; the last cluster
/// is filled up with copies of the last particle.
class ClusterPlaces {
 public:
    /// Clusters whose motion is kept together: a block of BoxTree.
    static constexpr std::int64_t block_size = lane_count;

    void update(std::span<const Vec3> position, const FixedPoint& fixed, int dimension);
    /// Ways of the particles of each block since they were first placed as they are numbered now. A sum of boxes holds
    /// the box of the sums, so no places of former updates are kept.
    const std::vector<Travel>& travels() const { return travels_; }
    /// Number of the first placement since which travels() are known: another one where particles came, went or were
    /// counted anew.
    std::int64_t known_since() const { return known_since_; }
    /// Number of placements.
    std::int64_t updates() const { return updates_; }

    /// Returns whether the first, the middle and the last particle were placed at these positions.
    bool is_at(std::span<const Vec3> position) const;

    const FixedPoint& fixed() const { return fixed_; }
    std::int64_t size() const { return size_; }
    std::size_t bytes() const;
    std::int64_t cluster_count() const { return (size_ + cluster_size - 1) / cluster_size; }
    std::int64_t block_count() const { return (cluster_count() + block_size - 1) / block_size; }
    /// Four places along each axis in turn.
    const std::int32_t* cluster(std::int64_t c) const { return &places_[static_cast<std::size_t>(c * stride_)]; }

 private:
    template <int Dim>
    Motion place_block(std::span<const Vec3> position, std::int64_t block, bool is_comparable);

    std::vector<Travel> travels_;
    std::vector<std::int32_t> places_;
    std::int64_t size_{0}, stride_{0};
    std::int64_t updates_{0}, known_since_{0};
    FixedPoint fixed_;
};

}  // namespace riprap::fluid
