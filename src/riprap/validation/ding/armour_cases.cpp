// SPDX-License-Identifier: Apache-2.0
// Armour behind the caisson under the wave that overtops it [Ding2021, sections 6.4.3 to 6.4.5], loaded one-way by the
// recorded pressures.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "riprap/core/index.hpp"
#include "riprap/solid/planar_dda/pieces.hpp"
#include "riprap/validation/ding/recorded_water.hpp"

namespace riprap::validation::ding {

using geometry::Vec2;

namespace {

constexpr double rear = Breakwater::caisson_front + Breakwater::caisson_width;
constexpr double side = 2;                         ///< of a cube; every unit has its area, 4 m^2
constexpr int marked = 6;                          ///< units whose displacements are compared
constexpr double first_load = 18, last_load = 28;  ///< of the recorded wave [s]
constexpr double steady_speed = 0.01;              ///< [m/s]

enum class Unit { cube, accropode, tetrapod };
const char* name_of(Unit unit) {
    return unit == Unit::cube ? "cube" : unit == Unit::accropode ? "accropode" : "tetrapod";
}

/// A star of tapered legs, or a cross of which two arms end in noses, scaled to the area of the cube.
std::vector<Vec2> outline(Unit unit, const Vec2& centre, double turn) {
    std::vector<Vec2> corners;
    const auto add = [&corners](double along, double across, double angle) {
        corners.push_back(
            {along * std::cos(angle) - across * std::sin(angle), along * std::sin(angle) + across * std::cos(angle)});
    };
    constexpr double pi = std::numbers::pi;
    if (unit == Unit::cube) {
        corners = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    } else {
        const int legs = unit == Unit::tetrapod ? 3 : 4;
        const double root = unit == Unit::tetrapod ? 0.45 : 0.5, tip = unit == Unit::tetrapod ? 0.25 : 0.3;
        for (int leg = 0; leg < legs; ++leg) {
            const double angle = 2 * pi * leg / legs + pi / 2;
            add(1, -tip, angle);
            if (unit == Unit::accropode && leg % 2 == 1) {
                add(1.2, 0, angle);
            }
            add(1, tip, angle);
            add(root, 0, angle + pi / legs);
        }
    }
    double area = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        area += 0.5 * cross(corners[k], corners[(k + 1) % corners.size()]);
    }
    const double scale = side / std::sqrt(area), c = std::cos(turn), s = std::sin(turn);
    for (Vec2& x : corners) {
        x = centre + scale * Vec2{c * x.x - s * x.y, s * x.x + c * x.y};
    }
    return corners;
}

/// Caisson, bed and a pile of units behind it, rows counted from the top.
struct Pile {
    PlanarTrial trial;
    std::int32_t caisson{0};
    std::vector<std::int32_t> units;
    std::vector<Vec2> start;
    std::vector<double> start_angle;

    Pile(Unit unit, const std::vector<int>& rows, double cohesion = 0, double tension = 0)
        : trial({2400, 5e10, 0.3}, {.normal_stiffness = 2e8,
                                    .shear_stiffness = 2e8,
                                    .friction = 0.6,
                                    .cohesion = cohesion,
                                    .tension = tension,
                                    .damping_ratio = 0.2}) {
        trial.model.plane = solid::planar_dda::PlaneState::strain;
        trial.settings = solid::planar_dda::settings_for(13, 0.005);
        trial.dt = 0.004;
        trial.add({{150, -5}, {260, -5}, {260, 0}, {150, 0}}, true);
        caisson =
            trial.add_box({Breakwater::caisson_front, 0}, {Breakwater::caisson_width, Breakwater::caisson_height});
        const double pitch = unit == Unit::cube ? side : 1.45 * side;
        for (std::size_t row = 0; row < rows.size(); ++row) {
            for (int i = 0; i < rows[row]; ++i) {
                const Vec2 centre{rear + (i + 0.5) * pitch, (static_cast<double>(rows.size() - row) - 0.5) * pitch};
                const double turn =
                    unit == Unit::tetrapod && (i + static_cast<int>(row)) % 2 == 1 ? std::numbers::pi : 0;
                units.push_back(trial.add(outline(unit, centre, turn)));
            }
        }
    }
    void note_start() {
        start.clear();
        start_angle.clear();
        for (const std::int32_t unit : units) {
            start.push_back(trial.center(unit));
            start_angle.push_back(trial.angle(unit));
        }
    }
    void step(const RecordedWater& water, double time) {
        trial.model.point_loads.clear();
        press_caisson(trial, caisson, water, time);
        for (const std::int32_t unit : units) {
            press_block(trial, unit, water, time);
        }
        trial.step();
    }
    Vec2 moved(std::size_t unit) const { return trial.center(units[unit]) - start[unit]; }
    double turned(std::size_t unit) const { return trial.angle(units[unit]) - start_angle[unit]; }
    /// Horizontal load of the water on the caisson over the friction that its foot can give [-].
    double thrust() const {
        Vec2 load{};
        for (const auto& one : trial.model.point_loads) {
            load += one.block == caisson ? one.force : Vec2{};
        }
        return std::abs(load.x) / (0.6 * (9.81 * trial.model.mass[at(caisson)] - load.y));
    }
    double fastest() const {
        double most = 0;
        for (const std::int32_t unit : units) {
            most = std::max(most, norm(trial.velocity(unit)));
        }
        return most;
    }
    /// Units that moved farther than half of their side: damage N_od, per width of one unit.
    int displaced() const {
        int count = 0;
        for (std::size_t u = 0; u < units.size(); ++u) {
            count += norm(moved(u)) > 0.5 * side ? 1 : 0;
        }
        return count;
    }
};

double spread(const std::vector<double>& values) {
    double mean = 0, square = 0;
    for (const double v : values) {
        mean += v / static_cast<double>(values.size());
    }
    for (const double v : values) {
        square += (v - mean) * (v - mean) / static_cast<double>(values.size());
    }
    return std::sqrt(square);
}

/// State of a pile at the end.
struct Outcome {
    double rest_drift{0}, spread_x{0}, spread_y{0}, spread_turn{0};
    double caisson{0};     ///< largest displacement of the caisson [m]
    double thrust{0};      ///< largest horizontal load on the caisson over the friction that its foot can give [-]
    double steady_at{0};   ///< time after which no unit is faster than a centimetre a second [s]
    int steady_impact{0};  ///< number of the impact in which that is
    int displaced{0};
    std::vector<Vec2> moved;
    Curve before, after;
};

/// Lets a pile settle in still water, stand for five seconds and then feel the wave `impacts` times over.
Outcome run_pile(Pile& pile, const RecordedWater& water, int impacts) {
    Outcome out;
    pile.trial.settings.dynamic_factor = 0.98;  // falls into place without bouncing
    const double settling = pile.units.size() > 4 ? 8 : 5;
    while (pile.trial.time < settling) {
        pile.step(water, first_load);
    }
    pile.trial.settings.dynamic_factor = 1;
    pile.note_start();
    const double stand = pile.trial.time;
    while (pile.trial.time < stand + 5) {
        pile.step(water, first_load);
    }
    for (std::size_t u = 0; u < pile.units.size(); ++u) {
        out.rest_drift = std::max(out.rest_drift, norm(pile.moved(u)));
    }
    pile.note_start();
    out.before = pile.trial.drawing("before the wave");
    const double begin = pile.trial.time, caisson_x = pile.trial.center(pile.caisson).x;
    while (pile.trial.time < begin + impacts * water.duration()) {
        const double since = pile.trial.time - begin;
        pile.step(water, first_load + std::fmod(since, water.duration()));
        out.caisson = std::max(out.caisson, pile.trial.center(pile.caisson).x - caisson_x);
        out.thrust = std::max(out.thrust, pile.thrust());
        if (pile.fastest() > steady_speed) {
            out.steady_at = pile.trial.time - begin;
            out.steady_impact = 1 + static_cast<int>(since / water.duration());
        }
    }
    std::vector<double> x, y, turn;
    for (std::size_t u = 0; u < pile.units.size(); ++u) {
        out.moved.push_back(pile.moved(u));
        if (u < marked) {
            x.push_back(pile.moved(u).x);
            y.push_back(pile.moved(u).y);
            turn.push_back(pile.turned(u));
        }
    }
    out.spread_x = spread(x);
    out.spread_y = spread(y);
    out.spread_turn = spread(turn);
    out.displaced = pile.displaced();
    out.after = pile.trial.drawing("after it");
    return out;
}

/// Returns a/b; NaN where b is less than a centimetre or half a degree, as elastic displacements say nothing of an
/// order.
double ratio(double a, double b) { return b > 0.01 ? a / b : std::nan(""); }

RecordedWater record(const CaseSetting& setting) { return {setting.is_full ? 0.4 : 1.0, first_load, last_load}; }

void draw(const CaseSetting& setting, const std::string& name, const std::string& title, const Outcome& out) {
    Plot plot;
    plot.title = title;
    plot.x.label = "x [m]";
    plot.y.label = "y [m]";
    plot.has_equal_scales = true;
    plot.curves = {out.before, out.after};
    plot.curves.front().style = CurveStyle::dashed;
    write_plot(setting, name, plot);
}

void state_damage(const std::string& name, const Outcome& out, CaseReport& report) {
    report.state({name + ": units displaced by more than half a side, N_od"}, out.displaced);
    report.state({name + ": largest way of the caisson", "m"}, out.caisson);
    report.state({name + ": largest thrust on the caisson over the friction of its foot; it slides above 1"},
                 out.thrust);
}

}  // namespace

void unit_shapes(const CaseSetting& setting, CaseReport& report) {
    const RecordedWater water = record(setting);
    constexpr int impacts = 5;
    std::array<Outcome, 3> outs;
    for (const Unit unit : {Unit::cube, Unit::accropode, Unit::tetrapod}) {
        Pile pile(unit, {1, 2, 3});
        Outcome& out = outs[static_cast<std::size_t>(unit)] = run_pile(pile, water, impacts);
        const std::string name = name_of(unit);
        report.judge_below({name + ": largest drift in 5 s before the wave", "m", {}, 0.0, {}}, out.rest_drift, 1e-3);
        report.state({name + ": standard deviation of horizontal ways", "m"}, out.spread_x);
        report.state({name + ": standard deviation of vertical ways", "m"}, out.spread_y);
        report.state({name + ": standard deviation of rotations", "rad"}, out.spread_turn);
        state_damage(name, out, report);
        draw(setting, "armour_" + name, "Armour behind the caisson before and after five waves: " + name, out);
    }
    const auto& [cube, accropode, tetrapod] = outs;
    const auto size = [](const Outcome& out) { return std::hypot(out.spread_x, out.spread_y); };
    report.judge_below({"deviation of ways, accropode over cube", "-", "below 1", {}, {}},
                       ratio(size(accropode), size(cube)), 1);
    report.judge_below({"deviation of ways, tetrapod over accropode", "-", "below 1", {}, {}},
                       ratio(size(tetrapod), size(accropode)), 1);
    report.judge_below({"deviation of rotations, cube over accropode", "-", "below 1", {}, {}},
                       ratio(cube.spread_turn, accropode.spread_turn), 1);
    report.judge_below({"deviation of rotations, tetrapod over accropode", "-", "below 1", {}, {}},
                       ratio(tetrapod.spread_turn, accropode.spread_turn), 1);
    double deepest = 0.01;  // less is no fall
    std::size_t which = 0;
    for (std::size_t u = 0; u < cube.moved.size(); ++u) {
        if (-cube.moved[u].y > deepest) {
            deepest = -cube.moved[u].y;
            which = u + 1;
        }
    }
    report.judge({"number of the cube that falls deepest", "-", 2.0, {}, {}}, static_cast<double>(which), 2, 2);
    report.judge({"impact after which the tetrapods are steady", "-", 2.0, {}, {}}, tetrapod.steady_impact, 0, 3);
    report.judge({"impact in which cubes still move", "-", 5.0, {}, {}}, cube.steady_impact, 4, 5);
}

void shoreward_slopes(const CaseSetting& setting, CaseReport& report) {
    const RecordedWater water = record(setting);
    // rows of whole cubes whose outer corners lie on a slope of 63, 45 and 27 degrees
    const std::array<const char*, 3> names{"sqrt 3:1", "1:1", "1:2"};
    const std::array<std::vector<int>, 3> rows{{{1, 2, 2}, {1, 2, 3}, {1, 3, 5}}};
    const std::array<double, 3> printed{0.501, 0.380, 0.238};
    std::array<Outcome, 3> outs;
    for (std::size_t i = 0; i < 3; ++i) {
        Pile pile(Unit::cube, rows[i]);
        outs[i] = run_pile(pile, water, 1);
        const std::string name = names[i];
        report.judge({fmt::format("{}: way of the caisson", name), "m", printed[i], {}, {}}, outs[i].caisson,
                     0.5 * printed[i], 2 * printed[i]);
        report.state({name + ": standard deviation of the ways of cubes", "m"},
                     std::hypot(outs[i].spread_x, outs[i].spread_y));
        report.state({name + ": steady after", "s"}, outs[i].steady_at);
        state_damage(name, outs[i], report);
        draw(setting, fmt::format("shoreward_{}", i + 1), "Cubes behind the caisson before and after the wave",
             outs[i]);
    }
    report.judge({"way of the caisson, sqrt 3:1 over 1:1", "-", 1.32, {}, {}}, ratio(outs[0].caisson, outs[1].caisson),
                 0.7 * 1.32, 1.3 * 1.32);
    report.judge({"way of the caisson, 1:2 over 1:1", "-", 0.63, {}, {}}, ratio(outs[2].caisson, outs[1].caisson),
                 0.7 * 0.63, 1.3 * 0.63);
    for (std::size_t i = 0; i + 1 < 3; ++i) {
        const std::string pair = fmt::format("{} over {}", names[i + 1], names[i]);
        report.judge_below({"way of the caisson, " + pair, "-", "below 1", {}, {}},
                           ratio(outs[i + 1].caisson, outs[i].caisson), 1);
        report.judge_below({"deviation of ways, " + pair, "-", "below 1", {}, {}},
                           ratio(std::hypot(outs[i + 1].spread_x, outs[i + 1].spread_y),
                                 std::hypot(outs[i].spread_x, outs[i].spread_y)),
                           1);
        report.judge_below({"time to rest, " + pair, "-", "below 1", {}, {}}, outs[i + 1].steady_at / outs[i].steady_at,
                           1);
    }
}

void unit_cohesion(const CaseSetting& setting, CaseReport& report) {
    const RecordedWater water = record(setting);
    // 2 MPa and 0.7 MPa in tension on a hundredth of a square metre per contact of a metre; and on the whole of it
    const std::array<double, 3> share{0, 0.01, 1};
    std::array<Outcome, 3> outs;
    for (std::size_t i = 0; i < 3; ++i) {
        Pile pile(Unit::cube, {1, 2, 3}, 2e6 * share[i], 0.7e6 * share[i]);
        if (share[i] > 0) {
            solid::planar_dda::bond_contacts(pile.trial.model, pile.trial.settings, 1e-6, pile.trial.state);
        }
        outs[i] = run_pile(pile, water, 1);
    }
    const std::array<double, 2> printed{0.368, 0.238};
    const std::array<std::size_t, 2> units{1, 4};
    for (std::size_t k = 0; k < 2; ++k) {
        const double loose = norm(outs[0].moved[units[k]]), bonded = norm(outs[1].moved[units[k]]);
        report.state({fmt::format("unit {}: way without cohesion", units[k] + 1), "m"}, loose);
        report.judge(
            {fmt::format("unit {}: share of the way that cohesion takes", units[k] + 1), "-", printed[k], {}, {}},
            1 - ratio(bonded, loose), 0.15, 0.60);
    }
    report.judge({"time to rest with cohesion less that without", "s", "not later", {}, {}},
                 outs[1].steady_at - outs[0].steady_at, -10, 0);
    double most = 0;
    for (const Vec2& way : outs[2].moved) {
        most = std::max(most, std::abs(way.x - outs[2].moved[3].x));
    }
    report.judge_below({"bonded over whole faces: largest way of a unit against unit 4", "m", {}, 0.0, {}}, most, 0.02);
}

}  // namespace riprap::validation::ding
