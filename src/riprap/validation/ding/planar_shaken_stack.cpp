// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/core/index.hpp"
#include "riprap/validation/dda/planar_trial.hpp"
#include "riprap/validation/ding/planar_cases.hpp"

namespace riprap::validation::ding {

using geometry::Vec2;

namespace {

constexpr int blocks = 7;
constexpr double side = 0.048;           // of a block [m]
constexpr double peak = 2.15;            // of the table's acceleration in figure 3.4 [m/s^2]
constexpr double limit = 9.81 / blocks;  // g b/H, at which the stack rocks [m/s^2]

/// Seven blocks on a table that shakes with an amplitude that grows evenly [Ding2021, section 3.3.2].
struct Stack {
    double frequency, from, to, seconds;
    PlanarTrial trial;
    std::int32_t base{0}, lowest{0};
    std::int32_t left{0}, right{0};  ///< corners under the lowest block
    double left_start{0}, right_start{0}, table_start{0};
    double table_way{0};    ///< integral of the velocity of the table [m]
    double table_error{0};  ///< largest so far, over the amplitude of the displacement [-]
    double slip{0};         ///< of a block on the one below, largest so far [m]
    double uplift{0};       ///< of a corner under the lowest block, largest so far [m]

    Stack(double f, double a, double b, double duration);
    Stack(const Stack&) = delete;  // the table's velocity is a function of this stack
    Stack& operator=(const Stack&) = delete;

    double omega() const { return 2 * std::numbers::pi * frequency; }
    double amplitude(double t) const { return from + (to - from) * t / seconds; }
    double height(std::int32_t corner) const { return place_of(trial.state, lowest, trial.model.corner[at(corner)]).y; }
    /// Way of the middle of the underside of block k along what it stands on [m].
    double slip_of(int k) const {
        const double under = place_of(trial.state, lowest + k, {0, -0.5 * side}).x;
        return under - (k == 0 ? trial.center(base).x : place_of(trial.state, lowest + k - 1, {0, 0.5 * side}).x);
    }
    void step();
};

Stack::Stack(double f, double a, double b, double duration)
    : frequency(f),
      from(a),
      to(b),
      seconds(duration),
      trial({2028, 5e10, 0.25}, {.normal_stiffness = 1e7,
                                 .shear_stiffness = 4e6,
                                 .friction = std::tan(34 * std::numbers::pi / 180),
                                 .damping_ratio = 0.2}) {
    trial.model.thickness = 0.029;
    trial.settings = solid::planar_dda::settings_for(0.34, 0.005);
    base = trial.add_box({-0.3, -0.05}, {0.6, 0.05}, true);
    lowest = base + 1;
    for (int k = 0; k < blocks; ++k) {
        trial.add_box({-0.5 * side, k * side}, {side, side});
    }
    trial.settle(0.01, 400);
    trial.dt = 1e-3;
    // velocity of the table: its acceleration is amplitude(t) sin(omega t) but for the slow growth
    trial.base_velocity = [this](double t) { return Vec2{-amplitude(t) / omega() * std::cos(omega() * t), 0}; };
    trial.state.rates[6 * at(base)] = -from / omega();
    for (int k = 0; k < blocks; ++k) {
        trial.set_velocity(lowest + k, {-from / omega(), 0});
    }
    left = trial.model.corner_begin[at(lowest)];
    right = left + 1;
    left_start = height(left);
    right_start = height(right);
    table_start = trial.center(base).x;
}

void Stack::step() {
    table_way += trial.dt * trial.base_velocity(trial.time + 0.5 * trial.dt).x;
    trial.step();
    const double missed = std::abs(trial.center(base).x - table_start - table_way);
    table_error = std::max(table_error, missed * omega() * omega() / amplitude(trial.time));
    for (int k = 0; k < blocks; ++k) {
        slip = std::max(slip, std::abs(slip_of(k)));
    }
    uplift = std::max({uplift, height(left) - left_start, height(right) - right_start});
}

/// Shakes until the stack lifts off; returns the amplitude then, NaN where it stays down [m/s^2].
double lifting_amplitude(Stack& stack) {
    while (stack.trial.time < stack.seconds) {
        stack.step();
        if (stack.uplift > 1e-4) {
            return stack.amplitude(stack.trial.time);
        }
    }
    return std::nan("");
}

/// Draws the stack at equal times under the peak acceleration of figure 3.4, whose frequency is lost.
void draw_frames(double frequency, const CaseSetting& setting, CaseReport& report) {
    constexpr double interval = 0.25;
    constexpr int frames = 4;
    Plot plot;
    plot.title = fmt::format("Seven blocks shaken with {} m/s^2 at {} Hz", peak, frequency);
    plot.subtitle = fmt::format("every {} s, moved apart", interval);
    plot.x.label = "x [m]";
    plot.y.label = "y [m]";
    plot.has_equal_scales = true;
    Stack stack(frequency, peak, peak, frames * interval), again(frequency, peak, peak, frames * interval);
    double difference = 0;
    for (int frame = 0; frame <= frames; ++frame) {
        Curve drawing = stack.trial.drawing(fmt::format("{:.2f} s", stack.trial.time));
        for (std::size_t k = 0; k < drawing.x.size(); ++k) {
            drawing.x[k] += 0.65 * frame - stack.trial.center(stack.base).x;
            if (drawing.y[k] < -0.051) {  // fallen from the table
                drawing.x[k] = drawing.y[k] = NAN;
            }
        }
        plot.curves.push_back(std::move(drawing));
        while (frame < frames && stack.trial.time < (frame + 1) * interval - 0.5 * stack.trial.dt) {
            stack.step();
            again.step();
            for (std::size_t k = 0; k < stack.trial.state.rates.size(); ++k) {
                difference = std::max(difference, std::abs(stack.trial.state.rates[k] - again.trial.state.rates[k]));
            }
        }
    }
    const std::string name = fmt::format("{} m/s^2 at {} Hz: ", peak, frequency);
    report.judge({name + "largest lift of a corner under the stack in 1 s",
                  "m",
                  {},
                  {},
                  "above g b/H = 1.40 m/s^2 it rocks; above the width of a block it has toppled"},
                 stack.uplift, 1e-4, INFINITY);
    report.state({name + "largest way of a block on the one below in 1 s", "m", "the paper's frames are lost"},
                 stack.slip);
    report.judge_below({name + "error of the table's way over its amplitude", "-", {}, 0.0, {}}, stack.table_error,
                       0.01);
    report.judge_below({name + "a second run: largest difference of a rate", "m/s", {}, 0.0, {}, Kind::bookkeeping},
                       difference, 0);
    write_plot(setting, fmt::format("planar_shaken_stack_frames_{:.0f}_hz", frequency), plot);
}

}  // namespace

void planar_shaken_stack(const CaseSetting& setting, CaseReport& report) {
    Curve curve{"7 blocks, DDA", {}, {}, CurveStyle::markers, -1};
    for (const double frequency : {0.25, 1.0, 2.0, 4.0, 6.0}) {
        const double seconds = frequency < 0.5 ? 80 : setting.is_full ? 60 : 20;
        Stack stack(frequency, 0.9 * limit, (frequency < 0.5 ? 1.2 : 1.5) * limit, seconds);
        const double amplitude = lifting_amplitude(stack);
        const std::string name = fmt::format("{} Hz: ", frequency);
        const Reference reference{name + "amplitude at which the stack lifts off by 0.1 mm",
                                  "m/s^2",
                                  {},
                                  limit,
                                  "g b/H of the whole stack; the paper prints no frequencies"};
        if (frequency < 0.5) {
            report.judge(reference, amplitude, Relative{0.05});
        } else {
            report.state(
                {reference.quantity, reference.unit, "above g b/H, as 0.1 mm need more than the instant of the peak"},
                amplitude);
        }
        report.judge_below(
            {name + "largest way of a block on the one below before", "m", {}, 0.0, "it slides from 6.6 m/s^2"},
            stack.slip, 1e-4);
        report.judge_below({name + "error of the table's way over its amplitude", "-", {}, 0.0, {}}, stack.table_error,
                           0.01);
        curve.x.push_back(frequency);
        curve.y.push_back(amplitude);
    }
    draw_frames(2, setting, report);
    draw_frames(6, setting, report);
    Plot plot;
    plot.title = "Seven blocks on a shaking table: acceleration that lifts them";
    plot.x.label = "frequency [Hz]";
    plot.y.label = "amplitude [m/s^2]";
    plot.curves = {curve, {"g b/H", {1, 6}, {limit, limit}, CurveStyle::dashed, -1}};
    write_plot(setting, "planar_shaken_stack", plot);
}

}  // namespace riprap::validation::ding
