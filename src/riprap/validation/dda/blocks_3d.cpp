// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/core/quat.hpp"
#include "riprap/validation/block_trial.hpp"
#include "riprap/validation/dda/cases_3d.hpp"

namespace riprap::validation::dda {

namespace {

constexpr double gravity = 9.81, degree = M_PI / 180;

/// A cube of 1 m on a half-space, gravity tilted by the slope, at the overlap of its weight.
template <class Trial>
Trial block_on_slope(double slope, double friction, double dt) {
    Trial trial;
    const double stiffness = 1e8;
    add_material(trial.system, {2500, 3e9, 0.25}, {stiffness, stiffness, false, friction, 0, 0, 0.1});
    trial.system.gravity = gravity * Vec3{std::sin(slope), 0, -std::cos(slope)};
    add_block(trial.system, trial.state.blocks, {.shape = add_half_space(trial.system, {0, 0, 1}, 0)});
    add_box(trial.system, trial.state.blocks, {1, 1, 1},
            {.position = {0, 0, 0.5 - 2500 * gravity * std::cos(slope) / (4 * stiffness)}});
    trial.dt = dt;
    return trial;
}

/// Mean acceleration down the slope between 0.5 and 2 s, once friction has taken hold.
template <class Trial>
double sliding_acceleration(Trial trial) {
    trial.run_until(0.5);
    const double before = trial.velocity(1).x;
    trial.run_until(2);
    return (trial.velocity(1).x - before) / 1.5;
}

/// Way in `seconds` after the block has come to rest on its springs.
template <class Trial>
double creep(Trial trial, double seconds) {
    trial.run_until(3);
    const double before = trial.position(1).x;
    trial.run_until(3 + seconds);
    return trial.position(1).x - before;
}

/// Way of a block thrown down a slope that is flatter than its friction angle.
template <class Trial>
double stopping_way(Trial trial, double speed) {
    trial.run_until(0.5);
    trial.state.blocks.velocity[1].x = speed;
    const double before = trial.position(1).x;
    const double end = trial.time + 5;
    do {
        trial.step();
    } while (trial.velocity(1).x > 1e-6 && trial.time < end);
    return trial.position(1).x - before;
}

/// Way along the slope of the middle of a block 0.2 m wide and 1 m high, 2 s after the slope was raised to its angle by
/// 0.1 degrees a second.
template <class Trial>
double lean(double slope, double dt) {
    Trial trial;
    const double stiffness = 1e8, mass = 2500 * 0.2 * 0.5;
    add_material(trial.system, {2500, 1e9, 0.25}, {stiffness, stiffness, false, 0.25, 0, 0, 0.5});
    add_block(trial.system, trial.state.blocks, {.shape = add_half_space(trial.system, {0, 0, 1}, 0)});
    add_box(trial.system, trial.state.blocks, {0.2, 0.5, 1},
            {.position = {0, 0, 0.5 - mass * gravity / (4 * stiffness)}});
    trial.dt = dt;
    const double low = slope - 0.5 * degree;
    while (trial.time < 8) {
        const double angle = low + std::clamp(trial.time - 1, 0.0, 5.0) * 0.1 * degree;
        trial.system.gravity = gravity * Vec3{std::sin(angle), 0, -std::cos(angle)};
        trial.step();
    }
    return trial.position(1).x;
}

}  // namespace

void tipping_3d(const CaseSetting& /*setting*/, CaseReport& report) {
    const double slope = std::atan(0.2);
    for (const bool is_implicit : {true, false}) {
        const std::string name = is_implicit ? "implicit: " : "explicit: ";
        const auto lean_at = [&](double angle) {
            return is_implicit ? lean<ImplicitTrial>(angle, 1e-3) : lean<ExplicitTrial>(angle, 5e-5);
        };
        report.judge_below({name + "way of the middle, 0.1 deg below atan(b/h)", "m", "stands", 0, {}},
                           lean_at(slope - 0.1 * degree), 1e-3);
        report.judge({name + "way of the middle, 0.1 deg above it", "m", "tips", {}, {}}, lean_at(slope + 0.1 * degree),
                     0.02, 5);
    }
}

void sliding_block_3d(const CaseSetting& setting, CaseReport& report) {
    constexpr double fine = 1e-4;
    for (const double angle : {0.0, 10.0, 20.0}) {
        const double slope = 30 * degree, friction = std::tan(angle * degree);
        const double a = gravity * (std::sin(slope) - std::cos(slope) * friction);
        const auto name = fmt::format("30 deg, friction angle {} deg: acceleration, ", angle);
        report.judge({name + "implicit", "m/s^2", {}, a, {}},
                     sliding_acceleration(block_on_slope<ImplicitTrial>(slope, friction, 0.01)), Relative{1e-3});
        report.judge({name + "explicit", "m/s^2", {}, a, {}},
                     sliding_acceleration(block_on_slope<ExplicitTrial>(slope, friction, fine)), Relative{1e-3});
    }
    const double slope = 30 * degree, seconds = setting.is_full ? 60 : 5;
    report.judge_below({fmt::format("friction angle 30.1 deg: creep in {} s, implicit", seconds), "m", {}, 0, {}},
                       creep(block_on_slope<ImplicitTrial>(slope, std::tan(30.1 * degree), 0.01), seconds), 1e-6);
    report.judge({"friction angle 29.9 deg: slides, way in 5 s, implicit", "m", {}, {}, {}},
                 creep(block_on_slope<ImplicitTrial>(slope, std::tan(29.9 * degree), 0.01), 5), 0.1, 1);
    {
        const double friction = std::tan(40 * degree), speed = 3;
        const double way = speed * speed / (2 * gravity * (std::cos(slope) * friction - std::sin(slope)));
        report.judge({"thrown at 3 m/s, friction angle 40 deg: stopping way, implicit, step 1 ms", "m", {}, way, {}},
                     stopping_way(block_on_slope<ImplicitTrial>(slope, friction, 1e-3), speed), Relative{2e-3});
        report.judge({"thrown at 3 m/s, friction angle 40 deg: stopping way, explicit", "m", {}, way, {}},
                     stopping_way(block_on_slope<ExplicitTrial>(slope, friction, fine), speed), Relative{2e-3});
    }
}

void stack_3d(const CaseSetting& setting, CaseReport& report) {
    const int count = 10;
    const double stiffness = 1e8, modulus = 1e9;
    ImplicitTrial trial;
    add_material(trial.system, {2500, modulus, 0.25}, {stiffness, stiffness, false, 0.5});
    trial.system.gravity = {0, 0, -gravity};
    add_block(trial.system, trial.state.blocks, {.shape = add_half_space(trial.system, {0, 0, 1}, 0)});
    for (int i = 0; i < count; ++i) {
        add_box(trial.system, trial.state.blocks, {1, 1, 1}, {.position = {0, 0, 0.5 + i}});
    }
    trial.settle(400, 1e-15);
    double error = 0, overlap_error = 0;
    std::vector<double> push(at(count), 0);
    for (const auto& c : trial.scratch.contacts) {
        push[at(std::max(c.row_a, c.row_b))] -= c.springs.normal * c.trial.gap;
    }
    for (int i = 0; i < count; ++i) {
        const double weight = 2500 * gravity * (count - i);
        error = std::max(error, std::abs(push[at(i)] / weight - 1));
    }
    for (const auto& c : trial.scratch.contacts) {
        const double weight = 2500 * gravity * (count - std::max(c.row_a, c.row_b));
        overlap_error = std::max(overlap_error, std::abs(-c.trial.gap * 4 * stiffness / weight - 1));
    }
    report.judge_below({"push under every block over the weights above", "-", {}, 0, {}}, error, 1e-6);
    report.judge_below({"overlap of every corner over N/(4 k)", "-", {}, 0, {}}, overlap_error, 1e-6);
    // The stress of a block is the mean of the weights above and below it.
    double stress_error = 0;
    for (int i = 0; i < count; ++i) {
        const double mean = 2500 * gravity * (count - i - 0.5);
        const Mat3 stress = solid::affine::rows_at(trial.state.blocks.stress, at(i + 1));
        stress_error = std::max(stress_error, std::abs(-stress(2, 2) / mean - 1));
    }
    report.judge_below({"vertical stress over rho g depth of the centre", "-", {}, 0, {}}, stress_error, 1e-3);
    trial.dt = 0.01;
    const double before = trial.position(count).z;
    trial.step(setting.is_full ? 100000 : 1000);
    report.judge_below(
        {fmt::format("drift of the top block in {} steps", setting.is_full ? 100000 : 1000), "m", {}, 0, {}},
        norm(Vec3{trial.position(count).x, trial.position(count).y, trial.position(count).z - before}), 1e-8);
}

void rocking_3d(const CaseSetting&, CaseReport& report) {
    struct Block {
        double half_width, half_height;
    };
    for (const Block& size : {Block{0.25, 1.0}, Block{0.1, 0.5}}) {
        const double b = size.half_width, h = size.half_height, radius = std::hypot(b, h), alpha = std::atan(b / h);
        const double p2 = 3 * gravity / (4 * radius), start = 0.5 * alpha;
        ImplicitTrial trial;
        // Housner's block and floor are rigid: stiffer springs change the next peak by less than 1 %, at any step from
        // 0.05 to 0.5 ms. Those of 1e9 and 1e8 N/m a corner give a part of the impact back (1.080 and 1.155 of it).
        add_material(trial.system, {2500, 5e10, 0.2}, {1e10, 1e10, false, 2});
        trial.system.gravity = {0, 0, -gravity};
        add_block(trial.system, trial.state.blocks, {.shape = add_half_space(trial.system, {0, 0, 1}, 0)});
        // Turned about its lower edge at x = b, towards +x.
        const Quat turn = from_rotation_vector({0, start, 0});
        const Vec3 centre = Vec3{b, 0, 0} + rotate(turn, {-b, 0, h});
        add_box(trial.system, trial.state.blocks, {2 * b, 0.5, 2 * h},
                {.position = centre, .deformation = to_matrix(turn)});
        trial.dt = 2e-4;
        const auto tilt = [&] {
            const Mat3 f = solid::affine::rows_at(trial.state.blocks.deformation, 1);
            return std::atan2(f(0, 2), f(2, 2));
        };
        // Quarter period by quadrature: theta'' = p^2 sin(alpha - theta) towards upright.
        double theta = start, rate = 0, exact = 0;
        for (const double step = 1e-5; theta > 0; exact += step) {
            rate -= step * p2 * std::sin(alpha - theta);
            theta += step * rate;
        }
        double quarter = NAN, peak = 0;
        while (trial.time < 4 * exact) {
            const double before = tilt();
            trial.step();
            const double after = tilt();
            if (std::isnan(quarter) && before > 0 && after <= 0) {
                quarter = trial.time - trial.dt * after / (after - before);
            }
            if (!std::isnan(quarter)) {
                peak = std::max(peak, -after);
                if (-after < 0.5 * peak && peak > 1e-3) {
                    break;
                }
            }
        }
        const std::string name = fmt::format("b = {} m, h = {} m: ", b, h);
        report.judge({name + "time to upright", "s", {}, exact, {}}, quarter, Relative{5e-3});
        // Housner: the rate after the impact is (1 - 3/2 sin^2 alpha) of that before.
        const double ratio = 1 - 1.5 * std::sin(alpha) * std::sin(alpha);
        const double lifted = std::cos(alpha) + ratio * ratio * (std::cos(alpha - start) - std::cos(alpha));
        const double next = alpha - std::acos(std::min(1.0, lifted));
        report.judge({name + "next peak", "rad", {}, next, {}}, peak, 0.98 * next, 1.02 * next);
    }
}

}  // namespace riprap::validation::dda
