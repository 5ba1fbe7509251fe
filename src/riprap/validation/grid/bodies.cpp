// SPDX-License-Identifier: Apache-2.0
// Bodies cut out of fixed cells: still, driven and free.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/coupling/cut_cells/cut_loads.hpp"
#include "riprap/geometry/shapes.hpp"
#include "riprap/validation/grid/cases.hpp"
#include "riprap/validation/grid/grid_trial.hpp"
#include "riprap/validation/water/obstacle_levels.hpp"

namespace riprap::validation::grid {

namespace {

using coupling::CutBodies;
using coupling::GridBody;

/// A prism of n corners on a circle, as deep as the plane flow and more.
GridBody cylinder(double x, double y, double radius, int corners = 96) {
    GridBody body;
    geometry::Polyhedron prism;
    std::vector<std::int32_t> low, high;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * (i + 0.5) / corners;
        // corners a little outside, so that the area is that of the circle
        const double r = radius * std::sqrt(2 * M_PI / corners / std::sin(2 * M_PI / corners));
        prism.vertices.push_back({x + r * std::cos(angle), y + r * std::sin(angle), -10});
        prism.vertices.push_back({x + r * std::cos(angle), y + r * std::sin(angle), 10});
        low.insert(low.begin(), 2 * i);
        high.push_back(2 * i + 1);
    }
    prism.faces.push_back(low);
    prism.faces.push_back(high);
    for (int i = 0; i < corners; ++i) {
        const int next = (i + 1) % corners;
        prism.faces.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    }
    body.parts.push_back(prism);
    body.centre = {x, y, 0};
    return body;
}

GridBody box_at(const Vec3& low, const Vec3& high) {
    GridBody body;
    body.parts.push_back(geometry::moved(geometry::box(high - low), Pose{(low + high) * 0.5, Quat{}}));
    body.centre = (low + high) * 0.5;
    return body;
}

/// Steps a trial with one body, which `place` puts where it is at the end of each step; returns its loads.
struct Moving {
    GridTrial& trial;
    CutBodies cut{};
    coupling::GridLoad step(const GridBody& body, double dt) {
        cut = coupling::cut_bodies(trial.settings().mesh, {body});
        set_open_shares(trial.settings(), trial.state(), trial.scratch(), cut.open);
        advance(trial.settings(), trial.state(), trial.scratch(), dt);
        return coupling::cut_loads(trial.settings(), trial.state(), trial.scratch(), {body}, cut)[0];
    }
};

GridSettings one_fluid(const Vec3& high, const std::array<int, 3>& cells, double density, double viscosity) {
    GridSettings settings = make_tank({}, high, cells);
    settings.has_surface = false;
    settings.gravity = {};
    settings.water = {density, viscosity};
    for (int side = 0; side < 4; ++side) {
        settings.side[at(side)].kind = SideKind::no_slip;
    }
    return settings;
}
GridState at_rest(const GridSettings& settings) {
    return make_state(
        settings, [](const Vec3&) { return 1.0; }, [](const Vec3&) { return Vec3{}; });
}

}  // namespace

void oscillating_cylinder(const CaseSetting& setting, CaseReport& report) {
    // Re = 100, KC = 5: x = -A sin(2 pi f t), A = KC D/(2 pi). The force is smooth but for cells that cover and
    // uncover.
    const int per_diameter = setting.is_full ? 24 : 12;
    const double diameter = 1, nu = 0.01, frequency = 1.0 / 5, amplitude = 5 / (2 * M_PI);
    GridSettings settings = one_fluid({16, 10, 1}, {16 * per_diameter, 10 * per_diameter, 1}, 1, nu);
    GridTrial trial(settings, at_rest(settings));
    Moving moving{trial};
    std::vector<double> force, time;
    const double dt = std::min(0.4 / per_diameter / 2, 0.1 / (per_diameter * per_diameter * nu)), end = 5;
    const double omega = 2 * M_PI * frequency;
    for (int i = 0; i < static_cast<int>(end / dt); ++i) {
        const double t = trial.state().time + dt;
        GridBody body = cylinder(8 - amplitude * std::sin(omega * t), 5, 0.5 * diameter);
        body.velocity = {-amplitude * omega * std::cos(omega * t), 0, 0};
        force.push_back(moving.step(body, dt).force().x);
        time.push_back(t);
    }
    // noise: what a parabola through the neighbours misses, against the size of the force
    double noise = 0, size = 0;
    const auto from = force.size() / 5;
    for (std::size_t i = from; i + 2 < force.size(); ++i) {
        const double smooth = (-force[i - 2] + 4 * force[i - 1] + 4 * force[i + 1] - force[i + 2]) / 6;
        noise = std::max(noise, std::abs(force[i] - smooth));
        size = std::max(size, std::abs(force[i]));
    }
    report.state({fmt::format("largest force over half rho U^2 D, {} cells per diameter", per_diameter)}, size / 0.5);
    report.judge_below({"noise of the force from step to step over its largest", "-", {}, 0.0, {}}, noise / size, 0.05);
}

void moving_square(const CaseSetting& setting, CaseReport& report) {
    // SPHERIC 6: a square of side 1 in a box of 10 x 5 takes up U = 1 over about a second, Re = 100.
    const int per_side = setting.is_full ? 24 : 12;
    GridSettings settings = one_fluid({10, 5, 1}, {10 * per_side, 5 * per_side, 1}, 1, 0.01);
    GridTrial trial(settings, at_rest(settings));
    Moving moving{trial};
    // drag over half rho U^2 D by finite differences of the benchmark's authors [Colicchio2006]
    const double dt = std::min(0.4 / per_side / 2, 0.08 / (per_side * per_side * 0.01));
    double x = 1.5, sum = 0, count = 0, shear = 0;
    const auto speed = [](double t) { return t < 1 ? t * t * t * (10 - 15 * t + 6 * t * t) : 1.0; };
    while (trial.state().time < 5) {
        const double t = trial.state().time + dt, u = speed(t);
        x += 0.5 * dt * (u + speed(t - dt));
        GridBody body = box_at({x - 0.5, 2.0, -10}, {x + 0.5, 3.0, 10});
        body.velocity = {u, 0, 0};
        const coupling::GridLoad load = moving.step(body, dt);
        if (t > 3) {
            sum -= load.force().x / 0.5;
            shear -= load.shear.x / 0.5;
            count += 1;
        }
    }
    report.judge({fmt::format("drag coefficient, mean from 3 to 5 s, {} cells per side", per_side), "-", 1.878, {}, {}},
                 sum / count, 0.95 * 1.878, 1.05 * 1.878);
    report.judge({"the part of shear", "-", 0.19, {}, {}}, shear / count, 0.95 * 0.19, 1.05 * 0.19);
}

void settling_cylinder(const CaseSetting& setting, CaseReport& report) {
    // [Glowinski2001]: a cylinder of 2.5 mm and 1250 kg/m^3 falls in a channel 2 cm wide, nu = 1e-5 m^2/s.
    const int per_diameter = setting.is_full ? 25 : 12;
    const double diameter = 0.0025, h = diameter / per_diameter, area = M_PI * diameter * diameter / 4;
    GridSettings settings =
        one_fluid({0.02, 0.06, 0.001},
                  {static_cast<int>(std::lround(0.02 / h)), static_cast<int>(std::lround(0.06 / h)), 1}, 1000, 1e-5);
    GridTrial trial(settings, at_rest(settings));
    Moving moving{trial};
    const double depth = 0.001, mass = 1250 * area * depth, weight = 250 * area * depth * 9.81;
    const double dt = std::min(0.08 * h * h / 1e-5, 0.3 * h / 0.06), end = 0.52;
    double y = 0.04, v = 0, force = 0, added = 1000 * area * depth;
    // The added mass of the last force is taken to the left side: (m + m_a) dv/dt = F + W + m_a a_before.
    double acceleration = 0;
    while (trial.state().time < end) {
        acceleration = (force - weight + added * acceleration) / (mass + added);
        v += dt * acceleration;
        y += dt * v;
        GridBody body = cylinder(0.01, y, 0.5 * diameter);
        body.velocity = {0, v, 0};
        force = moving.step(body, dt).force().y;
    }
    report.judge({fmt::format("terminal speed, {} cells per diameter", per_diameter), "m/s", -0.0557, {}, {}}, v,
                 -1.03 * 0.0557, -0.97 * 0.0557);
}

namespace {

/// Judges the heights at every gauge from the time at which the experiment has water there, as the water's case does.
void judge_levels(const GridTrial& trial, CaseReport& report) {
    constexpr double depth = 0.55;
    for (const water::ObstacleLevels& measured : water::obstacle_levels) {
        double error = 0, sum = 0, first = 0, count = 0;
        for (std::size_t i = 0; i < measured.height.size(); ++i) {
            const double t = 0.5 * static_cast<double>(i + 1);
            if (t > measured.arrival) {
                first = first > 0 ? first : t;
                error += std::abs(trial.at_time(measured.gauge, t) - measured.height[i]);
                sum += measured.height[i];
                count += 1;
            }
        }
        report.judge_below({fmt::format("{}: mean error to 6 s over the mean height measured", measured.gauge),
                            "-",
                            {},
                            0.0,
                            fmt::format("every 0.5 s from {:.1f} s", first)},
                           error / sum, 0.05);
        if (measured.is_named) {
            report.judge_below({fmt::format("{}: mean error to 6 s over the depth", measured.gauge), "-", {}, 0.0, {}},
                               error / count / depth, 0.03);
        }
    }
}

}  // namespace

void dam_break_obstacle(const CaseSetting& setting, CaseReport& report) {
    // SPHERIC 2 [Kleefsman2005]; x from the far wall behind the box.
    const int per_metre = setting.is_full ? 40 : 20;
    GridSettings settings = make_tank({}, {3.22, 1, 1}, {static_cast<int>(3.22 * per_metre), per_metre, per_metre});
    settings.gravity = {0, 0, -9.81};
    settings.side[5].kind = SideKind::open;
    GridTrial trial(settings, make_state(settings, [](const Vec3& x) { return x.x > 1.992 && x.z < 0.55; }));
    set_open_shares(settings, trial.state(), trial.scratch(),
                    coupling::cut_bodies(settings.mesh, {box_at({0.6635, 0.295, -1}, {0.8245, 0.698, 0.161})}).open);
    for (const water::ObstacleLevels& measured : water::obstacle_levels) {
        trial.add(measured.gauge, [place = measured.place](const GridTrial& t) {
            return read_level(t.settings(), t.state(), {place, 0.5, 0}, 2);
        });
    }
    trial.add("P1", [](const GridTrial& t) { return read_pressure(t.settings(), t.state(), {0.86, 0.471, 0.021}); });
    trial.run(6);
    judge_levels(trial, report);
    report.judge({"impulse in front of P1 from 0.3 to 1.2 s", "Pa s", 3481.0, {}, {}},
                 0.9 * mean_over(trial.time(), trial.column("P1"), 0.3, 1.2), 0.9 * 3481, 1.1 * 3481);
    trial.report_books(report);
}

}  // namespace riprap::validation::grid
