// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/particle_scheme.hpp"
#include "riprap/fluid/sph/kick_loops.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::fluid {

/// A scheme of SPH: the limits of its step and the books of its kick. The step is symplectic for the acoustic system
/// (position Verlet): density is known half a step behind.
///
///     rho_(n+1/2) = rho_(n-1/2) + (dt_(n-1) + dt_n)/2 R(x_n, v_n)            update_density, walls at t_n
///     x_(n+1/2)   = x_n + dt/2 v_n                                           drift
///     v_(n+1)     = v_n + dt a(x_(n+1/2), rho_(n+1/2), v_n), and shifting    begin_forces, load_walls and kick,
///                   of places; the density that it takes goes at the next    walls at t_n + dt/2
///                   update
///     x_(n+1)     = x_(n+1/2) + dt/2 v_(n+1)                                 drift
///
/// so loads on solids are known at mid-step, where solids are kicked too.
class Sph : public ParticleScheme {
 public:
    explicit Sph(const SphSettings& settings) : settings_(settings) {}
    FluidTimeStep limit(const ParticleState& state) const override;

 protected:
    /// Books what a kick added up.
    void book_kick(std::int64_t count, const Vec3& gravity, double dt, const KickSums& sums,
                   ParticleReport& report) const;
    /// Books the energy of compression at the densities that the forces saw.
    void book_compression(const ParticleState& state, ParticleReport& report) const;

    SphSettings settings_;
};

}  // namespace riprap::fluid
