// SPDX-License-Identifier: Apache-2.0
#include "some_tank.hpp"

#include <cmath>

#include "riprap/fluid/particle/state_equation.hpp"

namespace selftest {

using riprap::Vec3;

namespace {

constexpr double dp = 0.01;

/// Settings of water of a depth, before the domain.
riprap::fluid::SphSettings settings_of(double depth, int dimension) {
    riprap::fluid::SphSettings settings;
    settings.spacing = dp;
    settings.sound_speed = 10 * std::sqrt(9.81 * depth) + 5;
    settings.particle_mass = settings.rest_density * std::pow(dp, dimension);
    settings.domain.dimension = dimension;
    return settings;
}

void finish(Tank& tank) {
    const std::size_t walls = tank.walls.position.size();
    tank.walls.velocity.resize(walls);
    tank.walls.acceleration.resize(walls, Vec3{0.1, 0, 0});
    tank.walls.volume.resize(walls, std::pow(dp, tank.settings.domain.dimension));
    tank.extra_force.reset(tank.water.position.size());
    tank.extra_force.add(tank.water.position.size() / 3, {1e-3, 0, 2e-3});
}

}  // namespace

Tank some_tank(int count) {
    Tank tank;
    constexpr int layers = 3;
    const double width = dp * count;
    auto& settings = tank.settings;
    settings = settings_of(0.5 * width, 3);
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
    finish(tank);
    return tank;
}

Tank some_channel(int count) {
    Tank tank = some_drop(count);
    tank.gravity = {0.2, -9.81, 0};
    tank.settings.domain.is_periodic[0] = true;
    tank.settings.domain.high.x = dp * count;
    tank.settings.domain.low.x = 0;
    for (int row = 1; row <= 3; ++row) {
        for (int x = 0; x < count; ++x) {
            tank.walls.position.push_back({(x + 0.5) * dp, (0.5 - row) * dp, 0});
            tank.walls.velocity.push_back({0.2, 0, 0});
            tank.walls.is_slippery.push_back(0);
            tank.walls.given_pressure.push_back(x % 5 == 0 ? 300 : -1);
        }
    }
    finish(tank);
    return tank;
}

Tank some_drop(int count) {
    Tank tank;
    const double width = dp * count;
    tank.settings = settings_of(width, 2);
    tank.settings.domain.low = {-width, -width, 0};
    tank.settings.domain.high = {2 * width, 2 * width, 0};
    tank.gravity = {};
    for (int y = 0; y < count; ++y) {
        for (int x = 0; x < count; ++x) {
            const Vec3 place{(x + 0.5) * dp, (y + 0.5) * dp, 0};
            tank.water.add(place, {0.3 * std::sin(20 * place.y), 0.2 * std::cos(15 * place.x), 0},
                           riprap::fluid::density_of(tank.settings, 9810 * (width - place.y)),
                           static_cast<std::int32_t>(tank.water.size()));
        }
    }
    finish(tank);
    return tank;
}

void Tank::step(riprap::fluid::ParticleScheme& scheme) {
    const riprap::TimeSpan span{time, 0.3 * settings.smoothing_length() / settings.sound_speed};
    report = {};
    scheme.update_density(water, walls, gravity, time > 0 ? span.dt : 0.5 * span.dt, report);
    drift(settings, water, 0.5 * span.dt);
    scheme.begin_forces(water, walls, span, gravity, report);
    scheme.describe_walls(gravity, about_walls);
    scheme.load_walls(water, walls, {});
    scheme.load_walls(water, walls, gravity);  // as light bodies make the driver do
    scheme.kick(water, walls, gravity, span, extra_force, report);
    drift(settings, water, 0.5 * span.dt);
    time += span.dt;
}

}  // namespace selftest
