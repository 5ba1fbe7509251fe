// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "riprap/core/step.hpp"
#include "riprap/fluid/fluid_balance.hpp"
#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/fluid/particle/sparse_vectors.hpp"
#include "riprap/fluid/particle/volume_book.hpp"

namespace riprap::fluid {

class SolvesForBodies;  // loose_bodies.hpp

/// The longest steps that each limit allows [s].
struct FluidTimeStep {
    double acoustic;  ///< courant h / (c + max speed), c at the highest density
    double force;     ///< 0.25 sqrt(h / max acceleration)
    double viscous;   ///< 0.125 h^2 / nu, nu the viscosity or what the artificial one amounts to
    double limit;     ///< the least
    const char* reason;
};

/// Energies and losses of particles [J], measured at the kick. The sum
///
///     kinetic + potential + internal + sums over steps of (dissipated_viscous + dissipated_collisions
///         + by_density.sum() + pressure_loss + shifted + work_on_solids + wall_exchange + earlier_heat
///         + earlier_collisions + earlier_exchange - work_external)
///
/// stays the same (docs/theory/sph.md, 6), where kinetic is sum m v_n.v_(n+1)/2 and work_external that of extra forces
/// and of gravity along periodic axes.
struct FluidReport : FluidBalance {
    double dissipated_viscous{0};     ///< in this step, pair by pair never negative within the fluid
    double dissipated_collisions{0};  ///< in this step, by collisions of particles with each other and with walls
    DensityLosses by_density;         ///< in this step, by what changes density besides flow and shifting
    double pressure_loss{0};          ///< in this step, of a pressure that is solved for (docs/theory/mps.md)
    double shifted{0};                ///< potential energy and that of compression that shifting took away in this step
    double wall_exchange{0};          ///< in this step: work of mirrored wall pressure that no body sees
    double earlier_heat{0};           ///< what is due of dissipated_viscous before the kick, and not in it
    double earlier_collisions{0};     ///< the same of dissipated_collisions
    double earlier_exchange{0};       ///< the same of wall_exchange
    VolumeBook volume;                ///< of this step, of schemes that carry density on
    double max_acceleration{0};
    double max_shift{0};              ///< farthest that shifting moved a particle in this step [m]
    std::int64_t worst_particle{-1};  ///< first id that is not finite, too fast or out of the domain
    std::string problem;              ///< why, with particle, place and time
    std::string remedy;               ///< what to change in the case, where that follows from the problem
};

/// Notes the potential energy -g.X of particles with the first moment X = sum m x [kg m], g the gravity that has a
/// potential.
inline void book_potential(const Vec3& gravity, const Vec3& mass_moment, const Domain& domain, FluidBalance& balance) {
    balance.gravity = without_periodic(gravity, domain);
    balance.mass_moment = mass_moment;
    balance.potential = -dot(balance.gravity, mass_moment);
}

/// Step of the particles of one method, between walls that somebody else moves. The driver calls the verbs in
/// this order in every step; what an object keeps between steps decides no bit.
///
///     renew
///     update_density   walls at t_n
///     drift            x_(n+1/2) = x_n + dt/2 v_n, the same for all schemes
///     begin_forces     walls at t_n + dt/2: all that how walls accelerate does not change
///     load_walls       pressure and loads of walls that move as they say now; may be repeated with another
///     acceleration
///                      and velocity of the walls at the same places: light bodies need it, and so does a pressure
///                      solve
///     kick             v_(n+1), with what the walls did as they were last loaded
///     drift            x_(n+1) = x_(n+1/2) + dt/2 v_(n+1)
class ParticleScheme {
 public:
    ParticleScheme() = default;
    ParticleScheme(const ParticleScheme&) = delete;
    ParticleScheme& operator=(const ParticleScheme&) = delete;
    virtual ~ParticleScheme() = default;

    /// Returns the longest step that this State allows.
    virtual FluidTimeStep limit(const ParticleState& state) const = 0;
    /// Finds neighbours and weights anew in the step that begins, or keeps those of the flow step under way. A scheme
    /// of one clock finds them in every step. The verbs that follow go by what this says.
    /// @param walls  at t_n; those of the flow step before, where one is over
    /// @param are_walls_still  no wall moves, and no water enters or leaves
    /// @param since  time by which update_density is to carry the density; less, where this has carried it already [s]
    /// @returns how long they are to last; 0 where they are kept [s]
    virtual double renew(ParticleState& /*state*/, const BoundaryParticles& /*walls*/, const Vec3& /*gravity*/,
                         const TimeSpan& span, bool /*are_walls_still*/, double& /*since*/, FluidReport& /*report*/) {
        return span.dt;
    }
    /// Has the scheme two clocks (FlowClock)?
    virtual bool has_two_clocks() const { return false; }
    /// Carries the density to the middle of the step.
    /// @param dt  from density to density: (dt_(n-1) + dt_n)/2, dt_0/2 in the first step [s]
    virtual void update_density(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt,
                                FluidReport& report) = 0;
    /// Finds the forces within the fluid and its averages at the walls. Where a particle is not sound report.problem
    /// says so and nothing is changed.
    virtual void begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span,
                              const Vec3& gravity, FluidReport& report) = 0;
    /// Describes the water about the walls as begin_forces found it, under this gravity.
    virtual void describe_walls(const Vec3& gravity, WaterAtWalls& water) const = 0;
    /// Finds the pressure at walls that move as they say now, and their loads.
    virtual void load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) = 0;
    /// Adds the forces of the walls as last loaded, and kicks. Where a particle is not sound afterwards report.problem
    /// says so.
    /// @param extra_force  on each particle, from penalty walls and the like [N]
    virtual void kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
                      const SparseVectors& extra_force, FluidReport& report) = 0;
    /// Returns the scheme as one that solves for its pressure and the accelerations of bodies at once; nullptr where it
    /// does not.
    virtual SolvesForBodies* for_bodies() { return nullptr; }
    virtual std::size_t bytes() const = 0;
};

/// x += dt v, back into the domain along periodic axes.
/// @param dt  half the step [s]
void drift(const ParticleSettings& settings, ParticleState& state, double dt);

/// Books impulse and work between fluid and walls from the forces on wall particles.
void book_walls(const BoundaryParticles& walls, double dt, FluidReport& report);

}  // namespace riprap::fluid
