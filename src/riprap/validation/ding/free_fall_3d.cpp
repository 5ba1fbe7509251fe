// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/validation/block_trial.hpp"
#include "riprap/validation/ding/cases_3d.hpp"

namespace riprap::validation::ding {

namespace {

using solid::affine::rows_at;

constexpr double gravity = 9.81;

ImplicitTrial one_block(const Vec3& size, const Vec3& spin) {
    ImplicitTrial trial;
    add_material(trial.system, {2500, 5e10, 0.2}, {});
    trial.settings.max_displacement = 1e3;
    add_box(trial.system, trial.state.blocks, size, {.spin = spin});
    return trial;
}

/// A block of 1 x 2 x 3 m turned about a principal axis with a small spin across: the largest angle in ten turns
/// between the body's axis and the direction it began in [rad].
double wander(int axis, int steps_per_turn) {
    Vec3 spin{1e-3, 1e-3, 1e-3};
    spin[axis] = 2 * M_PI;
    ImplicitTrial trial = one_block({1, 2, 3}, spin);
    trial.dt = 1.0 / steps_per_turn;
    double most = 0;
    for (int i = 0; i < 10 * steps_per_turn; ++i) {
        trial.step();
        const Mat3 f = rows_at(trial.state.blocks.deformation, 0);
        most = std::max(most, std::acos(std::clamp(f(axis, axis), -1.0, 1.0)));
    }
    return most;
}

}  // namespace

void free_fall_3d(const CaseSetting&, CaseReport& report) {
    for (const double dt : {0.1, 0.01, 0.001}) {
        ImplicitTrial trial = one_block({1, 1, 1}, {});
        trial.system.gravity = {0, 0, -gravity};
        trial.dt = dt;
        double speed_error = 0, way_error = 0;
        while (trial.time < 1.47) {
            trial.step();
            speed_error = std::max(speed_error, std::abs(trial.velocity(0).z + gravity * trial.time));
            way_error = std::max(way_error, std::abs(trial.position(0).z + 0.5 * gravity * trial.time * trial.time));
        }
        report.judge_below({fmt::format("step {} s: error of the speed", dt), "m/s", "perfect agreement", 0, {}},
                           speed_error, 1e-12);
        report.judge_below({fmt::format("step {} s: error of the way", dt), "m", "perfect agreement", 0, {}}, way_error,
                           1e-12);
    }
    {
        ImplicitTrial trial = one_block({1, 2, 3}, {0.3, 2 * M_PI, 0.2});
        trial.dt = 1e-3;
        const Vec3 before = measure(trial.system, trial.state.blocks).angular_momentum;
        const double volume = determinant(rows_at(trial.state.blocks.deformation, 0));
        double drift = 0, growth = 0;
        for (int i = 0; i < 1000; ++i) {
            trial.step();
            drift = std::max(drift, norm(measure(trial.system, trial.state.blocks).angular_momentum - before));
            growth = std::max(growth, std::abs(determinant(rows_at(trial.state.blocks.deformation, 0)) / volume - 1));
        }
        report.judge_below({"tumbling, one turn: drift of angular momentum over its size", "-", {}, 0, {}},
                           drift / norm(before), 1e-3);
        report.judge_below({"tumbling, one turn: change of volume", "-", {}, 0, {}}, growth, 1e-10);
    }
    report.judge_below({"spin about the axis of the greatest moment stays: wander in ten turns", "rad", {}, {}, {}},
                       wander(0, 500), 0.01);
    report.judge({"spin about the middle axis does not: wander in ten turns", "rad", {}, {}, {}}, wander(1, 500), 1,
                 M_PI);
    report.judge_below({"spin about the axis of the least moment stays: wander in ten turns", "rad", {}, {}, {}},
                       wander(2, 500), 0.01);
}

}  // namespace riprap::validation::ding
