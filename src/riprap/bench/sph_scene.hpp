// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/boundary_particles.hpp"
#include "riprap/fluid/particle/particle_state.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::bench {

/// A column of water, 60 x 50 x 50 particles on a jittered lattice, that has just been let go: floor and walls on three
/// sides, three particles thick, none on the fourth. 150 000 particles of water, about 190 000 in all; hydrostatic,
/// and sheared so that the surface moves at a tenth of the sound speed, as fast as a weakly compressible fluid should.
struct SphColumn {
    fluid::SphSettings settings;
    fluid::ParticleState water;
    fluid::BoundaryParticles walls;
    Vec3 gravity{0, 0, -9.81};

    std::int64_t size() const { return water.size() + walls.size(); }
};

/// @param smoothing_ratio  h/dp [-]
/// @param coarsening       spacings and counts along each edge are this many times larger and smaller
SphColumn sph_column(double smoothing_ratio, int coarsening = 1);

}  // namespace riprap::bench
