// SPDX-License-Identifier: Apache-2.0
// Bodies as unknowns of the pressure equation.
#include <gtest/gtest.h>

#include "fluid/mps/basin.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::fluid::testing {
namespace {

/// A column of water on a floor in two halves, each a light body that something else pushes upwards.
struct Pistons {
    Basin basin;
    LooseBodies bodies;
    std::vector<Vec3> centre;
    std::vector<Twist> acceleration{2};
    double push{60}, dt{0};

    explicit Pistons(double mass) {
        constexpr long cells = 12;
        constexpr double depth = 0.5;
        basin.settings = mps_settings(2, depth / cells, 2 * std::sqrt(9.81 * depth));
        basin.settings.tolerance = 1e-10;
        basin.gravity = {0, -9.81, 0};
        add_tank(
            basin, cells, cells + 4, true, [=](const Vec3& x) { return 1000 * 9.81 * (depth - x.y); },
            [=](long, long j) { return j < cells; });
        centre = {{0.25 * depth, -0.1, 0}, {0.75 * depth, -0.1, 0}};
        for (const Vec3& x : basin.walls.position) {
            const bool is_floor = x.y < 0 && x.x > 0 && x.x < depth;
            const int half = x.x < 0.5 * depth ? 0 : 1;
            bodies.of_wall.push_back(is_floor ? half : -1);
            bodies.arm.push_back(x - centre[static_cast<std::size_t>(half)]);
        }
        bodies.lightness.assign(2, 1 / mass * Vec3{1, 1, 1});
        bodies.inverse_inertia.assign(2, {0, 0, 200 / mass, 0, 0, 0});
        dt = basin.limit().limit;
        drift(basin.settings, basin.state, 0.5 * dt);
        basin.begin_forces(basin.gravity, dt);
    }

    /// Loads walls that accelerate with their bodies. @returns what the loads give beyond that
    std::vector<Twist> residual() {
        for (std::size_t w = 0; w < bodies.of_wall.size(); ++w) {
            if (bodies.of_wall[w] >= 0) {
                const Twist& a = acceleration[static_cast<std::size_t>(bodies.of_wall[w])];
                basin.walls.acceleration[w] = a.linear + cross(a.angular, bodies.arm[w]);
                basin.walls.velocity[w] = 0.5 * dt * basin.walls.acceleration[w];  // at mid-step, from rest
            }
        }
        basin.verbs().load_walls(basin.state, basin.walls, basin.gravity);
        EXPECT_TRUE(basin.verbs().solved().is_converged());
        std::vector<Twist> missing(2);
        for (std::size_t b = 0; b < 2; ++b) {
            Vec3 force{0, push / bodies.lightness[b].y, 0}, torque{};
            for (std::size_t w = 0; w < bodies.of_wall.size(); ++w) {
                if (bodies.of_wall[w] == static_cast<int>(b)) {
                    force += basin.walls.pressure_force[w];
                    torque += cross(bodies.arm[w], basin.walls.pressure_force[w]);
                }
            }
            missing[b] = {bodies.lightness[b].y * force - acceleration[b].linear,
                          bodies.inverse_inertia[b] * torque - acceleration[b].angular};
        }
        return missing;
    }
    std::vector<Twist> correction(const std::vector<Twist>& missing) {
        std::vector<Twist> change(2);
        EXPECT_TRUE(basin.verbs().correct(bodies, missing, change));
        return change;
    }
    void correct(const std::vector<Twist>& missing) {
        const std::vector<Twist> change = correction(missing);
        for (std::size_t b = 0; b < 2; ++b) {
            acceleration[b].linear += change[b].linear;
            acceleration[b].angular += change[b].angular;
        }
    }
};

double largest(const std::vector<Twist>& twists) {
    double most = 0;
    for (const Twist& t : twists) {
        most = std::max({most, norm(t.linear), 0.1 * norm(t.angular)});
    }
    return most;
}

// The water is twelve times as heavy as what carries it: repetition would diverge.
TEST(BodiesInPressure, newtons_method_finds_the_accelerations_of_light_pistons) {
    Pistons pistons(10);
    const double first = largest(pistons.residual());
    EXPECT_GT(first, 30);
    pistons.correct(pistons.residual());
    const double second = largest(pistons.residual());
    pistons.correct(pistons.residual());
    EXPECT_LT(second, 1e-4 * first);
    EXPECT_LT(largest(pistons.residual()), 1e-6 * first);
}

TEST(BodiesInPressure, a_correction_has_the_same_bits_with_two_threads) {
    const auto change = [](int threads) {
        parallel::set_thread_count(threads);
        Pistons pistons(10);
        const Twist first = pistons.correction(pistons.residual())[0];
        parallel::set_thread_count(1);
        return first;
    };
    const Twist one = change(1), two = change(2);
    EXPECT_EQ(one.linear, two.linear);
    EXPECT_EQ(one.angular, two.angular);
}

}  // namespace
}  // namespace riprap::fluid::testing
