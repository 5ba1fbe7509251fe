// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/fluid/particle/fixed_point.hpp"
#include "riprap/fluid/particle/lanes.hpp"

namespace riprap::fluid {

/// Box around the ways of some particles [m]: least x, y, z, nothing, and the greatest with their signs turned.
using Motion = FloatEight;
/// Of no particles at all.
Motion no_motion();
inline Motion join(Motion a, Motion b) { return a < b ? a : b; }
/// The most by which a particle of one set and one of the other may have come closer [m].
float approach(Motion a, Motion b);

/// Particles in clusters of four that follow each other in the State. Entry [cluster][axis][member]; the last cluster
/// is filled up with copies of the last particle.
class ClusterPlaces {
 public:
    /// Clusters whose motion is kept together: a block of BoxTree.
    static constexpr std::int64_t block_size = lane_count;

    void update(std::span<const Vec3> position, const FixedPoint& fixed, int dimension);
    /// Tells whether there was something to compare with.
    bool is_motion_known() const { return is_motion_known_; }
    /// Ways since remember(), one box per block.
    const std::vector<Motion>& motions() const { return motions_; }
    void remember();

    std::int64_t size() const { return size_; }
    std::size_t bytes() const;
    std::int64_t cluster_count() const { return (size_ + cluster_size - 1) / cluster_size; }
    std::int64_t block_count() const { return (cluster_count() + block_size - 1) / block_size; }
    /// Four places along each axis in turn.
    const std::int32_t* cluster(std::int64_t c) const { return &places_[static_cast<std::size_t>(c * stride_)]; }

 private:
    template <int Dim>
    Motion place_block(std::span<const Vec3> position, std::int64_t block, bool is_comparable);

    std::vector<Motion> motions_;
    bool is_motion_known_{false};
    std::vector<std::int32_t> places_, remembered_;
    std::int64_t size_{0}, stride_{0};
    FixedPoint fixed_, remembered_fixed_;
};

}  // namespace riprap::fluid
