// SPDX-License-Identifier: Apache-2.0
// Particles as they are drawn.
#include <random>

#include "riprap/coupling/particle_walls/particle_method.hpp"
#include "riprap/fluid/particle/state_equation.hpp"

namespace riprap::coupling {

namespace {

fluid::ShownFluid shown_points(const fluid::ParticleSettings& settings, const fluid::ParticleState& particles) {
    fluid::ShownFluid water;
    water.spacing = settings.spacing;
    water.place = particles.position;
    water.velocity = particles.velocity;
    water.id = particles.id;
    water.has_density = true;
    for (const double density : particles.density) {
        water.density.push_back(static_cast<float>(density));
        water.pressure.push_back(static_cast<float>(pressure_of(settings, density)));
    }
    return water;
}

}  // namespace

fluid::ShownFluid ParticleMethod::shown(const ShownQuery<Settings>& query) {
    return shown_points(query.settings.settings(), query.particles);
}

fluid::ShownFluid ParticleMethod::shown_stirred(const ShownQuery<Settings>& query) {
    const fluid::ParticleSettings& settings = query.settings.settings();
    fluid::ParticleState water = query.particles;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> share(-1, 1);
    for (std::size_t i = 0; i < water.position.size(); ++i) {
        for (int axis = 0; axis < settings.domain.dimension; ++axis) {
            water.position[i][axis] += 0.2 * settings.spacing * share(random);
            water.velocity[i][axis] = 0.1 * settings.sound_speed * share(random);
        }
        water.density[i] = settings.rest_density * (1 + 0.01 * share(random));
    }
    return shown_points(settings, water);
}

}  // namespace riprap::coupling
