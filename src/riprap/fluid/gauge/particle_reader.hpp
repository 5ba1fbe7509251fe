// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/gauge/gauge.hpp"

namespace riprap::fluid {

/// Reads particles, in the order of the State (same bits at any thread count); all readings but those on faces.
///
/// pressure, velocity: moving least squares of first order with the kernel as weight, exact for linear fields also on a
/// wall, where one half of the support is empty; where too few particles lie near, their weighted mean [Liu2006]. Where
/// water hits a wall in single particles, that mean is the pressure in one of them, not what the wall feels.
/// level, flow, volume: with V_j = m/rho_0, what the water takes without the compression that its sound speed, lower
/// than nature's, gives it.
/// level: integral of the water fraction along the vertical, sum_j V_j B(a_j) B(b_j) with a_j, b_j the horizontal
/// distances and B a cubic B-spline one spacing wide: it sees spray and voids as a capacitance gauge does. Within two
/// spacings of a side wall it reads too little. surface, run_up: the fraction sum_j V_j W crosses one half.
/// flow: sum_j V_j (v_j . n) B(s_j), s_j the distance from the plane, over the particles beside the rectangle.
/// volume: of a particle on a side of the box the share that lies in it (BoxShares).
/// centre, mean_velocity: means over the particles, a place as the State has it on a periodic axis.
///
/// Across periodic sides a particle counts where its image lies: the nearest one for sums about a place, all of them
/// for the column of `level`, any one of them, once, for `flow` and `volume`.
class ParticleReader : public WaterReader {
 public:
    ParticleReader(const ParticleSettings& settings, const ParticleState& state) : settings_(settings), state_(state) {}
    double pressure(const Vec3& x) const override;
    Vec3 velocity(const Vec3& x) const override;
    double level(const Vec3& x, const Vec3& up) const override;
    double surface(const Vec3& start, const Vec3& end) const override;
    double run_up(const Vec3& start, const Vec3& end) const override;
    double flow(const Vec3& low, const Vec3& high) const override;
    double volume(const Vec3& low, const Vec3& high) const override;
    Vec3 centre(const Vec3& low, const Vec3& high) const override;
    Vec3 mean_velocity(const Vec3& low, const Vec3& high) const override;

 private:
    std::vector<std::size_t> inside(const Vec3& low, const Vec3& high) const;
    bool is_inside(std::size_t particle, const Vec3& low, const Vec3& high) const;
    /// Mean of a field over the particles in a box; zero without any.
    Vec3 mean_of(const std::vector<Vec3>& field, const Vec3& low, const Vec3& high) const;
    const ParticleSettings& settings_;
    const ParticleState& state_;
};

}  // namespace riprap::fluid
