// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <vector>

#include "riprap/bench/sph_pairs.hpp"
#include "riprap/fluid/particle/sweep/sweep.hpp"

namespace riprap::fluid {

/// Jittered lattice of particles with all fields that the pairs of the bench read.
struct Sample {
    double spacing{0.01};
    Domain domain;
    std::vector<Vec3> position, velocity;
    std::vector<double> density, excess, volume, pressure_term;
    bench::SphConstants constants{};

    SweepReach reach() const { return {2 * constants.smoothing_length, domain}; }
    SweepSide<5> density_side() const {
        return {position,
                {component(velocity, 0), component(velocity, 1), component(velocity, 2), field(excess), field(volume)}};
    }
    SweepSide<5> force_side() const {
        return {position,
                {component(velocity, 0), component(velocity, 1), component(velocity, 2), field(pressure_term),
                 field(density)}};
    }
    std::size_t size() const { return position.size(); }
};

/// @param counts  particles along each axis; counts[2] is ignored in 2D
inline Sample jittered_lattice(int dimension, std::array<int, 3> counts, double smoothing_ratio, Vec3 offset = {},
                               unsigned seed = 7) {
    Sample s;
    s.domain.dimension = dimension;
    const double dp = s.spacing;
    const double h = smoothing_ratio * dp;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int k = 0; k < (dimension == 2 ? 1 : counts[2]); ++k) {
        for (int j = 0; j < counts[1]; ++j) {
            for (int i = 0; i < counts[0]; ++i) {
                const Vec3 jitter = 0.25 * dp * Vec3{unit(random), unit(random), dimension == 2 ? 0 : unit(random)};
                s.position.push_back(offset + dp * Vec3{i + 0.5, j + 0.5, dimension == 2 ? 0 : k + 0.5} + jitter);
                s.velocity.push_back({unit(random), unit(random), dimension == 2 ? 0 : unit(random)});
                s.density.push_back(1000 + 5 * unit(random));
            }
        }
    }
    const double cell = dimension == 2 ? dp * dp : dp * dp * dp;
    s.constants = {WendlandC2(h, dimension), h, 20, 1000, 1000 * cell, 0.1, 0.1, {0, 0, -9.81}};
    for (const double rho : s.density) {
        const double pressure = 1000 * 400 / 7.0 * (std::pow(rho / 1000, 7) - 1) + 2e3;
        s.excess.push_back(rho - 1000);
        s.volume.push_back(s.constants.particle_mass / rho);
        s.pressure_term.push_back(pressure / (rho * rho));
    }
    s.domain.low = offset;
    s.domain.high = offset + dp * Vec3{double(counts[0]), double(counts[1]), double(counts[2])};
    return s;
}

}  // namespace riprap::fluid
