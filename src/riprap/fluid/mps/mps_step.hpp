// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "riprap/fluid/mps/mps_settings.hpp"
#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/particle_scheme.hpp"
#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/linear/pcg.hpp"

namespace riprap::fluid {

struct MpsScratchData;

/// Neighbours, the pressure equation and its solver: buffers kept only for speed.
class MpsScratch {
 public:
    MpsScratch();
    ~MpsScratch();
    MpsScratch(MpsScratch&&) noexcept;
    MpsScratch& operator=(MpsScratch&&) noexcept;
    MpsScratchData& data() { return *data_; }
    const MpsScratchData& data() const { return *data_; }
    std::size_t bytes() const;

 private:
    std::unique_ptr<MpsScratchData> data_;
};

/// Energies and losses, and how the pressure equation was solved. The internal energy is zero here; `pressure_loss` is
/// minus the work of pressure on fluid and walls together: nothing in an incompressible continuum.
struct MpsReport : FluidReport {
    linear::SolveReport solve;  ///< of the pressure equation
    std::int64_t unknowns{0};   ///< its size
};

// Semi-implicit MPS [KoshizukaOka1996] in the form of [Amaro2021], drift - kick - drift:
//
//     x' = x_n + dt/2 v_n                                     drift
//     u* = v_n + dt (nu lap v_n + g), u** = u* + collisions   begin_forces, at x'
//     r** = x' + dt/2 u**, n** and the surface there, where p = 0
//     lap p - rho_0 alpha_c/dt^2 p = gamma rho_0/dt^2 (n_0 - n**)/n_0 + s rho_0/dt div u**     load_walls
//     v_(n+1) = u** - dt grad p/rho_0                          kick_fluid
//     x_(n+1) = x' + dt/2 v_(n+1)                              drift
//
// The source moves all of r by dt u**; half of it has been moved before here, so that places of walls are those of
// mid-step, as for every other fluid. Walls may be told to move in another way between calls of load_walls, each of
// which solves again.

/// courant l_0 over the fastest speed, at least the expected one, and 0.125 l_0^2/nu.
FluidTimeStep choose_fluid_time_step(const MpsSettings& settings, const ParticleState& state);

/// Changes velocities to u** and sets up the pressure equation.
/// @param dt    the whole step [s]
/// @param time  t_n, for the report [s]
void begin_forces(const MpsSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                  const Vec3& gravity, double dt, double time, MpsScratch& scratch, MpsReport& report);

/// Solves for the pressure with walls that move as they say now, and loads them. Where the solver fails,
/// report.problem says so with its iterations and residual.
void load_walls(const MpsSettings& settings, const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                double dt, double time, MpsScratch& scratch, MpsReport& report);

/// @param extra_force  on each particle [N]
void kick_fluid(const MpsSettings& settings, ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                double dt, double time, MpsScratch& scratch, MpsReport& report, const SparseVectors& extra_force = {});

/// begin_forces, load_walls and kick_fluid in a row, for walls that move as they do.
void accelerate(const MpsSettings& settings, ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                double dt, double time, MpsScratch& scratch, MpsReport& report, const SparseVectors& extra_force = {});

/// The water about the walls as begin_forces found it, with the pressure of the step before, under this gravity.
void describe_water_at_walls(const Vec3& gravity, const MpsScratch& scratch, WaterAtWalls& water);

/// Makes the scheme of these settings, which have to outlive it.
std::unique_ptr<ParticleScheme> make_scheme(const MpsSettings& settings);

/// 1 for particles of the surface as begin_forces found them, where pressure is zero.
std::span<const std::uint8_t> surface_particles(const MpsScratch& scratch);

}  // namespace riprap::fluid
