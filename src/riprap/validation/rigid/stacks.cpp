// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/validation/rigid/cases.hpp"
#include "riprap/validation/settle.hpp"

namespace riprap::validation::rigid {

namespace {

constexpr double gravity = 9.81, density = 2500;

struct StackScene {
    SceneBuilder scene;
    ShapeId shape;
    explicit StackScene(const Vec3& size, double stiffness, double friction) {
        scene.add_material({.name = "rock", .density = density, .normal_stiffness = stiffness, .friction = friction});
        BodySpec ground;
        ground.name = "ground";
        ground.shape = scene.add_half_space({0, 0, 1}, 0);
        ground.drive = body::Drive::fixed;
        scene.add_body(ground);
        shape = scene.add_shape(geometry::box(size));
        scene.model.gravity.value = {0, 0, -gravity};
    }
    void add(const Vec3& position, const Vec3& velocity = {}) {
        BodySpec block;
        block.name = fmt::format("block{}", scene.model.bodies.size());
        block.shape = shape;
        block.pose.position = position;
        block.velocity = velocity;
        scene.add_body(block);
    }
};

/// Ten blocks on each other, at rest.
void stack_of_weights(CaseReport& report) {
    constexpr int count = 10;
    const double side = 0.2, stiffness = 1e9, weight = density * side * side * side * gravity;
    StackScene stack({side, side, side}, stiffness, 0.5);
    for (int i = 0; i < count; ++i) {
        stack.add({0, 0, (i + 0.5) * side});
    }
    Trial trial(std::move(stack.scene));
    trial.follow_energy(false);
    settle(trial, 40000);  // the slowest mode of ten blocks is some 20 times slower than the fastest
    double error = 0;
    for (const contact::ShownContact& row : trial.contacts()) {
        const int below = std::min(row.a, row.b).value;  // ground is 0
        error = std::max(error, std::abs(row.normal_force / ((count - below) * weight) - 1));
    }
    report.judge_below({"stack of 10, force of every contact over the weight above", "-", {}, {}, {}}, error, 1e-6);
    // The ground has no field of its own, and aligned faces lose 2 d/a of their stiffness: that is below 1e-5 here.
    const double one_side = stiffness * side * side / (0.5 * side);
    double sunk = count * weight / one_side;
    for (int i = 1; i < count; ++i) {
        sunk += (count - i) * weight / (2 * one_side);
    }
    report.judge({"stack of 10, settlement of the top", "m", {}, sunk, {}},
                 (count - 0.5) * side - trial.position(BodyId{count}).z, Relative{1e-3});
    std::vector<Vec3> before = trial.state().bodies.position;
    for (int i = 0; i < 100000; ++i) {
        trial.step();
    }
    double drift = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        drift = std::max(drift, norm(trial.state().bodies.position[i] - before[i]));
    }
    report.judge_below({"stack of 10, drift in 1e5 steps", "m", {}, {}, {}}, drift, 1e-8);
}

/// Bricks 1 m long on the edge of a table, each leaning out over the one below by `share` of the harmonic limit
/// 1/(2 k) m, k counted from the top. The contacts must be stiff: on an elastic base a stack tips when its weight still
/// passes 1.5 (2 h N/(9 K))^(1/3) inside the edge (tipping.hpp), which must be well under
/// the hundredth of an overhang that is tested. @returns the largest motion of a brick in `duration` after settling [m]
double lean(int count, double share, double duration) {
    const Vec3 size{1, 0.5, 0.2};
    StackScene stack(size, 2e11, 0.7);
    BodySpec table;
    table.name = "table";
    table.shape = stack.shape;
    table.drive = body::Drive::fixed;
    table.pose.position = {-0.5 * size.x, 0, 0.5 * size.z};  // its edge is x = 0
    stack.scene.add_body(table);
    double edge = 0;
    for (int k = count; k >= 1; --k) {
        edge += share * size.x / (2 * k);
        stack.add({edge - 0.5 * size.x, 0, (count - k + 1.5) * size.z});
    }
    Trial trial(std::move(stack.scene));
    trial.follow_energy(false);
    settle(trial, 100000);
    const std::vector<Vec3> before = trial.state().bodies.position;
    double moved = 0;
    const double end = trial.time() + duration;
    while (trial.time() < end && moved < 0.05) {
        trial.step();
        for (std::size_t i = 0; i < before.size(); ++i) {
            moved = std::max(moved, norm(trial.state().bodies.position[i] - before[i]));
        }
    }
    return moved;
}

}  // namespace

void stacks(const CaseSetting& setting, CaseReport& report) {
    stack_of_weights(report);
    const int most = setting.is_full ? 6 : 2;  // six take minutes
    for (int count = 1; count <= most; ++count) {
        double limit = 0;
        for (int k = 1; k <= count; ++k) {
            limit += 0.5 / k;
        }
        const std::string name = fmt::format("{} bricks, largest overhang {:.6g} m", count, limit);
        report.judge_below({name + ": motion in 10 s at 0.99 of it", "m", {}, {}, {}}, lean(count, 0.99, 10), 1e-4);
        report.judge({name + ": motion at 1.01 of it (falls)", "m", {}, {}, {}}, lean(count, 1.01, 10), 0.05, 10);
    }
}

}  // namespace riprap::validation::rigid
