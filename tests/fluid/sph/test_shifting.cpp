// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdint>
#include <numbers>

#include "fluid/sph/water.hpp"
#include "riprap/fluid/particle/kernel.hpp"

namespace riprap::fluid::testing {
namespace {

constexpr int across = 24;

/// Vortices in a box that repeats, their particles a tenth of a spacing off a lattice, after one step.
Water stirred(double shifting) {
    const double dp = 1.0 / across, wave = 2 * std::numbers::pi;
    Water water;
    water.settings = settings_2d(dp, 10);
    water.settings.domain = {{0, 0, 0}, {1, 1, 0}, {true, true, false}, 2};
    water.settings.shifting = shifting;
    std::uint32_t seed = 1;
    const auto jitter = [&] {
        seed = seed * 1664525U + 1013904223U;
        return 0.2 * dp * (static_cast<double>(seed) / 4294967296.0 - 0.5);
    };
    for_lattice(dp, 1, 1, [&](double x, double y) {
        x += jitter();
        y += jitter();
        water.add_particle({x, y, 0},
                           {-std::cos(wave * x) * std::sin(wave * y), std::sin(wave * x) * std::cos(wave * y), 0});
    });
    water.step();
    return water;
}

/// Sum over the neighbours of particle i of the kernel [1/m^2], itself included, in a box that repeats every metre
double kernel_sum(const Water& water, std::size_t i) {
    const WendlandC2 kernel(water.settings.smoothing_length(), 2);
    double sum = 0;
    for (const Vec3& x : water.state.position) {
        Vec3 d = x - water.state.position[i];
        d.x -= std::round(d.x);
        d.y -= std::round(d.y);
        sum += kernel.value(norm(d));
    }
    return sum;
}

TEST(Shifting, takes_from_density_what_it_takes_from_the_sums_of_the_kernel) {
    const Water without = stirred(0), with = stirred(0.1);  // the identity is of first order in the shift
    double of_density = 0, of_sums = 0, farthest = 0;
    for (std::size_t i = 0; i < with.state.position.size(); ++i) {
        farthest = std::max(farthest, norm(with.state.position[i] - without.state.position[i]));
        of_density += std::log(with.state.density[i] / without.state.density[i]);
        of_sums += (kernel_sum(with, i) - kernel_sum(without, i)) / (across * across);
    }
    EXPECT_GT(farthest, 1e-5 * with.settings.spacing);
    EXPECT_LT(of_sums, 0);
    EXPECT_NEAR(of_density, of_sums, 0.02 * std::abs(of_sums));
}

}  // namespace
}  // namespace riprap::fluid::testing
