// SPDX-License-Identifier: Apache-2.0
#pragma once

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
    Vec3 place, normal;  ///< world
};
inline constexpr std::int32_t still_solid = -1;

/// What joins two members i and j, with faces as they are and brought together, see JointPressure.
struct JointLink {
    Vec3 apart, closed;             ///< x_i - x_j, and the same + s n_ij [m]
    double slope, slope_of_closed;  ///< (dW/dr)/r of both
};

/// Which samples of different solids are within the support of each other, faces brought together by up to a spacing.
/// Kept from step to step while no sample has moved a quarter of a spacing; no result depends on when they were found.
class JointPairs {
 public:
    /// How far it looks; periods of the domain must be at least twice that [m].
    /// @param has_driven  some body is driven: what it shuts off is looked for too
    static double reach(const fluid::SphSettings& settings, bool has_driven);

    /// Brings members and pairs up to date with where samples are.
    void update(const SampleSet& near, const JointSolids& solids, const BodyMotion& motion,
                const fluid::BoundaryParticles& walls, const fluid::SphSettings& settings);
    /// Call where `near` is no longer the same.
    void forget() { paired_at_.clear(); }

    /// Ascending by sample.
    const std::vector<JointMember>& members() const { return members_; }
    /// f(j, link) for the members j of other solids that member i meets, ascending.
    template <class F>
    void for_each_link(const SampleSet& near, const fluid::SphSettings& settings, std::size_t i, const F& f) const {
        const Sums sums{fluid::WendlandC2(settings.smoothing_length(), settings.domain.dimension),
                        fluid::NearestImage(settings.domain), settings.support_radius(), settings.spacing};
        for (auto k = static_cast<std::size_t>(pair_begin_[i]); k < static_cast<std::size_t>(pair_begin_[i + 1]); ++k) {
            const auto j = static_cast<std::size_t>(pairs_[k]);
            const JointLink link = link_of(near, sums, members_[i], members_[j]);
            if (link.slope != 0 || link.slope_of_closed != 0) {
                f(j, link);
            }
        }
    }
    std::size_t bytes() const;

 private:
    /// What links are found with, made once for many.
    struct Sums {
        fluid::WendlandC2 kernel;
        fluid::NearestImage nearest;
        double kernel_reach, spacing;  ///< [m]
    };
    static JointLink link_of(const SampleSet& near, const Sums& sums, const JointMember& i, const JointMember& j);
    bool is_up_to_date(const SampleSet& near, const JointSolids& solids, const fluid::BoundaryParticles& walls,
                       double spacing) const;
    void find_members(const SampleSet& near, const JointSolids& solids, const fluid::BoundaryParticles& walls,
                      const fluid::SphSettings& settings);
    void place_members(const SampleSet& near, const BodyMotion& motion, const fluid::BoundaryParticles& walls);
    void find_pairs(const fluid::SphSettings& settings);

    std::vector<JointMember> members_;
    std::vector<std::int64_t> pair_begin_;  ///< of each member in pairs_, one more at the end
    std::vector<std::int32_t> pairs_;       ///< members of other solids, ascending
    std::vector<Vec3> paired_at_;           ///< places of all samples then; empty = nothing found yet [m]
};

}  // namespace riprap::coupling
