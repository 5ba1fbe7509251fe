// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/core/index.hpp"
#include "riprap/validation/dda/planar_cases.hpp"
#include "riprap/validation/dda/planar_trial.hpp"

namespace riprap::validation::dda {

namespace {

constexpr double gravity = 9.81, degree = std::numbers::pi / 180;
using geometry::Vec2;
using solid::planar_dda::Joint;

const PlanarTrial::Material rock{2500, 5e10, 0.25};
Joint stiff_joint(double friction) { return {.normal_stiffness = 1e10, .shear_stiffness = 4e9, .friction = friction}; }

/// Angle of gravity or acceleration ratio at which a block b x h first slips or turns; `pull` gives gravity in terms of
/// the growing number.
template <class Pull>
double first_motion(double b, double h, double friction, double from, double to, double seconds, const Pull& pull) {
    PlanarTrial trial(rock, stiff_joint(friction));
    trial.settings = solid::planar_dda::settings_for(5);
    trial.add_box({-5, -1}, {10, 1}, true);
    const std::int32_t block = trial.add_box({-0.5 * b, 0}, {b, h});
    trial.gravity = pull(from);
    trial.settle(0.05, 400);
    trial.dt = 0.005;
    const double start = place_of(trial.state, block, trial.model.corner[4]).x;
    const double tilt = trial.angle(block);
    while (trial.time < seconds) {
        const double number = from + (to - from) * trial.time / seconds;
        trial.gravity = pull(number);
        trial.step();
        const double slipped = std::abs(place_of(trial.state, block, trial.model.corner[5]).x - start - b);
        if (slipped > 1e-3 || std::abs(trial.angle(block) - tilt) > 2e-3) {
            return number;
        }
    }
    return std::nan("");
}

}  // namespace

void planar_tip_or_slide(const CaseSetting&, CaseReport& report) {
    for (const double ratio : {0.2, 0.4, 0.8}) {
        for (const double share : {0.8, 1.25}) {
            const double friction = share * ratio;
            const double limit = std::atan(std::min(friction, ratio)) / degree;
            const double angle = first_motion(ratio, 1, friction, limit - 1, limit + 1, 20, [](double slope) {
                return gravity * Vec2{std::sin(slope * degree), -std::cos(slope * degree)};
            });
            report.judge({fmt::format("b/h = {}, friction {:.2f}: slope at which it {}", ratio, friction,
                                      share < 1 ? "slides" : "tips"),
                          "deg",
                          {},
                          limit,
                          {}},
                         angle, Absolute{0.1});
        }
    }
}

void planar_shaken_block(const CaseSetting&, CaseReport& report) {
    for (const double friction : {0.3, 0.6}) {
        const double limit = std::min(friction, 0.4);
        const double found = first_motion(0.4, 1, friction, 0.9 * limit, 1.1 * limit, 20, [](double share) {
            return gravity * Vec2{share, -1};
        });
        report.judge({fmt::format("b/h = 0.4, friction {}: horizontal share of g at which it {}", friction,
                                  friction < 0.4 ? "slides" : "lifts off"),
                      "-",
                      {},
                      limit,
                      {}},
                     found, Relative{0.01});
    }
}

namespace {

/// Returns the sinking of a leaning stack of `count` bricks in `seconds` when its overhang is `share` of the harmonic
/// one.
double stack_motion(int count, double share, double seconds) {
    PlanarTrial trial(rock, stiff_joint(0.7));
    trial.settings = solid::planar_dda::settings_for(2);
    trial.add_box({-1, -0.2}, {1, 0.2}, true);
    double edge = 0;
    std::vector<double> reach(at(count));
    for (int k = count; k >= 1; --k) {  // the lowest brick leans out by 1/(2 n)
        edge += share * 0.5 / k;
        reach[at(count - k)] = edge;
    }
    std::int32_t top = 0;
    for (int k = 0; k < count; ++k) {
        top = trial.add_box({reach[at(k)] - 1, 0.1 * k}, {1, 0.1});
    }
    trial.settle(0.01, 200);
    const Vec2 start = trial.center(top);
    trial.dt = 0.005;
    double moved = 0;
    while (trial.time < seconds && moved < 0.02) {
        trial.step();
        moved = norm(trial.center(top) - start);
    }
    return moved;
}

}  // namespace

void planar_stacks(const CaseSetting&, CaseReport& report) {
    for (const int count : {1, 2, 3, 6}) {
        report.judge_below({fmt::format("{} bricks lean out to 0.99 of the harmonic limit: drift of the top", count),
                            "m",
                            {},
                            0.0,
                            "in 10 s"},
                           stack_motion(count, 0.99, 10), 1e-4);
        report.judge({fmt::format("{} bricks at 1.01 of it: way of the top (falls)", count), "m", {}, {}, {}},
                     stack_motion(count, 1.01, 10), 0.02, 10);
    }
    PlanarTrial trial(rock, {.normal_stiffness = 1e9, .shear_stiffness = 4e8, .friction = 0.5});
    trial.settings = solid::planar_dda::settings_for(5);
    trial.add_box({-1, -1}, {2, 1}, true);
    const int count = 10;
    for (int k = 0; k < count; ++k) {
        trial.add_box({-0.5, 0.5 * k}, {1, 0.5});
    }
    trial.settle(0.05, 2000, 1e-12);
    double error = 0;
    for (int k = 0; k < count; ++k) {
        const double above = (count - k) * 1250 * gravity;
        error = std::max(error, std::abs(trial.force_between(k, k + 1) / above - 1));
    }
    report.judge_below({"10 blocks: largest error of the force under each over the weight above", "-", {}, 0.0, {}},
                       error, 1e-6);
    const Vec2 start = trial.center(count);
    trial.dt = 0.005;
    trial.run(10);
    report.judge_below({"10 blocks: drift of the top in 2000 steps", "m", {}, 0.0, {}},
                       norm(trial.center(count) - start), 1e-8);
}

void planar_dragged_block(const CaseSetting&, CaseReport& report) {
    const double friction = 0.3, m = 0.1 * 2500, M = 0.8 * 2500;
    for (const double share : {0.9, 1.5}) {
        PlanarTrial trial(rock, stiff_joint(friction));
        trial.settings = solid::planar_dda::settings_for(5);
        const std::int32_t ice = trial.add_material(rock, stiff_joint(0));
        trial.add_box({-2, -1}, {12, 1}, true, ice);
        const std::int32_t plank = trial.add_box({0, 0}, {4, 0.2});
        const std::int32_t block = trial.add_box({2.5, 0.2}, {1, 0.1});
        trial.settle(0.02, 400, 1e-10);
        const double force = share * friction * gravity * (m + M);
        trial.builder().add_load(plank, trial.center(plank), {force, 0});
        const double x_plank = trial.center(plank).x, x_block = trial.center(block).x;
        trial.dt = 1e-3;
        trial.run(0.5);
        const double above = share <= 1 ? force / (m + M) : friction * gravity;
        const std::string name = fmt::format("plank pulled with {} of the force that parts them: acceleration ", share);
        report.judge({name + "of the block", "m/s^2", {}, above, {}}, 8 * (trial.center(block).x - x_block),
                     Relative{2e-3});
        report.judge({name + "of the plank", "m/s^2", {}, (force - m * above) / M, {}},
                     8 * (trial.center(plank).x - x_plank), Relative{2e-3});
    }
}

namespace {

struct Rocking {
    double upright{0}, speed_ratio{0}, next_peak{0}, next_time{0};
    Curve curve;
};

Rocking rock_block(double b, double h) {
    PlanarTrial trial(rock, {.normal_stiffness = 1e9, .shear_stiffness = 1e9, .friction = 2, .damping_ratio = 1});
    trial.settings = solid::planar_dda::settings_for(5);
    trial.add_box({-3, -1}, {6, 1}, true);
    const double alpha = std::atan(b / h), tilt = 0.5 * alpha;
    const auto turned = [tilt](const Vec2& p) {
        return Vec2{std::cos(tilt) * p.x + std::sin(tilt) * p.y, -std::sin(tilt) * p.x + std::cos(tilt) * p.y};
    };
    // it leans to the right on its corner at the origin
    const std::int32_t block =
        trial.add({turned({-2 * b, 0}), turned({0, 0}), turned({0, 2 * h}), turned({-2 * b, 2 * h})});
    trial.dt = 2e-4;
    Rocking result;
    result.curve.label = fmt::format("b = {} m, h = {} m", b, h);
    double before_impact = 0, last = 0;
    bool has_landed = false;
    trial.run(4 * std::sqrt(std::hypot(b, h)), [&] {
        const double lean = tilt - trial.angle(block);  // to the right
        if (!has_landed && lean <= 0) {
            has_landed = true;
            result.upright = trial.time - trial.dt * lean / (lean - last);
        }
        if (lean > 0.1 * tilt && !has_landed) {
            before_impact = trial.spin(block);
        }
        if (has_landed && lean < -0.1 * tilt && result.speed_ratio == 0) {
            result.speed_ratio = trial.spin(block) / before_impact;
        }
        if (has_landed && -lean > result.next_peak && result.next_time == 0) {
            result.next_peak = -lean;
        } else if (has_landed && result.speed_ratio != 0 && result.next_time == 0) {
            result.next_time = trial.time;
        }
        result.curve.x.push_back(trial.time);
        result.curve.y.push_back(lean);
        last = lean;
    });
    return result;
}

/// Speed gained between a lean of `lean` and upright, squared, from energy.
double square_gain(double b, double h, double lean) {
    const double R = std::hypot(b, h), alpha = std::atan(b / h), p2 = 0.75 * gravity / R;
    return 2 * p2 * (std::cos(alpha - lean) - std::cos(alpha));
}

}  // namespace

void planar_rocking(const CaseSetting& setting, CaseReport& report) {
    Plot plot;
    plot.title = "Blocks let go at half the angle at which they fall (Housner)";
    plot.x.label = "time [s]";
    plot.y.label = "lean [rad]";
    struct Exact {
        double b, h, quarter, ratio, peak;
    };
    for (const Exact& e :
         {Exact{0.25, 1, 0.493803, 0.911765, 0.094737}, Exact{0.1, 0.5, 0.347094, 0.942308, 0.083339}}) {
        const Rocking r = rock_block(e.b, e.h);
        const std::string name = fmt::format("b = {} m, h = {} m: ", e.b, e.h);
        report.judge({name + "time until upright", "s", {}, e.quarter, {}}, r.upright, Relative{5e-3});
        // speeds are read a tenth of the first lean away from upright and brought there by energy
        const double tenth = 0.05 * std::atan(e.b / e.h), alpha = std::atan(e.b / e.h);
        const double gain = square_gain(e.b, e.h, tenth);
        const double before2 = square_gain(e.b, e.h, 0.5 * alpha);
        const double read2 = before2 - gain;
        const double after2 = r.speed_ratio * r.speed_ratio * read2 + gain;
        report.judge({name + "spin after the impact over before", "-", {}, e.ratio, {}}, std::sqrt(after2 / before2),
                     Relative{0.01});
        report.judge({name + "next peak", "rad", {}, e.peak, {}}, r.next_peak, Relative{0.02});
        plot.curves.push_back(r.curve);
    }
    write_plot(setting, "planar_rocking", plot);
}

}  // namespace riprap::validation::dda
