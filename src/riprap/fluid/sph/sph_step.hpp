// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>

#include "riprap/fluid/particle/particle_scheme.hpp"
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

/// Forces within the fluid, its averages at the walls and the sums of its pressure there; walls may then be told to
/// move in another way but not to another place. Where a particle is no longer sound report.problem says so and nothing
/// is changed.
/// @param time  t_n, for the report [s]
void begin_forces(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls, double time,
                  SphScratch& scratch, FluidReport& report);

/// The water about the walls as begin_forces found it, under this gravity.
void describe_water_at_walls(const Vec3& gravity, const SphScratch& scratch, WaterAtWalls& water);

/// Finds pressure and loads of walls that move as they say now.
void load_walls(const SphSettings& settings, const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                SphScratch& scratch);

/// Adds what the walls do to the fluid, as last loaded, and kicks it. Where a particle is no longer sound afterwards
/// report.problem says so.
/// @param dt           the whole step [s]
/// @param time         t_n, for the report [s]
/// @param extra_force  on each particle, from penalty walls and the like [N]
void kick_fluid(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                double dt, double time, SphScratch& scratch, FluidReport& report,
                const SparseVectors& extra_force = {});

/// The three in a row, for walls that move as they do.
void accelerate(const SphSettings& settings, ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                double dt, double time, SphScratch& scratch, FluidReport& report,
                const SparseVectors& extra_force = {});

/// SPH as a scheme of a particle fluid.
class SphFluid final : public ParticleScheme {
 public:
    explicit SphFluid(const SphSettings& settings) : settings_(&settings) {}
    FluidTimeStep limit(const ParticleState& state) const override;
    void update_density(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt,
                        FluidReport& report) override;
    void begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span, const Vec3& gravity,
                      FluidReport& report) override;
    void describe_walls(const Vec3& gravity, WaterAtWalls& water) const override;
    void load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) override;
    void kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
              const SparseVectors& extra_force, FluidReport& report) override;
    std::size_t bytes() const override { return scratch_.bytes(); }

 private:
    const SphSettings* settings_;
    SphScratch scratch_;
};

/// Makes the scheme that these settings are of. They have to outlive it.
std::unique_ptr<ParticleScheme> make_scheme(const SphSettings& settings);

}  // namespace riprap::fluid
