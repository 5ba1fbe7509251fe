// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/mps_operators/mps_lattice.hpp"
#include "riprap/fluid/mps_operators/mps_weight.hpp"
#include "riprap/fluid/particle/flow_work.hpp"
#include "riprap/fluid/particle/particle_scheme.hpp"
#include "riprap/fluid/particle/sweep/sweep_lists.hpp"
#include "riprap/fluid/wcmps/wcmps_scratch.hpp"
#include "riprap/fluid/wcmps/wcmps_settings.hpp"

namespace riprap::fluid {

/// Weakly compressible MPS [Mellado2021], [JandaghianShakibaeinia2020]. ParticleState::density is rho_0 n/n_0, n the
/// number density that continuity carries. The step is the source's symplectic one (eqs. 5.22 to 5.27), whose two half
/// updates of n at the ends of neighbouring steps are made in one:
///
///     n_(n+1/2) = n_(n-1/2) + (dt_(n-1) + dt_n)/2 N(x_n, v_n)     update_density
///     x_(n+1/2) = x_n + dt/2 v_n                                   drift
///     v_(n+1)   = v_n + collisions + dt G(x_(n+1/2), n_(n+1/2), v_n), and shifting
///                                                                 begin_forces, load_walls, kick
///     x_(n+1)   = x_(n+1/2) + dt/2 v_(n+1)                         drift
class Wcmps : public ParticleScheme {
 public:
    explicit Wcmps(const WcmpsSettings& settings)
        : settings_(settings), weight_(settings.weight()), lattice_(settings.lattice()) {}

    /// Limits as those of SPH with l_0 for h: 0.25 sqrt(l_0/a), 0.125 l_0^2/nu.
    FluidTimeStep limit(const ParticleState& state) const override;
    /// Changes the density by continuity, diffusion and tearing.
    void update_density(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt,
                        ParticleReport& report) override;
    void begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span, const Vec3& gravity,
                      ParticleReport& report) override;
    void describe_walls(const Vec3& gravity, WaterAtWalls& water) const override;
    /// Loads walls with WallLoads::pressure_area where walls.outward_area is given, else by the reaction of the pair
    /// sums.
    void load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) override;
    void kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
              const SparseVectors& extra_force, ParticleReport& report) override;
    std::size_t bytes() const override;

    /// Classes of all particles as the last kick found them.
    std::span<const SurfaceClass> surface_classes() const { return surface_.classes; }

 protected:
    // Density (continuity.cpp).

    /// Finds x, p and q of every particle from its density.
    void find_pressure(const ParticleState& state);
    /// a h rho_0 c_0, h half the support radius [Pa s]. Sound is damped by what forces see as pressure above p,
    ///
    ///     s a h rho_0 c_0 (dx/dt)/x,
    ///
    /// dx/dt by the continuity of the last update of density: a bulk viscosity, conjugate to it like the pressure
    /// [Sun2023]. s is 1 where water and walls that stand still fill what is around, 0 in two rows at surfaces, where
    /// water has no true divergence, and at walls that move: on a light body a resistance is, step by step, an added
    /// mass times its velocity (docs/theory/wcmps.md, 4).
    double resistance_to_sound() const;
    /// Adds that to p and q.
    void damp_sound();
    /// Finds b and m of wall particles, and which have a pressure of their own.
    void find_wall_shares(const BoundaryParticles& walls);
    /// Finds g of walls: zero where they mirror each particle or have a pressure of their own.
    void share_openings(const ParticleState& state, const BoundaryParticles& walls);
    /// The sums of NumberContinuity and NumberContinuityAtWalls. @returns those that are lent
    WcmpsDensitySums sum_continuity(const ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity);
    /// The second half of the last shift, which so is made half before and half after the density that both forces
    /// beside it meet: a shift made at once would take energy from one side only. Returns the energy of place that it
    /// takes [J].
    double finish_shift(ParticleState& state, const Vec3& gravity) const;

    // Forces (forces.cpp).

    double pair_viscosity() const;  ///< k of MpsMomentum [Pa s/m^2]
    double force_factor() const;    ///< l_0^D D/n_0: from sums to forces [m^D]
    /// Sums over the water at walls, which do not depend on how walls move.
    void average_at_walls(const ParticleState& state, const BoundaryParticles& walls);
    /// Pressure of the fluid at walls, never below zero, for gauges, and velocity of the fluid mirrored in them
    /// [Adami2012, eqs. 22, 23, 27]; A, H and h of walls.
    void extrapolate_to_walls(BoundaryParticles& walls, const Vec3& gravity);
    /// Adds the sums of MpsMomentumFromWalls.
    void add_walls(const ParticleState& state, const BoundaryParticles& walls);

    // Classes of particles about the free surface, and what they decide (surface.cpp).

    /// Class of every particle and normals of class B.
    void classify(const ParticleState& state);
    /// Changes of velocity that make pairs of classes F and B that approach below the collision distance part
    /// [Mellado2021, eqs. 5.38, 5.39]; returns whether there are any.
    bool find_collisions(const ParticleState& state);
    /// Moves particles down the gradient of concentration [Mellado2021, eq. 5.36]:
    ///
    ///     delta x = -F grad C,   F = 2 l_0 dt u,   at most a tenth of l_0,
    ///
    /// and F at most 0.5/MpsLattice::wave_stiffness, which halves the stiffest wave of lattice planes in a step and
    /// ends one of pairs at 0.8 l_0, which are twice as stiff: more would turn it over. u is how fast neighbours pass
    /// each other, where the source takes the fastest particle of all, see docs/theory/wcmps.md, 6. The first half is
    /// made at once, the second after the next update of density. Class B and F along the surface only, E not.
    void shift(ParticleState& state, const Vec3& gravity, double dt, ParticleReport& report) const;

    /// v += collision + dt (force + extra force)/m + dt g, and the report of all that belongs to particles.
    void kick_particles(ParticleState& state, const Vec3& gravity, double dt, bool collides,
                        const SparseVectors& extra_force, ParticleReport& report) const;

    WcmpsSettings settings_;
    MpsWeight weight_;
    MpsLattice lattice_;
    SweepLists lists_;
    WcmpsWater water_;
    WcmpsContinuity continuity_;
    FlowWork flow_;        ///< of the update of density in this step
    double flow_time_{0};  ///< its dt [s]
    StageMemory<parallel::Host> stage_;
    WcmpsForceSums forces_;  ///< lent by it
    WcmpsSurface surface_;
    WcmpsCollisions collisions_;
    WcmpsWalls walls_;
    WcmpsAtWalls at_walls_;
};

}  // namespace riprap::fluid
