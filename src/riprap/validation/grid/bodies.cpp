// SPDX-License-Identifier: Apache-2.0
// A body cut out of fixed cells that swings.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/coupling/cut_cells/cut_loads.hpp"
#include "riprap/validation/grid/cases.hpp"
#include "riprap/validation/grid/grid_trial.hpp"

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

}  // namespace riprap::validation::grid
