// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "riprap/body/motion.hpp"
#include "riprap/coupling/samples/sample_set.hpp"
#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"

namespace riprap::coupling {

struct JointSolids;

/// Pressure of the water in joints: between faces so close that no particle of water comes between them, a block on the
/// floor or on another block, water stands all the same and presses them apart. Without it a block that lies on
/// something feels no uplift (docs/theory/coupling.md, 6).
///
/// Where the support of a sample of one solid holds samples of another, those stand for the water of the joint:
///
///     f_i = -V_i sum_j V_j (p_i + p_j) (grad W(d) + (u_i + u_j)/2 (grad W(d + s n_ij) - grad W(d))),  d = x_i - x_j,
///
/// i and j of different solids, at least one of them loose: what water in place of j would do, opposite for both sides.
/// The second term brings opposite faces, n_i . n_j < -1/2, together along
/// n_ij = (n_i - n_j)/|n_i - n_j|, s being the gap between them up to dp, from there on 2 dp less the gap and at last
/// 0; so a block that lifts off is not held down while no particle fits under it yet. u, from 1 to 0, is the share of p
/// that particles found in the joint do not bring: 1 - (1 - u_room) max(1, p_water/p) with the share u_room of the room
/// that they leave (JointWater::dry_share), so that the face feels p in all, whatever their own pressure is.
///
/// p follows from the rim r, where the solids end, by a mean that is exact for steady flow along a joint that is a line
/// (linear between its ends) or a disk (Poisson's formula) of even opening:
///
///     p_i = max(0, sum_r w_r c_r (p_r + rho_0 g . (x_i - x_r)) / sum_r w_r (c_r + e_r (1 - c_r))),
///     w_r = s_r V_r/(|x_i - x_r|^2 + dp^2/4)^((D-1)/2).
///
/// s_r = a_r max(0, h |t| - 0.1) says how much of a rim a sample r of the first layer is, t being the part along the
/// face of the sum of V grad W over all solids and a_r the factor of even_rim; c_r = -t . G_water/(0.85 t^2), from 0 to
/// 1, how much of what is open there is water; e_r is 1 where the head of some water at the rim reaches r and 0 where
/// it does not: a dry rim above the water of an upright joint takes nothing from it. p_r is the mean of what walls feel
/// about r.
class JointPressure {
 public:
    JointPressure();
    ~JointPressure();
    JointPressure(JointPressure&&) noexcept;
    JointPressure& operator=(JointPressure&&) noexcept;

    /// Forces on the samples `near` where `walls` are.
    /// @param slopes   of solid_slopes, for each sample of the set that `near` looks at
    /// @param water    at each of `walls`, beginning with those of `near`
    /// @param gravity  [m/s^2]
    /// @param is_plain  sums in double instead of float
    /// @param force     one for each of `near` [N]; empty where nothing is loose or no joint is wet
    void find(const SampleView& near, std::span<const Vec3> slopes, const JointSolids& solids,
              const body::Motion& motion, const fluid::BoundaryParticles& walls, const fluid::WaterAtWalls& water,
              const fluid::ParticleSettings& settings, const Vec3& gravity, bool is_plain, std::vector<Vec3>& force);

    /// Call where `near` is no longer the same.
    void forget();

    std::size_t bytes() const;

 private:
    struct Work;
    std::unique_ptr<Work> work_;
};

}  // namespace riprap::coupling
