// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/coupling/rigid_map.hpp"
#include "riprap/coupling/sample_set.hpp"
#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/cell_grid.hpp"
#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::coupling {

/// Who takes part in joints.
struct JointSolids {
    std::span<const std::uint8_t> is_still;  ///< per body: never moves; all of these are one solid
    std::span<const std::uint8_t> is_loose;  ///< per body: forces move it, now or once it is released
};

/// A sample that may meet those of another solid: all of loose bodies, and of others those near a loose one.
struct JointMember {
    std::int32_t sample;
    std::int32_t solid;  ///< number of the body, or still_solid
    bool is_loose;
    double volume, depth;  ///< of the sample [m^D], [m]
    Vec3 place, normal;    ///< world
};
inline constexpr std::int32_t still_solid = -1;

/// What joins two members i and j, with faces as they are or brought together.
struct JointLink {
    Vec3 apart;    ///< x_i - x_j, or the same + s n_ij, see JointPressure [m]
    double slope;  ///< (dW/dr)/r there; 0 = not in reach
};

/// What links are found with, made once for many.
class JointKernel {
 public:
    explicit JointKernel(const fluid::SphSettings& settings);
    JointLink link(const JointMember& i, const JointMember& j) const {
        const Vec3 apart = nearest_(i.place - j.place);
        const double square = norm_squared(apart);
        return {apart, square < square_of_reach_ ? kernel_.slope_over_r(std::sqrt(square)) : 0};
    }
    /// The same with faces that look at each other brought together.
    JointLink closed(const JointMember& i, const JointMember& j, const JointLink& link) const;

 private:
    fluid::WendlandC2 kernel_;
    fluid::NearestImage nearest_;
    double reach_, square_of_reach_, spacing_;
};

/// Which samples of different solids are within the support of each other, faces brought together by up to a spacing.
/// Kept from step to step while no sample has moved a quarter of a spacing; no result depends on when they were found.
class JointPairs {
 public:
    /// How far it looks; periods of the domain must be at least twice that [m].
    /// @param has_driven  some body is driven: what it shuts off is looked for too
    static double reach(const fluid::SphSettings& settings, bool has_driven);

    /// Brings members and pairs up to date with where samples are.
    void update(const SampleView& near, const JointSolids& solids, const BodyMotion& motion,
                const fluid::BoundaryParticles& walls, const fluid::SphSettings& settings);
    /// Call where `near` is no longer the same.
    void forget() { paired_at_.clear(); }

    /// Ascending by sample.
    const std::vector<JointMember>& members() const { return members_; }
    /// Members of other solids that member i may meet, ascending.
    std::span<const std::int32_t> met_by(std::size_t i) const {
        const auto begin = static_cast<std::size_t>(pair_begin_[i]), end = static_cast<std::size_t>(pair_begin_[i + 1]);
        return {pairs_.data() + begin, end - begin};
    }
    std::size_t bytes() const;

 private:
    bool is_up_to_date(const SampleView& near, const JointSolids& solids, const fluid::BoundaryParticles& walls,
                       double spacing) const;
    void find_members(const SampleView& near, const JointSolids& solids, const fluid::BoundaryParticles& walls,
                      const fluid::SphSettings& settings);
    void place_members(const SampleView& near, const BodyMotion& motion, const fluid::BoundaryParticles& walls);
    void find_pairs(const fluid::SphSettings& settings);

    std::vector<JointMember> members_;
    std::vector<std::int64_t> pair_begin_;  ///< of each member in pairs_, one more at the end
    std::vector<std::int32_t> pairs_;       ///< members of other solids, ascending
    std::vector<Vec3> paired_at_;           ///< places of all samples then; empty = nothing found yet [m]
};

}  // namespace riprap::coupling
