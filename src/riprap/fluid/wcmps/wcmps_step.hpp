// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/particle_scheme.hpp"
#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/fluid/wcmps/wcmps_settings.hpp"

namespace riprap::fluid {

struct WcmpsScratchData;

/// Neighbour lists and rates: buffers kept only for speed.
class WcmpsScratch {
 public:
    WcmpsScratch();
    ~WcmpsScratch();
    WcmpsScratch(WcmpsScratch&&) noexcept;
    WcmpsScratch& operator=(WcmpsScratch&&) noexcept;
    WcmpsScratchData& data() { return *data_; }
    const WcmpsScratchData& data() const { return *data_; }
    std::size_t bytes() const;

 private:
    std::unique_ptr<WcmpsScratchData> data_;
};

using WcmpsReport = FluidReport;

// Weakly compressible MPS [Mellado2021], [JandaghianShakibaeinia2020]. ParticleState::density is rho_0 n/n_0, n the
// number density that continuity carries. The verbs and their order are those of sph_step.hpp; that step is the
// source's symplectic one (eqs. 5.22 to 5.27), whose two half updates of n at the ends of neighbouring steps are made
// in one:
//
//     n_(n+1/2) = n_(n-1/2) + (dt_(n-1) + dt_n)/2 N(x_n, v_n)     update_density
//     x_(n+1/2) = x_n + dt/2 v_n                                   drift
//     v_(n+1)   = v_n + collisions + dt G(x_(n+1/2), n_(n+1/2), v_n), and shifting
//                                                                 begin_forces, load_walls, kick_fluid
//     x_(n+1)   = x_(n+1/2) + dt/2 v_(n+1)                         drift

/// Limits as those of SPH with l_0 for h: 0.25 sqrt(l_0/a), 0.125 l_0^2/nu.
FluidTimeStep choose_fluid_time_step(const WcmpsSettings& settings, const ParticleState& state);

/// @param dt  from density to density: (dt_(n-1) + dt_n)/2, dt_0/2 in the first step [s]
void update_density(const WcmpsSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                    const Vec3& gravity, double dt, WcmpsScratch& scratch, FluidReport& report);

/// @param time  t_n, for the report [s]
void begin_forces(const WcmpsSettings& settings, ParticleState& state, const BoundaryParticles& walls, double time,
                  WcmpsScratch& scratch, FluidReport& report);

/// The water about the walls as begin_forces found it, under this gravity.
void describe_water_at_walls(const Vec3& gravity, const WcmpsScratch& scratch, WaterAtWalls& water);

/// Pressure and loads of walls that move as they say now. With WallLoads::pressure_area where walls.outward_area is
/// given, else the reaction of the pair sums.
void load_walls(const WcmpsSettings& settings, const ParticleState& state, BoundaryParticles& walls,
                const Vec3& gravity, WcmpsScratch& scratch);

/// @param dt           the whole step [s]
/// @param extra_force  on each particle [N]
void kick_fluid(const WcmpsSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                const Vec3& gravity, double dt, double time, WcmpsScratch& scratch, WcmpsReport& report,
                const SparseVectors& extra_force = {});

/// begin_forces, load_walls and kick_fluid in a row, for walls that move as they do.
void accelerate(const WcmpsSettings& settings, ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                double dt, double time, WcmpsScratch& scratch, WcmpsReport& report,
                const SparseVectors& extra_force = {});

/// Where a particle lies relative to the free surface [JandaghianShakibaeinia2020].
enum class SurfaceClass : std::uint8_t {
    internal,  ///< I
    near,      ///< B: a particle of the surface within 2.1 l_0
    surface,   ///< F
    splash,    ///< E: C < 0.4
};

/// Weakly compressible MPS as a scheme of a particle fluid.
class WcmpsFluid final : public ParticleScheme {
 public:
    explicit WcmpsFluid(const WcmpsSettings& settings) : settings_(&settings) {}
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
    const WcmpsSettings* settings_;
    WcmpsScratch scratch_;
};

/// Makes the scheme of these settings, which have to outlive it.
std::unique_ptr<ParticleScheme> make_scheme(const WcmpsSettings& settings);

/// Classes of all particles as the last kick found them.
std::span<const SurfaceClass> surface_classes(const WcmpsScratch& scratch);

}  // namespace riprap::fluid
