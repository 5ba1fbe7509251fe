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

constexpr double gravity = 9.81, degree = std::numbers::pi / 180;
constexpr int voussoirs = 7;

/// Seven equal voussoirs of a semicircle, inner radius 2 m, 0.5 m thick and deep; the outer sides of both end blocks
/// are held by fixed points [Ding2021, section 7.2.3].
PlanarTrial make_arch(double friction, double stiffness, double density, double E) {
    PlanarTrial trial({density, E, 0.2},
                      {.normal_stiffness = stiffness, .shear_stiffness = stiffness, .friction = friction});
    trial.model.thickness = 0.5;
    trial.settings = solid::planar_dda::settings_for(2.5, 0.05);
    const auto on_circle = [](double r, double a) { return r * Vec2{std::cos(a), std::sin(a)}; };
    for (int i = 0; i < voussoirs; ++i) {
        const double a0 = std::numbers::pi * (1 - double(i) / voussoirs);
        const double a1 = std::numbers::pi * (1 - double(i + 1) / voussoirs);
        trial.add({on_circle(2.0, a0), on_circle(2.0, a1), on_circle(2.5, a1), on_circle(2.5, a0)});
    }
    auto builder = trial.builder();
    for (const double r : {2.0, 2.5}) {
        builder.fix_point(0, {-r, 0}, 100 * stiffness);
        builder.fix_point(voussoirs - 1, {r, 0}, 100 * stiffness);
    }
    return trial;
}

}  // namespace

void planar_arch(const CaseSetting& setting, CaseReport& report) {
    PlanarTrial trial = make_arch(0, 1e6, 20, 5e5);
    trial.dt = 0.01;
    const int key = voussoirs / 2;
    const Vec2 start = trial.center(key);
    const Curve before = trial.drawing("at the start");
    Curve way{"key block, displacement [m]", {}, {}, CurveStyle::line, -1};
    Curve speed{"key block, speed [m/s]", {}, {}, CurveStyle::line, -1};
    double mirror = 0, largest = 0;
    trial.run(0.6, [&] {
        way.x.push_back(trial.time);
        way.y.push_back(trial.center(key).y - start.y);
        speed.x.push_back(trial.time);
        speed.y.push_back(trial.velocity(key).y);
        largest = std::max(largest, std::abs(way.y.back()));
        for (int i = 0; i < voussoirs; ++i) {
            const Vec2 left = trial.center(i), right = trial.center(voussoirs - 1 - i);
            mirror = std::max({mirror, std::abs(left.x + right.x), std::abs(left.y - right.y)});
        }
    });
    report.judge_below({"60 steps, no friction: largest difference of the halves over the span", "-", {}, 0.0, {}},
                       mirror / 5, 1e-6);
    report.judge({"way of the key block, at most that of a free fall", "m", {}, {}, {}}, largest, 0,
                 0.5 * gravity * 0.36);
    report.state({"way of the key block after 0.6 s", "m", "the paper's curve is lost; compared with blocks in space"},
                 way.y.back());
    report.state({"speed of the key block after 0.6 s", "m/s", {}}, speed.y.back());
    report.judge_below({"energy that the ledger misses, over its turnover", "-", {}, 0.0, {}, Kind::bookkeeping},
                       trial.ledger_error(), 1e-6);
    // with friction it stands: vertical support is half the weight, the thrust a line that fits into the arch
    PlanarTrial stable = make_arch(std::tan(40 * degree), 1e8, 2500, 5e9);
    stable.settle(0.01, 4000, 1e-10);
    double weight = 0;
    for (const double mass : stable.model.mass) {
        weight += mass * gravity;
    }
    Vec2 support{};
    for (const auto& point : stable.model.fixed_points) {
        if (point.block == 0) {
            support += point.stiffness * (point.anchor - place_of(stable.state, 0, point.local));
        }
    }
    report.judge({"friction angle 40: vertical force on a support over half the weight", "-", {}, 1.0, {}},
                 support.y / (0.5 * weight), Relative{1e-4});
    // moments of the left half about the springing: thrust at the crown times its height is weight times its lever
    double moment = 0;
    for (int i = 0; i < key; ++i) {
        moment += stable.model.mass[at(i)] * gravity * (stable.center(i).x + 2.25);
    }
    const double half = std::numbers::pi / 14;  // of the key block's angle; its halves by thin rings
    const double lever = 2.0 / 3 * (2.5 * 2.5 * 2.5 - 8) / (2.5 * 2.5 - 4) * (1 - std::cos(half)) / half;
    moment += 0.5 * stable.model.mass[at(key)] * gravity * (2.25 - lever);
    // lowest where the line passes crown and springings as the arch lets it: outer crown, inner springing
    const double least = (moment - 0.25 * 0.5 * weight) / 2.5, most = (moment + 0.25 * 0.5 * weight) / 2.0;
    report.judge({"friction angle 40: thrust between those of the lines of thrust that fit into crown and springings",
                  "N",
                  {},
                  {},
                  {}},
                 support.x, least, most);
    Plot plot;
    plot.title = "Seven voussoirs without friction sink under their weight";
    plot.x.label = "time [s]";
    plot.y.label = "of the key block";
    plot.curves = {way, speed};
    write_plot(setting, "planar_arch_key", plot);
    Plot frames;
    frames.title = "Seven voussoirs at the start and after 0.6 s";
    frames.x.label = "x [m]";
    frames.y.label = "y [m]";
    frames.has_equal_scales = true;
    frames.curves = {before, trial.drawing("after 0.6 s")};
    frames.curves.front().style = CurveStyle::dashed;
    write_plot(setting, "planar_arch_frames", frames);
}

namespace {

constexpr double dip = 16.1 * degree;

/// The top of a gravity dam on a crack that dips downstream, split by a vertical crack: block 2 upstream, block 1
/// downstream [Ding2021, section 7.3]. The paper's drawing is lost; sizes are chosen, see the README.
struct Dam {
    PlanarTrial trial;
    std::int32_t base, upstream, downstream;
    Vec2 start{};
    double level{0};  ///< of the water above the upper end of the crack [m]

    explicit Dam(double cohesion, double friction = std::tan(30 * degree))
        : trial({2500, 5e10, 0.2},
                {.normal_stiffness = 2e9, .shear_stiffness = 2e9, .friction = friction, .cohesion = cohesion}) {
        const double fall = 2.5 * std::tan(dip), top = 5 - 0.5 * fall;
        trial.settings = solid::planar_dda::settings_for(10, 0.005);
        base = trial.add({{0, -12}, {40, -12}, {40, -fall - 10}, {10.5, -fall - 10}, {2.5, -fall}, {0, 0}}, true);
        upstream = trial.add({{0, 0}, {1.25, -0.5 * fall}, {1.25, top}, {0, top}});
        downstream = trial.add({{1.25, -0.5 * fall}, {2.5, -fall}, {2.5, top}, {1.25, top}});
        if (cohesion > 0) {
            solid::planar_dda::bond_contacts(trial.model, trial.settings, 1e-9, trial.state);
        }
        press(0);
        trial.settle(0.02, 400);
        start = trial.center(downstream);
        trial.dt = 0.005;
    }
    /// Water pressure on the upstream face, in one force; none once the block has left the crack.
    void press(double height) {
        level = height;
        trial.model.point_loads.clear();
        if (height > 0 && trial.center(upstream).x < 3.2) {
            const double force = 0.5 * 1000 * gravity * height * height;
            const Vec2 heel =
                place_of(trial.state, upstream, trial.model.corner[at(trial.model.corner_begin[at(upstream)])]);
            trial.builder().add_load(upstream, heel + Vec2{0, height / 3}, {force, 0});
        }
    }
    double way() const { return norm(trial.center(downstream) - start); }
};

/// Way of block 1 after `seconds` of water that rises by 0.5 m a second to `level`.
double dam_way(double level, double cohesion, double seconds, double& onset, Curve* curve = nullptr) {
    Dam dam(cohesion);
    onset = std::nan("");
    while (dam.trial.time < seconds) {
        dam.press(std::min(level, 0.5 * dam.trial.time));
        dam.trial.step();
        if (std::isnan(onset) && dam.way() > 1e-3) {
            onset = dam.trial.time;
        }
        if (curve != nullptr) {
            curve->x.push_back(dam.trial.time);
            curve->y.push_back(dam.way());
        }
    }
    return dam.way();
}

double critical_level() {
    Dam dam(0);
    while (dam.trial.time < 40) {
        const double t = dam.trial.time;
        dam.press(t < 10 ? 0.36 * t : 3.6 + 0.02 * (t - 10));
        dam.trial.step();
        if (dam.way() > 1e-3) {
            return dam.level;
        }
    }
    return std::nan("");
}

/// Speed that the blocks gain in a second at a level that passes the limit, along the crack.
double sliding_acceleration(double level) {
    Dam dam(0, 1);
    dam.press(level);
    dam.trial.settle(0.02, 400);
    solid::planar_dda::Joint joint = dam.trial.model.joints[0];
    joint.friction = std::tan(30 * degree);
    dam.trial.model.set_joint(0, 0, joint);
    const auto run = [&dam, level](double seconds) {
        while (dam.trial.time < seconds) {
            dam.press(level);
            dam.trial.step();
        }
        return norm(dam.trial.velocity(dam.downstream));
    };
    const double early = run(0.3);
    return run(1.3) - early;
}

void report_phases(double acceleration, const CaseSetting& setting, CaseReport& report) {
    Dam dam(0);
    const Curve before = dam.trial.drawing("at the start");
    double peak = 0, moved = std::nan(""), half_metre = std::nan("");
    Curve kinetic{"kinetic energy [J/m]", {}, {}, CurveStyle::line, -1};
    while (dam.trial.time < (setting.is_full ? 60 : 30)) {
        dam.press(std::min(4.0, 0.5 * dam.trial.time));
        dam.trial.step();
        const double now = energies_of(dam.trial.model, dam.trial.state).kinetic, way = dam.way();
        peak = std::max(peak, now);
        kinetic.x.push_back(dam.trial.time);
        kinetic.y.push_back(now);
        moved = std::isnan(moved) && way > 1e-3 ? dam.trial.time : moved;
        half_metre = std::isnan(half_metre) && way > 0.5 ? dam.trial.time : half_metre;
    }
    report.judge({"4.0 m: time in which block 1 slides by 0.5 m",
                  "s",
                  {},
                  std::sqrt(2 * 0.5 / acceleration),
                  "from 1 mm on; the published first phase of 7.5 s is the whole crack of 2.6 m"},
                 half_metre - moved, Relative{0.05});
    report.judge({"fall of the centre of block 1 until the end", "m", "falls to the foundation", {}, {}},
                 dam.start.y - dam.trial.center(dam.downstream).y, 5, 13);
    report.judge_below({"kinetic energy at the end over its peak", "-", "rest", 0.0, {}}, kinetic.y.back() / peak,
                       1e-3);
    report.judge_below({"energy that the ledger misses, over its turnover", "-", {}, 0.0, {}, Kind::bookkeeping},
                       dam.trial.ledger_error(), 1e-4);
    Plot plot;
    plot.title = "The top of a dam after the water has risen to 4 m above the crack";
    plot.x.label = "x [m]";
    plot.y.label = "y [m]";
    plot.has_equal_scales = true;
    plot.curves = {before, dam.trial.drawing("at the end")};
    plot.curves.front().style = CurveStyle::dashed;
    write_plot(setting, "planar_dam_frames", plot);
}

}  // namespace

void planar_dam(const CaseSetting& setting, CaseReport& report) {
    const double weight = 12.5 * 2500 * gravity;
    const double limit = std::sqrt(2 * weight * std::tan(30 * degree - dip) / (1000 * gravity));
    report.judge({"level at which the blocks begin to slide, c = 0", "m", {}, limit, "W tan(phi - dip) of both blocks"},
                 critical_level(), Relative{0.01});
    const double H = 0.5 * 1000 * gravity * 16;
    const double a = (H * std::cos(dip) + weight * std::sin(dip) -
                      (weight * std::cos(dip) - H * std::sin(dip)) * std::tan(30 * degree)) /
                     (weight / gravity);
    report.judge({"4.0 m: acceleration along the crack", "m/s^2", {}, a, {}}, sliding_acceleration(4), Relative{0.02});
    Plot plot;
    plot.title = "Way of block 1 while the water rises by 0.5 m a second";
    plot.x.label = "time [s]";
    plot.y.label = "way [m]";
    double before = -1, onset_before = 1e9;
    bool is_ordered = true;
    for (const double level : {3.0, 3.5, 4.0, 5.0}) {
        double onset = 0;
        Curve curve{fmt::format("{} m", level), {}, {}, CurveStyle::line, -1};
        const double way = dam_way(level, 0, 12, onset, &curve);
        if (level < 3.9) {
            report.judge_below({fmt::format("{} m: way of block 1 in 12 s", level), "m", "stands", 0.0, {}}, way, 1e-3);
        } else {
            is_ordered = is_ordered && way > before && onset <= onset_before;
            onset_before = onset;
        }
        before = way;
        plot.curves.push_back(std::move(curve));
    }
    report.judge({"higher water: larger and not later displacement (1 = yes)", "-", "larger and earlier", 1.0, {}},
                 is_ordered ? 1 : 0, 1, 1);
    write_plot(setting, "planar_dam_levels", plot);
    double last = 1e9;
    bool is_monotone = true;
    for (const double cohesion : {0.0, 1e3, 2e3, 3e5, 3e6}) {
        double onset = 0;
        const double way = dam_way(4, cohesion, 12, onset);
        is_monotone = is_monotone && way <= last;
        last = way;
        if (cohesion > 1e4) {
            report.judge_below({fmt::format("4.0 m, c = {:.1f} MPa on the area: way in 12 s", cohesion / 1e6), "m",
                                cohesion > 1e6 ? "16.7 % less" : "fails", 0.0,
                                "c L = 780 kN/m and more against 78 kN/m of water: no failure is possible"},
                               way, 1e-3);
        }
    }
    report.judge({"4.0 m: way falls with cohesion 0, 1, 2 kPa, 0.3, 3 MPa (1 = yes)", "-", "less", 1.0, {}},
                 is_monotone ? 1 : 0, 1, 1);
    report_phases(a, setting, report);
}

}  // namespace riprap::validation::ding
