// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/coupling/rigid_map.hpp"
#include "riprap/coupling/sample_set.hpp"
#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::coupling {

/// Who takes part in joints.
struct JointSolids {
    std::span<const std::uint8_t> is_still;  ///< per body: never moves
    std::span<const std::uint8_t> is_loose;  ///< per body: forces move it, now or once it is released
};

/// Pressure of the water in joints: between faces so close that no particle of water comes between them, a block on the
/// floor or on another block, water stands all the same and presses them apart. Without it a block that lies on
/// something feels no uplift (docs/theory/coupling.md, 6).
///
/// Where the support of a sample of one solid holds samples of another, those stand for the water of the joint:
///
///     f_i = -V_i sum_j V_j (p_i + p_j) (grad W(d) + (u_i + u_j)/2 (grad W(d + s n_ij) - grad W(d))),  d = x_i - x_j,
///
/// i and j of different solids, at least one of them loose: what water in place of j would do, opposite for both sides.
/// The second term brings faces that look at each other, n_i . n_j < -1/2, together along
/// n_ij = (n_i - n_j)/|n_i - n_j|, s being the gap between them up to dp, from there on 2 dp less the gap and at last
/// 0; so a block that lifts off is not held down while no particle fits under it yet. u, from 1 to 0, is what the water
/// found in the joint leaves to do: 1 + n . G_water/(n . G_solid).
///
/// p is that of steady flow through an even joint, which is harmonic in it: from its rim r, where the solid ends,
///
///     p_i = max(0, sum_r w_r c_r (p_r + rho_0 g . (x_i - x_r)) / sum_r w_r),   w_r = s_r V_r/|x_i - x_r|^(D-1),
///
/// exact for a joint that is a line (linear between its ends) or a disk (Poisson's formula). G_solid and G_water are
/// the sums of V grad W at a sample over its own solid and over the water. With t the part along the face of that over
/// all solids, s_r = max(0, h |t| - 0.1) says how much of a rim r is, 0.1 being more than uneven samples leave inside;
/// c_r = -t . G_water/(0.85 t^2), from 0 to 1, how much of what is open there is water (moving water leaves up to 15
/// %); p_r is the mean of the water about r.
class JointPressure {
 public:
    /// Forces on the samples `near` where `walls` are. Zero where nothing is loose or no joint is wet.
    /// @param slopes   of solid_slopes, for each of `near`
    /// @param water    at each of `walls`, beginning with those of `near`
    /// @param gravity  [m/s^2]
    /// @param force    one for each of `near` [N]; empty when all are zero
    void find(const SampleSet& near, std::span<const Vec3> slopes, const JointSolids& solids, const BodyMotion& motion,
              const fluid::BoundaryParticles& walls, const fluid::WaterAtWalls& water,
              const fluid::SphSettings& settings, const Vec3& gravity, std::vector<Vec3>& force);

    /// Forgets what it keeps of the samples: call where `near` is no longer the same.
    void forget() { paired_at_.clear(); }

    std::size_t bytes() const;

 private:
    /// A sample that has, or soon may have, samples of other solids within its support.
    struct Member {
        std::int32_t sample, solid;
        Vec3 place, normal;  ///< world
        Vec3 rim;            ///< t [1/m]
        double dry_share;    ///< u [-]
    };
    /// That member as part of the joint with one of those solids.
    struct Side {
        std::int32_t member, other;
        double pressure;
    };
    /// What joins two members, d = x_i - x_j.
    struct Link {
        Vec3 d, closed;                 ///< as they are and with their faces brought together [m]
        double slope, slope_of_closed;  ///< (dW/dr)/r of both
    };

    bool has_pairs_for(const SampleSet& near, const JointSolids& solids, const fluid::BoundaryParticles& walls,
                       double spacing) const;
    void find_members(const SampleSet& near, const JointSolids& solids, const fluid::BoundaryParticles& walls,
                      const fluid::SphSettings& settings);
    void find_pairs(const SampleSet& near, const JointSolids& solids, const fluid::SphSettings& settings);
    void place_members(const SampleSet& near, const BodyMotion& motion, const fluid::BoundaryParticles& walls);
    void find_sides(const SampleSet& near, std::span<const Vec3> slopes, const BodyMotion& motion,
                    const fluid::WaterAtWalls& water, const fluid::SphSettings& settings);
    void find_pressures(const SampleSet& near, const fluid::WaterAtWalls& water, const fluid::SphSettings& settings,
                        const Vec3& gravity);
    double pressure_of(std::size_t member, std::int32_t other) const;
    /// f(j, link) for the members j that member i meets within the support, ascending.
    template <class F>
    void for_each_link(const SampleSet& near, const fluid::SphSettings& settings, std::size_t i, const F& f) const;

    // Kept from step to step while nothing has moved half a spacing; no result depends on when they were found.
    std::vector<Member> members_;           ///< ascending by sample
    std::vector<std::int64_t> pair_begin_;  ///< of each member in pairs_, one more at the end
    std::vector<std::int32_t> pairs_;       ///< members of other solids, ascending
    std::vector<Vec3> paired_at_;           ///< places of all samples then; empty = nothing found yet [m]

    std::vector<std::int32_t> side_begin_;  ///< of each member in sides_, one more at the end
    std::vector<Side> sides_;
};

}  // namespace riprap::coupling
