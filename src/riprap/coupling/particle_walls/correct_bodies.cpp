// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/correct_bodies.hpp"

#include "riprap/body/locks.hpp"
#include "riprap/core/index.hpp"
#include "riprap/fluid/particle/loose_bodies.hpp"

namespace riprap::coupling {

bool correct(const ParticleFluid& water, const body::BodySet& bodies, const body::BodyKinematics& kinematics,
             std::span<const std::uint8_t> is_sought, std::span<const body::Acceleration> residual,
             const ParticleScratch& scratch, std::vector<body::Acceleration>& guess) {
    fluid::SolvesForBodies* const scheme = scratch.scheme->for_bodies();
    if (scheme == nullptr || water.wall != WallTreatment::boundary_particles) {
        return false;
    }
    fluid::LooseBodies loose;
    std::vector<std::int32_t> place(guess.size(), -1);
    std::vector<fluid::Twist> missing;
    for (std::size_t b = 0; b < guess.size(); ++b) {
        if (is_sought[b] != 0) {
            place[b] = static_cast<std::int32_t>(loose.size());
            loose.lightness.push_back(locks_of(bodies, b).free_translation(kinematics.inverse_mass[b] * Vec3{1, 1, 1}));
            loose.inverse_inertia.push_back(kinematics.inverse_inertia[b]);
            missing.push_back({residual[b].linear, residual[b].angular});
        }
    }
    const SampleView samples(water.samples, scratch.near_numbers);
    for (std::size_t i = 0; i < at(samples.size()); ++i) {
        const auto b = at(samples.body(i).value);
        loose.of_wall.push_back(place[b]);
        loose.arm.push_back(scratch.walls.position[i] - scratch.motion.pose[b].position);
    }
    std::vector<fluid::Twist> change(loose.size());
    if (loose.size() == 0 || !scheme->correct(loose, missing, change)) {
        return false;
    }
    for (std::size_t b = 0; b < guess.size(); ++b) {
        if (place[b] >= 0) {
            guess[b].linear += change[at(place[b])].linear;
            guess[b].angular += change[at(place[b])].angular;
        }
    }
    return true;
}

}  // namespace riprap::coupling
