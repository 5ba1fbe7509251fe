// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/sph_scene.hpp"

#include <array>
#include <cmath>
#include <random>

#include "riprap/fluid/particle/sort.hpp"

namespace riprap::bench {

namespace {
constexpr std::array<int, 3> finest{60, 50, 50};
constexpr int wall_layers = 3;
}  // namespace

SphColumn sph_column(double smoothing_ratio, int coarsening) {
    const double spacing = 0.01 * coarsening;  // [m]
    const std::array<int, 3> lattice{finest[0] / coarsening, finest[1] / coarsening, finest[2] / coarsening};
    SphColumn column;
    fluid::SphSettings& s = column.settings;
    const double height = lattice[2] * spacing;
    s.spacing = spacing;
    s.smoothing_ratio = smoothing_ratio;
    s.particle_mass = s.rest_density * spacing * spacing * spacing;
    s.sound_speed = 10 * std::sqrt(2 * norm(column.gravity) * height);
    s.domain.low = {-0.2, -0.2, -0.2};
    s.domain.high = {2, 0.7, 0.7};

    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::vector<Vec3> wall_places;
    for (int k = -wall_layers; k < lattice[2]; ++k) {
        for (int j = -wall_layers; j < lattice[1] + wall_layers; ++j) {
            for (int i = -wall_layers; i < lattice[0]; ++i) {
                const Vec3 place = spacing * Vec3{i + 0.5, j + 0.5, k + 0.5};
                if (i >= 0 && j >= 0 && j < lattice[1] && k >= 0) {
                    const double depth = height - place.z;
                    const Vec3 jitter{unit(random), unit(random), unit(random)};
                    const double density =
                        s.rest_density * (1 + norm(column.gravity) * depth / (s.sound_speed * s.sound_speed));
                    column.water.add(place + 0.1 * spacing * jitter, {0.1 * s.sound_speed * place.z / height, 0, 0},
                                     density, static_cast<std::int32_t>(column.water.size()));
                } else {
                    wall_places.push_back(place);
                }
            }
        }
    }
    sort_by_place(column.water, s.domain, spacing);

    for (const std::uint32_t w : order_by_place(wall_places, s.domain, spacing)) {
        column.walls.position.push_back(wall_places[w]);
    }
    const std::size_t count = wall_places.size();
    column.walls.velocity.resize(count);
    column.walls.acceleration.resize(count);
    column.walls.volume.assign(count, spacing * spacing * spacing);
    column.walls.is_slippery.resize(count);
    column.walls.pressure.resize(count);
    column.walls.pressure_force.resize(count);
    column.walls.viscous_force.resize(count);
    return column;
}

}  // namespace riprap::bench
