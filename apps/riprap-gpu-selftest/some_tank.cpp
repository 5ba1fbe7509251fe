// SPDX-License-Identifier: Apache-2.0
#include "some_tank.hpp"

#include <cmath>

#include "riprap/fluid/particle/state_equation.hpp"

namespace selftest {

using riprap::Vec3;

Tank some_tank(int count) {
    Tank tank;
    constexpr double dp = 0.01;
    constexpr int layers = 3;
    const double width = dp * count;
    auto& settings = tank.settings;
    settings.spacing = dp;
    settings.sound_speed = 10 * std::sqrt(9.81 * 0.5 * width) + 5;
    settings.particle_mass = settings.rest_density * dp * dp * dp;
    settings.domain = {{-width, -width, -width}, {2 * width, 2 * width, 2 * width}, {}, 3};
    for (int z = -layers; z < count; ++z) {
        for (int y = -layers; y < count + layers; ++y) {
            for (int x = -layers; x < count + layers; ++x) {
                const Vec3 place{(x + 0.5) * dp, (y + 0.5) * dp, (z + 0.5) * dp};
                const bool is_inside = x >= 0 && y >= 0 && z >= 0 && x < count && y < count;
                if (is_inside && z < count / 2) {
                    const Vec3 velocity{0.3 * std::sin(20 * place.y), 0.2 * std::cos(15 * place.z), 0.1};
                    const double depth = dp * (count / 2) - place.z;
                    tank.water.add(place, velocity, riprap::fluid::density_of(settings, 9810 * depth),
                                   static_cast<std::int32_t>(tank.water.size()));
                } else if (!is_inside) {
                    tank.walls.position.push_back(place);
                    tank.walls.is_slippery.push_back(z < 0 ? 0 : 1);
                }
            }
        }
    }
    tank.walls.velocity.resize(tank.walls.position.size());
    tank.walls.acceleration.resize(tank.walls.position.size(), Vec3{0.1, 0, 0});
    tank.walls.volume.resize(tank.walls.position.size(), dp * dp * dp);
    tank.extra_force.reset(tank.water.position.size());
    tank.extra_force.add(tank.water.position.size() / 3, {1e-3, 0, 2e-3});
    return tank;
}

void Tank::step(riprap::fluid::ParticleScheme& scheme) {
    const riprap::TimeSpan span{time, 0.3 * settings.smoothing_length() / settings.sound_speed};
    report = {};
    scheme.update_density(water, walls, gravity, time > 0 ? span.dt : 0.5 * span.dt, report);
    drift(settings, water, 0.5 * span.dt);
    scheme.begin_forces(water, walls, span, gravity, report);
    scheme.load_walls(water, walls, gravity);
    scheme.kick(water, walls, gravity, span, extra_force, report);
    drift(settings, water, 0.5 * span.dt);
    time += span.dt;
}

}  // namespace selftest
