// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "riprap/bench/sph_pairs.hpp"
#include "riprap/bench/sph_scene.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/sweep/sweep.hpp"

namespace riprap::bench {

using fluid::component;
using fluid::field;
using fluid::sink;
using fluid::sink_component;
using fluid::SweepScratch;

/// One set of particles with the numbers that both pairs read and the sums that they make.
struct PassSide {
    const std::vector<Vec3>& position;
    const std::vector<Vec3>& velocity;
    std::vector<double> density, excess, volume, pressure_term, density_rate;
    std::vector<Vec3> acceleration;

    PassSide(const std::vector<Vec3>& x, const std::vector<Vec3>& v, std::vector<double> rho, const SphConstants& c)
        : position(x), velocity(v), density(std::move(rho)), density_rate(x.size()), acceleration(x.size()) {
        for (const double r : density) {
            const double stiffness = c.rest_density * c.sound_speed * c.sound_speed / 7;
            excess.push_back(r - c.rest_density);
            volume.push_back(c.particle_mass / r);
            pressure_term.push_back(stiffness * (std::pow(r / c.rest_density, 7) - 1) / (r * r));
        }
    }
    fluid::SweepSide<5> density_side() const {
        return {position,
                {component(velocity, 0), component(velocity, 1), component(velocity, 2), field(excess), field(volume)}};
    }
    fluid::SweepSide<5> force_side() const {
        return {position,
                {component(velocity, 0), component(velocity, 1), component(velocity, 2), field(pressure_term),
                 field(density)}};
    }
    std::array<fluid::FieldSink, 3> force_sinks() {
        return {sink_component(acceleration, 0), sink_component(acceleration, 1), sink_component(acceleration, 2)};
    }
};

/// Both sweeps over water and walls with the physics of the peers: what docs/howto/benchmarks.md compares.
class Pass {
 public:
    explicit Pass(const SphColumn& column)
        : column_(column),
          constants_{fluid::WendlandC2(column.settings.smoothing_length(), 3),
                     column.settings.smoothing_length(),
                     column.settings.sound_speed,
                     column.settings.rest_density,
                     column.settings.particle_mass,
                     0.1,
                     0.1,
                     column.gravity},
          reach_{column.settings.support_radius(), column.settings.domain},
          water_(column_.water.position, column_.water.velocity, column_.water.density, constants_),
          walls_(column_.walls.position, column_.walls.velocity,
                 std::vector<double>(column_.walls.position.size(), constants_.rest_density), constants_) {}
    Pass(const Pass&) = delete;
    Pass& operator=(const Pass&) = delete;

    /// One pass of a step: the water moves by half a step before each sweep.
    void operator()() {
        move();
        const DensityRatePair density{constants_};
        exchange_within(density, reach_, water_.density_side(), {sink(water_.density_rate)}, water_water_);
        exchange(density, reach_, water_.density_side(), walls_.density_side(), {sink(water_.density_rate)},
                 {sink(walls_.density_rate)}, water_walls_);
        move();
        const AccelerationPair force{constants_};
        exchange_within(force, reach_, water_.force_side(), water_.force_sinks(), water_water_);
        exchange(force, reach_, water_.force_side(), walls_.force_side(), water_.force_sinks(), walls_.force_sinks(),
                 water_walls_);
    }
    /// Directed pairs that act.
    double count_pairs() {
        std::vector<double> in_water(water_.position.size()), in_walls(walls_.position.size());
        const auto count = [&](const PassSide& a, const PassSide& b, std::vector<double>& sum, SweepScratch& scratch) {
            sweep(CountPair{constants_}, reach_, {a.position, {}}, {b.position, {}}, {sink(sum)}, scratch);
        };
        SweepScratch water_water, water_walls, walls_water;
        count(water_, water_, in_water, water_water);
        count(water_, walls_, in_water, water_walls);
        count(walls_, water_, in_walls, walls_water);
        double pairs = 0;
        for (const auto* counts : {&in_water, &in_walls}) {
            for (const double n : *counts) {
                pairs += n;
            }
        }
        return pairs;
    }

 private:
    void move() {
        const fluid::SphSettings& s = column_.settings;
        const double half_step = 0.5 * s.courant * s.smoothing_length() / (1.1 * s.sound_speed);
        parallel::for_each(column_.water.size(), [&](std::int64_t entry) {
            const auto i = static_cast<std::size_t>(entry);
            column_.water.position[i] += half_step * column_.water.velocity[i];
        });
    }
    SphColumn column_;
    SphConstants constants_;
    fluid::SweepReach reach_;
    PassSide water_, walls_;
    SweepScratch water_water_, water_walls_;
};

}  // namespace riprap::bench
