// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::fluid {

struct SphScratchData;

/// Neighbour lists and rates: buffers kept only for speed.
class SphScratch {
 public:
    SphScratch();
    ~SphScratch();
    SphScratch(SphScratch&&) noexcept;
    SphScratch& operator=(SphScratch&&) noexcept;
    SphScratchData& data() { return *data_; }

 private:
    std::unique_ptr<SphScratchData> data_;
};

/// The longest steps that each limit allows [s].
struct FluidTimeStep {
    double acoustic;  ///< courant h / (c_0 + max speed)
    double force;     ///< 0.25 sqrt(h / max acceleration)
    double viscous;   ///< 0.125 h^2 / nu
    double limit;     ///< the least
    const char* reason;
};

/// Energies and losses of the fluid [J], measured at the kick like those of bodies (sim/ledger.hpp).
struct FluidReport {
    double kinetic{0}, potential{0}, internal{0};
    double dissipated_viscous{0};    ///< in this step
    double dissipated_diffusion{0};  ///< in this step, by the diffusion of density
    double shifted{0};               ///< potential energy that shifting took away in this step
    double work_on_solids{0};        ///< in this step
    double wall_exchange{0};  ///< in this step: work of mirrored wall pressure that no body sees (docs/theory/sph.md)
    Vec3 momentum{}, impulse{};  ///< of the fluid [kg m/s]; of gravity and walls in this step [N s]
    double mass{0};              ///< [kg]
    double max_speed{0}, max_acceleration{0};
    std::int64_t worst_particle{-1};  ///< first id that is not finite, too fast or out of the domain
    std::string problem;              ///< why, with particle, place and time
};

// The step is symplectic for the acoustic system (position Verlet): density is known half a step behind.
//
//     rho_(n+1/2) = rho_(n-1/2) + (dt_(n-1) + dt_n)/2 R(x_n, v_n)     update_density, walls at t_n
//     x_(n+1/2)   = x_n + dt/2 v_n                                    drift
//     v_(n+1)     = v_n + dt a(x_(n+1/2), rho_(n+1/2), v_n)           accelerate, walls at t_n + dt/2
//     x_(n+1)     = x_(n+1/2) + dt/2 v_(n+1) + shift                  drift
//
// so loads on solids are known at mid-step, where solids are kicked too.

FluidTimeStep choose_fluid_time_step(const SphSettings& settings, const ParticleState& state);
void update_density(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                    const Vec3& gravity, double dt, SphScratch& scratch, FluidReport& report);
void drift(const SphSettings& settings, ParticleState& state, double dt);
void accelerate(const SphSettings& settings, ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                double dt, double time, SphScratch& scratch, FluidReport& report);

}  // namespace riprap::fluid
