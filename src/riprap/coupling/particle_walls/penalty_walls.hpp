// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/body/ground.hpp"
#include "riprap/core/bytes.hpp"
#include "riprap/coupling/samples/rigid_map.hpp"
#include "riprap/coupling/wall_passages.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/fluid/particle/sparse_vectors.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"

namespace riprap::coupling {

/// Strength of walls that push particles away.
struct PenaltySettings {
    double reach;            ///< r_0: the push begins at this distance from a face [m]
    double stiffness;        ///< k_s [N/m]; in 2D per metre of width
    double damping;          ///< k_d [N s/m]
    double spacing;          ///< of the particles [m]
    fluid::Domain domain{};  ///< faces reach across its periodic sides
    /// v_r and m/dt: one push leaves a particle no faster away from the face than v_r [m/s], [kg/s].
    double fastest_return{std::numeric_limits<double>::infinity()}, hardest{std::numeric_limits<double>::infinity()};
    double dt{0};  ///< of the step: time since particles were last pushed [s]
};

/// r_0 = dp/2, k_s = 0.1 rho_0 c_0^2 dp^(dim-2), k_d = 2 zeta sqrt(k_s m) with zeta = 0.5, m a particle's mass. At rest
/// under a column of height H a particle then stands rho_0 g H dp^(dim-1)/k_s <= dp/10 inside the reach, as
/// c_0 >= 10 sqrt(g H).
PenaltySettings penalty_settings(const fluid::ParticleSettings& settings, double dt);

/// A guard behind boundary particles: keeps a particle that is squeezed harder than they can hold, by a block that
/// closes on a wall say, from passing through a face. r_0 = dp/5, where particles under pressure do not come (they
/// stand at about dp/2), k_s = rho_0 c_0^2 dp^(dim-2)/2, so that a particle at speed v is stopped within 1.4 dp v/c_0,
/// and zeta = 0.5. One push leaves a particle no faster away from the face than v_r = 0.05 c_0, so particles that slip
/// out of a closing gap are not thrown. The oscillation of a particle at one face stays stable at steps up to 1.7
/// dp/c_0; the acoustic limit is 1.2 dp/c_0 by default. Where several parts push one particle, at the seam of a union
/// say, the bound falls.
/// @param dt  of the step [s]
PenaltySettings guard_settings(const fluid::ParticleSettings& settings, double dt);

/// The push of faces on particles near them and its reaction, [MikolaSitar2013, eq. 22] completed:
///
///     F = max(0, k_s d - k_d min(0, (v - v_s) . n)) n,   d = r_0 - distance > 0,
///
/// r_0 no more than (distance_a + distance_b)/2 between two parts a and b that face each other, n_a . n_b < -1/2, so
/// that a particle between them is kept in the middle and holds neither up;
/// n the outward normal of the nearest point of the part (outside: from there to the particle; inside: of the nearest
/// face), v_s the velocity of the solid there. The solid takes -F at the place of the particle, so both momenta change
/// by opposite amounts to round-off. Every convex part pushes by itself, across periodic sides by the image that
/// reaches deepest. There is no shear and no layer of water behind the wall: pressure near it is too low, forces are
/// noisy.
class PenaltyWalls {
 public:
    struct Push {
        std::int32_t body;
        Vec3 force;  ///< on the particle; the body takes the opposite [N]
        Vec3 place;  ///< of the image of the particle that the body meets [m]
    };

    /// Holds what the pushes of one block of particles do to one body.
    struct Reaction {
        std::int32_t body;
        Vec3 force, torque;  ///< [N], [N m]
        Sym3 pull;           ///< [N m]
    };

    /// @param motion  of all bodies at the places of the particles
    /// @param is_dry  per body, of those that push nothing; empty = none
    /// @param share   per body, factor on stiffness and damping, for bodies too light for them; empty = 1
    /// @param force   on each particle [N]
    /// @param loads   on each body, as pressure
    void push(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::Motion& motion,
              std::span<const std::uint8_t> is_dry, const PenaltySettings& settings, std::span<const double> share,
              const fluid::ParticleState& particles, fluid::SparseVectors& force, FluidLoads& loads);

    /// The pushes of the last call, in the order of the particles, by blocks of them.
    std::span<const std::vector<Push>> pushes() const { return blocks_; }
    /// Particles that went through solid since they were pushed before, one step ago (passage.hpp).
    const WallPassages& passages() const { return passages_; }

    std::size_t bytes() const { return bytes_of(blocks_) + bytes_of(reactions_) + bytes_of(passed_); }

 private:
    void find_grounds(const geometry::ShapeSet& shapes, const body::BodySet& bodies);
    void gather(const body::BodySet& bodies, const body::Motion& motion, const parallel::Blocks& blocks,
                FluidLoads& loads) const;

    std::vector<std::vector<Push>> blocks_;         ///< in the order of the particles, by blocks of them
    std::vector<std::vector<Reaction>> reactions_;  ///< of the same blocks, by body
    WallPassages passages_;
    std::vector<WallPassages> passed_;   ///< by the same blocks
    std::vector<body::Ground> grounds_;  ///< found once: ground keeps its shape
    std::optional<std::size_t> parts_;   ///< of all bodies when `grounds_` was found
};

}  // namespace riprap::coupling
