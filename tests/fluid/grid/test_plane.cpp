// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include "riprap/fluid/grid/plane.hpp"

namespace riprap::fluid::grid {
namespace {

TEST(SurfacePlane, volume_below_is_that_of_a_dense_sample_of_points) {
    for (const std::array<double, 3>& m : {std::array{0.2, 0.3, 0.5}, {0.0, 0.4, 0.6}, {0.1, 0.1, 0.8}}) {
        for (const double d : {0.05, 0.3, 0.5, 0.77}) {
            constexpr int n = 60;
            int below = 0;
            for (int q = 0; q < n * n * n; ++q) {
                below += (m[0] * (q % n + 0.5) + m[1] * (q / n % n + 0.5) + m[2] * (q / n / n + 0.5)) / n <= d ? 1 : 0;
            }
            EXPECT_NEAR(volume_below(m, d), static_cast<double>(below) / (n * n * n), 0.01);
        }
    }
}

TEST(SurfacePlane, the_plane_constant_gives_the_volume_back_to_round_off) {
    std::mt19937 random(3);
    const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (int i = 0; i < 5000; ++i) {
        std::array<double, 3> m{number(), number(), i % 3 == 0 ? 0 : number()};
        const double sum = m[0] + m[1] + m[2], volume = i % 7 == 0 ? 1e-9 * number() : number();
        for (double& c : m) {
            c /= sum;
        }
        EXPECT_NEAR(volume_below(m, plane_constant(m, volume)), volume, 2e-14);
    }
}

TEST(SurfacePlane, slabs_of_a_cell_add_up_to_its_fraction) {
    const CellPlane plane = place_plane({0.3, -0.5, 0.2}, 0.37);
    for (int axis = 0; axis < 3; ++axis) {
        const double low = slab_fraction(plane, axis, -0.5, -0.2), high = slab_fraction(plane, axis, -0.2, 0.5);
        EXPECT_NEAR(0.3 * low + 0.7 * high, 0.37, 1e-13) << axis;
    }
    EXPECT_GT(slab_fraction(plane, 0, -0.5, 0), slab_fraction(plane, 0, 0, 0.5));  // the normal points out of the water
}

}  // namespace
}  // namespace riprap::fluid::grid
