// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "riprap/coupling/added_mass.hpp"

namespace riprap::coupling {
namespace {

/// A body of mass 1 that water answers with the force -added a: a = (load - added a) / 1.
struct Feedback {
    Vec3 load{0, 0, 5};
    Vec3 added;
    double added_inertia;
    std::vector<body::Acceleration> operator()(const std::vector<body::Acceleration>& a) const {
        const Vec3& x = a[0].linear;
        return {
            {load - Vec3{added.x * x.x, added.y * x.y, added.z * x.z}, Vec3{1, 0, 0} - added_inertia * a[0].angular}};
    }
};

int solve(const Feedback& water, double kappa, std::vector<body::Acceleration>& a, double& residual) {
    const std::vector<double> mass{1}, inertia{1}, estimate{kappa};
    AddedMassIteration iteration(mass, inertia, estimate);
    while (!iteration.accept(a, water(a), 9.81)) {
    }
    residual = iteration.residual();
    return iteration.passes();
}

TEST(AddedMass, a_body_a_hundred_times_lighter_than_its_added_mass_settles_in_a_few_passes) {
    for (const double added : {0.5, 5.0, 100.0}) {
        for (const double wrong : {0.3, 1.0, 3.0}) {  // the estimate is rough
            std::vector<body::Acceleration> a(1);
            double residual = 0;
            const int passes = solve({{3, 1, 5}, {added, added, added}, added}, added * wrong, a, residual);
            EXPECT_LE(passes, 6) << added << ' ' << wrong;
            EXPECT_LE(residual, 1e-2);
            EXPECT_NEAR(a[0].linear.z, 5 / (1 + added), 1e-2 * (9.81 + 5) / (1 + added) + 1e-12);
        }
    }
}

TEST(AddedMass, a_body_whose_added_mass_differs_with_direction_settles_too) {
    std::vector<body::Acceleration> a(1);
    double residual = 0;
    EXPECT_LE(solve({{3, 1, 5}, {20, 40, 60}, 30}, 30, a, residual), 12);
    EXPECT_LE(residual, 1e-2);
}

TEST(AddedMass, light_bodies_that_feel_each_other_through_the_water_settle) {
    // Four bodies in a row, each with 30 times its mass of water about it and 14 of that shared with its neighbours:
    // four directions that differ, so four passes beyond the plain ones and one to see it.
    const std::vector<double> mass(4, 1.0), inertia(4, 1.0), estimate(4, 20.0);
    const auto water = [](const std::vector<body::Acceleration>& a) {
        std::vector<body::Acceleration> answer(4);
        for (std::size_t b = 0; b < 4; ++b) {
            Vec3 sum = 30.0 * a[b].linear;
            sum += b > 0 ? -14.0 * a[b - 1].linear : Vec3{};
            sum += b < 3 ? -14.0 * a[b + 1].linear : Vec3{};
            answer[b].linear = Vec3{0, 0, b == 0 ? 50.0 : -9.81} - sum;
        }
        return answer;
    };
    AddedMassIteration iteration(mass, inertia, estimate);
    std::vector<body::Acceleration> a(4);
    while (!iteration.accept(a, water(a), 9.81)) {
    }
    EXPECT_TRUE(iteration.is_settled());
    EXPECT_LE(iteration.passes(), AddedMassIteration::plain + 5);
    const std::vector<body::Acceleration> found = water(a);
    for (std::size_t b = 0; b < 4; ++b) {
        EXPECT_NEAR(found[b].linear.z, a[b].linear.z, 0.02 * (9.81 + std::abs(a[b].linear.z)));
    }
}

TEST(AddedMass, what_never_settles_ends_after_the_stated_number_of_passes_and_says_so) {
    const std::vector<double> mass{1}, inertia{1}, estimate{5};
    AddedMassIteration iteration(mass, inertia, estimate);
    std::vector<body::Acceleration> a(1);
    int pass = 0;
    const auto contrary = [&] {  // answers that have nothing to do with what was asked
        const double load = ++pass % 3 == 0 ? -100.0 : 70.0;
        return std::vector<body::Acceleration>{{{0, 0, load}, {}}};
    };
    while (!iteration.accept(a, contrary(), 9.81)) {
    }
    EXPECT_EQ(iteration.passes(), AddedMassIteration::most);
    EXPECT_FALSE(iteration.is_settled());
    EXPECT_GT(iteration.residual(), AddedMassIteration::tolerance);
}

TEST(AddedMass, a_body_that_jumps_between_wet_and_dry_takes_the_best_of_its_passes) {
    // Water that pushes as soon as the body does not flee from it: no acceleration causes itself.
    const std::vector<double> mass{1}, inertia{1}, estimate{5};
    const auto water = [](double a) { return a < 20 ? 400 - 8 * a : -9.81; };
    AddedMassIteration iteration(mass, inertia, estimate);
    std::vector<body::Acceleration> a(1);
    double least = 1e300, last = 0;
    bool is_last = false;
    while (!is_last) {
        const double z = a[0].linear.z;
        is_last = iteration.accept(a, std::vector<body::Acceleration>{{{0, 0, water(z)}, {}}}, 9.81);
        last = iteration.residual();
        least = std::min(least, last);
    }
    EXPECT_FALSE(iteration.is_settled());
    EXPECT_EQ(last, least);
}

TEST(AddedMass, a_heavy_body_takes_one_pass) {
    std::vector<body::Acceleration> a(1);
    double residual = 0;
    EXPECT_EQ(solve({{3, 1, 5}, {0.05, 0.05, 0.05}, 0.05}, 0.05, a, residual), 1);
    EXPECT_EQ(a[0].linear, Vec3{});  // the guess is not touched
}

}  // namespace
}  // namespace riprap::coupling
