// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/particle_scheme.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"

namespace selftest {

/// Water that sloshes in a tank of wall particles, a cube of `count` spacings half filled, and how it is stepped.
struct Tank {
    riprap::fluid::SphSettings settings;
    riprap::fluid::ParticleState water;
    riprap::fluid::BoundaryParticles walls;
    riprap::fluid::SparseVectors extra_force;
    riprap::Vec3 gravity{0.5, 0, -9.81};
    riprap::fluid::ParticleReport report;     ///< of the last step
    riprap::fluid::WaterAtWalls about_walls;  ///< likewise
    double time{0};

    void step(riprap::fluid::ParticleScheme& scheme);
};

Tank some_tank(int count);

/// The same in the plane, periodic along x, on a floor that moves and holds, with a pressure given at some of it.
Tank some_channel(int count);

/// A square of water alone.
Tank some_drop(int count);

}  // namespace selftest
