// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/mps/mps_scratch.hpp"
#include "riprap/fluid/mps/mps_settings.hpp"
#include "riprap/fluid/particle/loose_bodies.hpp"
#include "riprap/fluid/particle/particle_scheme.hpp"

namespace riprap::fluid {

/// Semi-implicit MPS [KoshizukaOka1996] in the form of [Amaro2021], drift - kick - drift:
///
///     x' = x_n + dt/2 v_n                                     drift
///     u* = v_n + dt (nu lap v_n + g), u** = u* + collisions   begin_forces, at x'
///     r** = x' + dt/2 u**, n** and the surface there, where p = 0
///     lap p - rho_0 alpha_c/dt^2 p = gamma rho_0/dt^2 (n_0 - n**)/n_0 + s rho_0/dt div u**     load_walls
///     v_(n+1) = u** - dt grad p/rho_0                          kick
///     x_(n+1) = x' + dt/2 v_(n+1)                              drift
///
/// The source moves all of r by dt u**; half of it has been moved before here, so that places of walls are those of
/// mid-step, as for every other fluid. Walls may be told to move in another way between calls of load_walls, each of
/// which solves again.
class Mps : public ParticleScheme, public SolvesForBodies {
 public:
    explicit Mps(const MpsSettings& settings)
        : settings_(settings), weight_(settings.weight()), lattice_(settings.lattice()) {}

    /// courant l_0 over the fastest speed, at least the expected one, and 0.125 l_0^2/nu.
    FluidTimeStep limit(const ParticleState& state) const override;
    /// Density is counted at r**.
    void update_density(ParticleState&, const BoundaryParticles&, const Vec3&, double, ParticleReport&) override {}
    /// Changes velocities to u** and sets up the pressure equation.
    void begin_forces(ParticleState& state, const BoundaryParticles& walls, const TimeSpan& span, const Vec3& gravity,
                      ParticleReport& report) override;
    /// Describes the water about the walls as begin_forces found it, with the pressure of the step before.
    void describe_walls(const Vec3& gravity, WaterAtWalls& water) const override;
    /// Solves for the pressure with walls that move as they say now, and loads them.
    void load_walls(const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity) override;
    SolvesForBodies* for_bodies() override { return this; }
    /// Takes bodies as unknowns of the pressure equation beside those of the particles (bodies_in_pressure.hpp).
    bool correct(const LooseBodies& bodies, std::span<const Twist> residual, std::span<Twist> change) override;
    /// Where a solver failed since begin_forces, report.problem says so with its iterations and residual. The internal
    /// energy is zero here; `pressure_loss` is minus the work of pressure on fluid and walls together: nothing in an
    /// incompressible continuum.
    void kick(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, const TimeSpan& span,
              const SparseVectors& extra_force, ParticleReport& report) override;
    std::size_t bytes() const override { return scratch_.bytes(); }

    /// 1 for particles of the surface as begin_forces found them, where pressure is zero.
    std::span<const std::uint8_t> surface_particles() const { return scratch_.around.surface; }
    /// Pressure of the last solve [Pa].
    std::span<const double> pressure() const { return scratch_.water.pressure; }
    /// Tells how the pressure equation was solved since begin_forces: iterations of all solves, residual of the last.
    const linear::SolveReport& solved() const { return solved_; }

 private:
    // Prediction (prediction.cpp).

    /// u* = v_n + dt (viscosity + gravity): velocities, viscous loads on walls.
    void predict(ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity, double dt);
    /// Finds b, m, P, who follows the water, and the velocity of the fluid mirrored in walls [Adami2012, eq. 23]; the
    /// water about them, with the pressure of the last solve.
    void find_wall_fields(const ParticleState& state, const BoundaryParticles& walls);
    /// Viscous forces on particles and walls [N].
    void add_viscosity(const ParticleState& state, const BoundaryParticles& walls);
    /// Parts particles that approach below the collision distance, and turns back those that meet walls [Amaro2021,
    /// eqs. 11 to 13]: pairs share (1 + alpha_2)/2 of their approach, against walls particles turn by all of 1 +
    /// alpha_2. Where a particle is in several pairs, each takes its part, so that energy cannot grow. Reactions are
    /// loads on walls.
    void collide(ParticleState& state, const BoundaryParticles& walls, double dt);

    // Pressure (pressure_equation.cpp, pressure_forces.cpp).

    /// Finds neighbours at r**, number density and surface, and fills the matrix of the pressure equation [Amaro2021,
    /// eqs. 14, 15, 28, 29]:
    ///
    ///     A_ii = c sum_j W_ij + rho_0 alpha_c/dt^2,   A_ij = -c W_ij,   c = 2 D/(lambda n_0),
    ///
    /// j over fluid; on the diagonal also over particles of the surface, whose p_j = 0. Walls mirror the pressure of i
    /// and add to the right-hand side alone; walls of a given pressure add to the diagonal, too.
    void set_up_pressure(const ParticleState& state, const BoundaryParticles& walls, double dt);
    /// Solves the pressure equation with the right-hand side
    ///
    ///     b_i = gamma rho_0/dt^2 (n**/n_0 + e_i - 1) - s rho_0/dt div u** + c rho_0 sum_w b_w W (g - a_w).(x_w - x_i)
    ///     + c sum_w b_w W p_given,
    ///
    /// e the dilution of rest_density.hpp, starting from the pressures of the step before, which are in scratch.
    /// Pressures below zero become zero.
    linear::SolveReport solve_pressure(const ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                                       double dt);
    /// Finds g of walls at r**, of the water's u**: zero where they mirror each particle or have a pressure of their
    /// own.
    void share_openings(const ParticleState& state, const BoundaryParticles& walls);
    /// Computes pressure forces on particles [N] with the gradient that the settings choose.
    void find_pressure_forces();

    // Loads (wall_loads.cpp).

    /// Sums over the water for the loads of walls that have its mean pressure, and that pressure.
    void average_at_walls(const BoundaryParticles& walls, const Vec3& gravity);
    /// The same for walls that mirror each particle.
    void mirror_at_walls();
    /// Reactions of the conservative pressure forces, of viscosity and of collisions on walls, and the pressure there.
    void find_wall_loads(BoundaryParticles& walls, const Vec3& gravity);

    MpsSettings settings_;
    MpsWeight weight_;
    MpsLattice lattice_;
    MpsScratch scratch_;
    TimeSpan span_{0, 0};         ///< of the step begun
    linear::SolveReport solved_;  ///< by the loads of it
    std::string problem_, remedy_;
};

}  // namespace riprap::fluid
