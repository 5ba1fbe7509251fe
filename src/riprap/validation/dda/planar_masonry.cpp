// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
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

Joint stiff_joint(double friction) { return {.normal_stiffness = 1e10, .shear_stiffness = 4e9, .friction = friction}; }

void set_friction(PlanarTrial& trial, double friction) { trial.model.set_joint(0, 0, stiff_joint(friction)); }

constexpr int column_count = 16;

/// Goodman and Bray's example in axes along and across its base, uphill = +x.
struct Columns {
    PlanarTrial trial{{25000 / gravity, 2e10, 0.25}, stiff_joint(3)};
    std::array<std::int32_t, column_count + 1> block{};
    std::array<Vec2, column_count + 1> start{};
    double largest{0};  ///< displacement of a column [m]

    Columns() {
        constexpr std::array heights{4., 8., 12., 16., 20., 24., 28., 32., 36., 40., 34., 28., 22., 16., 10., 4.};
        trial.settings = solid::planar_dda::settings_for(80, 0.002);
        for (int n = 1; n <= column_count; ++n) {  // steps of 1 m
            trial.add_box({n == 1 ? -60.0 : 10.0 * (n - 1), -20}, {n == 1 ? 70.0 : 10.0, 20.0 + (n - 1)}, true);
        }
        for (int n = 1; n <= column_count; ++n) {
            block[at(n)] = trial.add_box({10.0 * (n - 1), n - 1.0}, {10, heights[at(n - 1)]});
        }
        trial.gravity = gravity * Vec2{-0.5, -std::cos(30 * degree)};
        trial.settle(0.1, 1000);
    }
    Vec2 foot(int n) const {  // the middle of its base
        const Vec2 local = 0.5 * (trial.model.corner[at(trial.model.corner_begin[at(block[at(n)])])] +
                                  trial.model.corner[at(trial.model.corner_begin[at(block[at(n)])] + 1)]);
        return place_of(trial.state, block[at(n)], local);
    }
    /// Moves for `seconds` or until a column has gone `enough`.
    void run(double friction, double seconds, double enough) {
        set_friction(trial, friction);
        trial.dt = 0.01;
        for (int n = 1; n <= column_count; ++n) {
            start[at(n)] = foot(n);
        }
        std::array<Vec2, column_count + 1> center{};
        for (int n = 1; n <= column_count; ++n) {
            center[at(n)] = trial.center(block[at(n)]);
        }
        while (trial.time < seconds && largest < enough) {
            trial.step();
            for (int n = 1; n <= column_count; ++n) {
                largest = std::max(largest, norm(trial.center(block[at(n)]) - center[at(n)]));
            }
        }
    }
    double height(int n) const { return n <= 10 ? 4.0 * n : 40 - 6.0 * (n - 10); }
    /// 0 stable, 1 topples, 2 slides: by the larger displacement: of the base, or of the top relative to the base.
    int mode(int n) const {
        const double slid = norm(foot(n) - start[at(n)]);
        const double leant = std::abs(trial.angle(block[at(n)])) * height(n);
        if (std::max(slid, leant) < 0.05 * largest) {
            return 0;
        }
        return leant > slid ? 1 : 2;
    }
};

bool stands(double friction_angle, double seconds) {
    Columns columns;
    columns.run(std::tan(friction_angle * degree), seconds, 0.3);
    return columns.largest < 0.3;
}

}  // namespace

void planar_toppling(const CaseSetting& setting, CaseReport& report) {
    const double seconds = 15;
    report.judge({"stands at 39.0 degrees (1 = yes)", "-", {}, 1.0, {}}, stands(39, seconds) ? 1 : 0, 1, 1);
    Columns falling;
    const Curve before = falling.trial.drawing("at the start");
    falling.run(std::tan(37.3 * degree), 30, 0.5);
    report.judge({"fails at 37.3 degrees (1 = yes)", "-", {}, 1.0, {}}, falling.largest >= 0.3 ? 1 : 0, 1, 1);
    std::string modes;
    int right = 0;
    for (int n = column_count; n >= 1; --n) {
        const int expected = n >= 14 ? 0 : n >= 4 ? 1 : 2, found = falling.mode(n);
        right += found == expected ? 1 : 0;
        modes += found == 0 ? '-' : found == 1 ? 'T' : 'S';
    }
    report.judge({"columns of 16 with the mode of the theory (16 to 14 stable, 13 to 4 topple, 3 to 1 slide)",
                  "-",
                  {},
                  16.0,
                  fmt::format("from 16 down: {}", modes)},
                 right, 16, 16);
    double low = 36.5, high = 40;
    for (int k = 0; k < 5; ++k) {
        const double middle = 0.5 * (low + high);
        (stands(middle, seconds) ? high : low) = middle;
    }
    report.judge({"least friction angle at which the columns stand",
                  "deg",
                  {},
                  38.151,
                  "by bisection to 0.11 degrees, 15 s each, steps of 0.01 s, p = 1e10 N/m"},
                 0.5 * (low + high), Absolute{0.5});
    Plot plot;
    plot.title = "Sixteen columns on a stepped base at a friction angle of 37.3 degrees";
    plot.x.label = "along the base, uphill [m]";
    plot.y.label = "across it [m]";
    plot.has_equal_scales = true;
    plot.curves = {before, falling.trial.drawing("later")};
    plot.curves.front().style = CurveStyle::dashed;
    write_plot(setting, "planar_toppling", plot);
}

namespace {

/// Way in 1 s of a block on a plane at 35 degrees with cohesion, uplift and thrust in a crack behind it.
double plane_failure_way(double factor, double& acceleration) {
    const double slope = 35 * degree, friction = std::tan(30 * degree), length = 2, height = 0.4;
    const double weight = 2500 * gravity * length * height, uplift = 0.2 * weight, thrust = 0.1 * weight;
    const double normal = weight * std::cos(slope) - uplift - thrust * std::sin(slope);
    const double driving = weight * std::sin(slope) + thrust * std::cos(slope);
    // cohesion such that strength over driving force is `factor`
    const double cohesion = (factor * driving - normal * friction) / length;
    Joint joint = stiff_joint(friction);
    joint.cohesion = cohesion;
    PlanarTrial trial({2500, 5e10, 0.25}, joint);
    trial.settings = solid::planar_dda::settings_for(10);
    trial.add_box({-5, -1}, {15, 1}, true);
    const std::int32_t block = trial.add_box({0, 0}, {length, height});
    solid::planar_dda::bond_contacts(trial.model, trial.settings, 1e-9, trial.state);
    trial.gravity = gravity * Vec2{std::sin(slope), -std::cos(slope)};
    const Vec2 center = trial.center(block);
    // Thrust is horizontal, through the centroid; uplift acts where the base is pressed evenly, as bonds are brittle.
    const double lever = driving * 0.5 * height / uplift;
    auto builder = trial.builder();
    trial.settings.dynamic_factor = 0;
    const double start = center.x;
    for (int k = 1; k <= 100; ++k) {  // loads grow without inertia
        trial.model.point_loads.clear();
        const double share = 0.01 * k;
        const Vec2 now = trial.center(block);
        builder.add_load(block, now, share * Vec2{thrust * std::cos(slope), thrust * std::sin(slope)});
        builder.add_load(block, now + Vec2{lever, 0}, share * Vec2{0, uplift});
        trial.gravity = share * gravity * Vec2{std::sin(slope), -std::cos(slope)};
        trial.dt = 0.01;
        trial.step();
    }
    trial.settings.dynamic_factor = 1;
    trial.run(1);
    acceleration = (driving - normal * friction) / (weight / gravity);
    return trial.center(block).x - start;
}

}  // namespace

void planar_plane_failure(const CaseSetting&, CaseReport& report) {
    double a = 0;
    const double held = plane_failure_way(1.01, a);
    report.judge_below({"strength 1.01 of the driving force: way in 1 s", "m", {}, 0.0, {}}, held, 1e-4);
    const double slid = plane_failure_way(0.99, a);
    report.judge(
        {"strength 0.99 of it: way in 1 s after the bond broke", "m", {}, 0.5 * a, "brittle: friction alone is left"},
        slid, Relative{0.02});
}

namespace {

constexpr double radius = 10;
constexpr int voussoirs = 21;

struct Arch {
    double sinking{0}, late_sinking{0};
    std::array<double, voussoirs + 1> joint_turn{};
    std::vector<Curve> drawing;
};

Arch stand_arch(double thickness, double duration) {
    PlanarTrial trial({2500, 2e10, 0.2}, stiff_joint(0.8));
    trial.settings = solid::planar_dda::settings_for(10, 0.005);
    trial.add_box({-14, -1}, {28, 1}, true);
    const double inner = radius * (1 - 0.5 * thickness), outer = radius * (1 + 0.5 * thickness);
    const auto on_circle = [](double r, double a) { return r * Vec2{std::cos(a), std::sin(a)}; };
    for (int i = 0; i < voussoirs; ++i) {
        const double a0 = std::numbers::pi * (1 - double(i) / voussoirs);
        const double a1 = std::numbers::pi * (1 - double(i + 1) / voussoirs);
        trial.add({on_circle(inner, a0), on_circle(inner, a1), on_circle(outer, a1), on_circle(outer, a0)});
    }
    const std::int32_t key = voussoirs / 2 + 1;
    Arch arch;
    arch.drawing.push_back(trial.drawing("at the start"));
    trial.dt = 0.005;
    const double top = trial.center(key).y;
    double half_way = 0;
    bool has_joints = false;
    while (trial.time < duration && arch.sinking < 0.1 * radius) {
        trial.gravity = {0, -gravity * std::min(1.0, trial.time)};
        trial.step();
        arch.sinking = top - trial.center(key).y;
        half_way = trial.time < 0.5 * duration ? arch.sinking : half_way;
        if (!has_joints && arch.sinking > 0.02 * radius) {
            has_joints = true;
            for (int i = 0; i <= voussoirs; ++i) {
                const double left = i > 0 ? trial.angle(i) : 0, right = i < voussoirs ? trial.angle(i + 1) : 0;
                arch.joint_turn[at(i)] = std::abs(right - left);
            }
        }
    }
    arch.late_sinking = arch.sinking - half_way;
    arch.drawing.push_back(trial.drawing("at the end"));
    return arch;
}

double widest_joint(const Arch& arch, double from, double to) {
    double widest = -1, angle = std::nan("");
    for (int i = 0; i <= voussoirs; ++i) {
        const double place = std::abs(90 - 180.0 * i / voussoirs);
        if (place >= from && place <= to && arch.joint_turn[at(i)] > widest) {
            widest = arch.joint_turn[at(i)];
            angle = place;
        }
    }
    return angle;
}

}  // namespace

void planar_arch(const CaseSetting& setting, CaseReport& report) {
    const Arch holds = stand_arch(0.115, 10);
    report.judge({"t/R = 0.115: sinking of the keystone over R", "-", {}, 0.0, {}}, holds.sinking / radius, 0, 1e-3);
    const Arch falls = stand_arch(0.100, 20);
    report.judge({"t/R = 0.100: sinking of the keystone over R (falls)", "-", {}, {}, {}}, falls.sinking / radius, 0.1,
                 10);
    report.judge({"t/R = 0.100: hinge at the haunch, from the crown", "deg", {}, 54.5, {}}, widest_joint(falls, 20, 75),
                 Absolute{180.0 / voussoirs});
    report.judge({"t/R = 0.100: hinge at the springing, from the crown", "deg", {}, 90.0, {}},
                 widest_joint(falls, 75, 90), Absolute{180.0 / voussoirs});
    report.judge({"t/R = 0.100: hinge at the crown", "deg", {}, 0.0, {}}, widest_joint(falls, 0, 20),
                 Absolute{180.0 / voussoirs});
    Plot plot;
    plot.title = "Semicircular arch of 21 voussoirs, thickness 0.100 R";
    plot.x.label = "x [m]";
    plot.y.label = "y [m]";
    plot.has_equal_scales = true;
    plot.curves = falls.drawing;
    plot.curves.front().style = CurveStyle::dashed;
    write_plot(setting, "planar_arch", plot);
}

namespace {

/// A roof block with sides `lean` from the vertical, wider below, between two blocks that slide in smooth guides and
/// are pushed together by `thrust`. @returns the load on top at which it has come down by 1 mm, at most `most`
double carried_weight(double lean, double friction_angle, double thrust, double most, double seconds) {
    const double shift = std::tan(lean);
    PlanarTrial trial({2500, 5e10, 0.25}, stiff_joint(std::tan(friction_angle)));
    trial.settings = solid::planar_dda::settings_for(5);
    const std::int32_t smooth = trial.add_material({2500, 5e10, 0.25}, stiff_joint(0));
    trial.add_box({-4, -1.5}, {3, 1}, true, smooth);
    trial.add_box({-4, 0.5}, {3, 1}, true, smooth);
    trial.add_box({1, -1.5}, {3, 1}, true, smooth);
    trial.add_box({1, 0.5}, {3, 1}, true, smooth);
    const double low = 0.5 + 0.5 * shift, high = 0.5 - 0.5 * shift;  // half widths at the bottom and at the top
    const std::int32_t left = trial.add({{-3, -0.5}, {-low, -0.5}, {-high, 0.5}, {-3, 0.5}});
    const std::int32_t right = trial.add({{low, -0.5}, {3, -0.5}, {3, 0.5}, {high, 0.5}});
    const std::int32_t key = trial.add({{-low, -0.5}, {low, -0.5}, {high, 0.5}, {-high, 0.5}});
    trial.gravity = {};
    const auto load = [&](double down) {
        trial.model.point_loads.clear();
        auto builder = trial.builder();
        builder.add_load(left, trial.center(left), {thrust, 0});
        builder.add_load(right, trial.center(right), {-thrust, 0});
        builder.add_load(key, trial.center(key), {0, -down});
    };
    load(0);
    trial.settle(0.02, 200);
    const double start = trial.center(key).y;
    trial.dt = 0.005;
    while (trial.time < seconds) {
        const double down = most * trial.time / seconds;
        load(down);
        trial.step();
        if (start - trial.center(key).y > 1e-3) {
            return down;
        }
    }
    return most;
}

}  // namespace

void planar_keystone(const CaseSetting&, CaseReport& report) {
    const double lean = 10 * degree, thrust = 1e6;
    const double exact = 2 * thrust * std::tan(20 * degree - lean);
    report.judge({"sides 10 degrees, friction angle 20: weight that the keystone carries", "N/m", {}, exact, {}},
                 carried_weight(lean, 20 * degree, thrust, 1.2 * exact, 10), Relative{0.02});
    const double little = 2 * thrust * std::tan(0.5 * degree);
    report.judge({"friction angle 10.5: share of 2 H tan(0.5 deg) carried", "-", {}, 1.0, {}},
                 carried_weight(lean, 10.5 * degree, thrust, 1.5 * little, 10) / little, 0.95, 1.05);
    report.judge({"friction angle 9.5: share of it carried (falls)", "-", {}, 0.0, {}},
                 carried_weight(lean, 9.5 * degree, thrust, little, 10) / little, 0, 0.05);
}

}  // namespace riprap::validation::dda
