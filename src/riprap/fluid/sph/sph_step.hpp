// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
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
    const SphScratchData& data() const { return *data_; }
    std::size_t bytes() const;

 private:
    std::unique_ptr<SphScratchData> data_;
};

/// The longest steps that each limit allows [s].
struct FluidTimeStep {
    double acoustic;  ///< courant h / (c + max speed), c at the highest density
    double force;     ///< 0.25 sqrt(h / max acceleration)
    double viscous;   ///< 0.125 h^2 / nu, nu the viscosity or what the artificial one amounts to
    double limit;     ///< the least
    const char* reason;
};

/// Energies and losses of the fluid [J], measured at the kick like those of bodies (sim/ledger.hpp). The sum
///
///     kinetic + potential + internal + sums over steps of (dissipated_viscous + dissipated_diffusion + shifted
///         + work_on_solids + wall_exchange - work_external)
///
/// stays the same (docs/theory/sph.md, 6).
struct FluidReport {
    double kinetic{0};               ///< sum m v_n.v_(n+1)/2
    double potential{0};             ///< -sum m g.x; gravity along periodic axes is in work_external
    double internal{0};              ///< of compression
    double dissipated_viscous{0};    ///< in this step, pair by pair never negative within the fluid
    double dissipated_diffusion{0};  ///< in this step, by the diffusion of density and by tearing
    double shifted{0};               ///< potential energy and that of compression that shifting took away in this step
    double work_on_solids{0};        ///< in this step
    double wall_exchange{0};         ///< in this step: work of mirrored wall pressure that no body sees
    double work_external{0};         ///< in this step, by extra forces and by gravity along periodic axes
    Vec3 momentum{}, impulse{};  ///< of the fluid after the step [kg m/s]; of gravity, walls, extra forces in it [N s]
    double mass{0};              ///< [kg]
    double max_speed{0}, max_acceleration{0};
    double max_shift{0};              ///< farthest that shifting moved a particle in this step [m]
    std::int64_t worst_particle{-1};  ///< first id that is not finite, too fast or out of the domain
    std::string problem;              ///< why, with particle, place and time
};

// The step is symplectic for the acoustic system (position Verlet): density is known half a step behind.
//
//     rho_(n+1/2) = rho_(n-1/2) + (dt_(n-1) + dt_n)/2 R(x_n, v_n)            update_density, walls at t_n
//     x_(n+1/2)   = x_n + dt/2 v_n                                           drift
//     v_(n+1)     = v_n + dt a(x_(n+1/2), rho_(n+1/2), v_n), and shifting    forces and kick, walls at t_n + dt/2
//                   of places; the density that it takes goes at the next update
//     x_(n+1)     = x_(n+1/2) + dt/2 v_(n+1)                                 drift
//
// so loads on solids are known at mid-step, where solids are kicked too. Forces and kick are begin_forces, load_walls
// and kick_fluid; how walls move may be changed between calls of load_walls, which is what light bodies need. All are
// called in this order in every step; scratch may be lost between steps, not within one.

FluidTimeStep choose_fluid_time_step(const SphSettings& settings, const ParticleState& state);

/// @param dt  from density to density: (dt_(n-1) + dt_n)/2, dt_0/2 in the first step [s]
void update_density(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                    const Vec3& gravity, double dt, SphScratch& scratch, FluidReport& report);

/// @param dt  half the step [s]
void drift(const SphSettings& settings, ParticleState& state, double dt);

/// Forces within the fluid, its averages at the walls and the sums of its pressure there; walls may then be told to
/// move in another way but not to another place. Where a particle is no longer sound report.problem says so and nothing
/// is changed.
/// @param time  t_n, for the report [s]
void begin_forces(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls, double time,
                  SphScratch& scratch, FluidReport& report);

/// The water about the walls as begin_forces found it, under this gravity.
void describe_water_at_walls(const Vec3& gravity, const SphScratch& scratch, WaterAtWalls& water);

/// What the fluid does to walls that move as they say now: their pressure and their loads.
void load_walls(const SphSettings& settings, const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                SphScratch& scratch);

/// Adds what the walls do to the fluid, as last loaded, and kicks it. Where a particle is no longer sound afterwards
/// report.problem says so.
/// @param dt           the whole step [s]
/// @param time         t_n, for the report [s]
/// @param extra_force  on each particle, from penalty walls and the like [N]; empty: none
void kick_fluid(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                double dt, double time, SphScratch& scratch, FluidReport& report,
                std::span<const Vec3> extra_force = {});

/// The three in a row, for walls that move as they do.
void accelerate(const SphSettings& settings, ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                double dt, double time, SphScratch& scratch, FluidReport& report,
                std::span<const Vec3> extra_force = {});

}  // namespace riprap::fluid
