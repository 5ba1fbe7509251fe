// SPDX-License-Identifier: Apache-2.0
#pragma once

// Buffers of a particle fluid between walls: for the sources of this folder only.

#include <cstdint>
#include <memory>
#include <vector>

#include "riprap/coupling/particle_walls/joint_loads.hpp"
#include "riprap/coupling/particle_walls/particle_fluid.hpp"
#include "riprap/coupling/particle_walls/penalty_walls.hpp"
#include "riprap/coupling/samples/corner_loads.hpp"
#include "riprap/coupling/samples/rigid_map.hpp"
#include "riprap/coupling/samples/sample_set.hpp"
#include "riprap/fluid/particle/particle_scheme.hpp"

namespace riprap::coupling {

/// Properties of bodies that do not change over a run; one entry per body.
struct WallBodies {
    std::vector<double> kappa;           ///< share of the mass that the wall treatment feeds back [-]
    std::vector<std::uint8_t> is_still;  ///< never moves
    std::vector<std::uint8_t> is_loose;  ///< forces move it, now or once it is released
    std::vector<double> guard_share;     ///< of the guard's stiffness [-]
};

/// Buffers of a particle fluid: Scratch.
struct ParticleScratch {
    std::unique_ptr<fluid::ParticleScheme> scheme;
    const ParticleFluid* made_for{nullptr};  ///< whose settings the scheme has
    WallBodies bodies;
    CornerLoads corners;
    fluid::BoundaryParticles walls;
    std::vector<std::int32_t> near_numbers;  ///< a copy of the State's near_samples: those that `walls` stand for
    PenaltyWalls penalty;
    body::Motion motion;    ///< of all bodies, where the samples were placed last
    FluidLoads held_loads;  ///< of particles pressed against faces and of water in joints
    JointScratch joints;
    fluid::SparseVectors extra_force;  ///< of penalty walls and sponges on particles [N]
    fluid::SpongeWork sponge;

    std::size_t bytes() const;
};

}  // namespace riprap::coupling
