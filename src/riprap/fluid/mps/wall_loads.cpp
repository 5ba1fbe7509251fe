// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/mps/mps.hpp"
#include "riprap/fluid/mps/mps_pairs.hpp"
#include "riprap/fluid/mps_operators/wall_pairs.hpp"
#include "riprap/fluid/particle/pair_sums.hpp"
#include "riprap/fluid/particle/sweep/zeros.hpp"

namespace riprap::fluid {

void Mps::average_at_walls(const BoundaryParticles& walls, const Vec3& gravity) {
    MpsScratch& s = scratch_;
    MpsAtWalls& at = s.at_walls;
    make_zeros(walls.position.size(), at.load_weight, at.load_pressure, at.load_moment);
    add_pair_sums(settings_, mps::PressureAtWalls{weight_}, side(s.around.predicted_walls),
                  side(s.around.predicted, s.water.pressure),
                  sinks(at.load_weight, at.load_pressure, at.load_moment, at.load_slope, at.load_push),
                  s.lists.walls_fluid);
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const double weight = s.at_walls.load_weight[w];
        const double head = settings_.rest_density * dot(gravity - walls.acceleration[w], s.at_walls.load_moment[w]);
        const double mean = weight > 0 ? (s.at_walls.load_pressure[w] + head) / weight : 0;
        s.walls.pressure[w] = s.walls.follows[w] != 0 ? mean : s.walls.given[w];
    });
}

void Mps::mirror_at_walls() {
    MpsScratch& s = scratch_;
    s.around.ones.assign(s.around.predicted.size(), 1.0);
    add_pair_sums(settings_, MpsPressureOnWalls{weight_}, side(s.around.predicted_walls),
                  side(s.around.predicted, s.around.ones, s.water.pressure),
                  sinks(s.at_walls.load_slope, s.at_walls.load_push, s.at_walls.load_spread), s.lists.walls_fluid);
    s.walls.pressure = s.walls.given;
}

void Mps::find_wall_loads(BoundaryParticles& walls, const Vec3& gravity) {
    MpsScratch& s = scratch_;
    const auto count = walls.position.size();
    make_zeros(count, s.at_walls.load_slope, s.at_walls.load_push, s.at_walls.load_spread);
    s.walls.pressure.resize(count);
    if (settings_.wall_pressure == MpsWallPressure::averaged) {
        average_at_walls(walls, gravity);
    } else {
        mirror_at_walls();
    }
    const double factor = lattice_.first_order() * settings_.particle_mass / settings_.rest_density;
    walls.pressure.resize(count);
    walls.pressure_force.resize(count);
    walls.viscous_force = s.walls.viscous_force;
    parallel::for_each(walls.size(), [&](std::int64_t entry) {
        const auto w = static_cast<std::size_t>(entry);
        const double head = dot(gravity - walls.acceleration[w], s.at_walls.moment[w]);
        const double seen = s.at_walls.weight[w] > 0 ? (s.at_walls.pressure[w] + head) / s.at_walls.weight[w] : 0;
        walls.pressure[w] = s.walls.follows[w] == 0 ? s.walls.given[w] : std::max(0.0, seen);
        const double m = s.walls.mirrors[w];
        const Vec3 carried = (1 + m) * s.at_walls.load_push[w] + s.walls.pressure[w] * s.at_walls.load_slope[w] +
                             m * symmetric_apply(s.at_walls.load_spread[w], s.walls.head[w]);
        walls.pressure_force[w] = factor * s.walls.share[w] * carried + s.walls.collision_force[w];
    });
}

}  // namespace riprap::fluid
