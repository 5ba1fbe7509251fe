// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/core/index.hpp"
#include "riprap/solid/planar_dda/submatrices.hpp"
#include "riprap/validation/dda/elastic_references.hpp"
#include "riprap/validation/dda/planar_cases.hpp"
#include "riprap/validation/dda/planar_trial.hpp"

namespace riprap::validation::dda {

namespace {

using geometry::Vec2;
using solid::planar_dda::Joint;

/// A joint that never breaks.
Joint glue(double stiffness) {
    return {.normal_stiffness = stiffness, .shear_stiffness = stiffness, .cohesion = 1e15, .tension = 1e15};
}

/// An elastic bar of `count` bonded blocks flies at a wall.
void hit_wall(int count, const CaseSetting& setting, CaseReport& report) {
    const double length = 1, speed = 1, E = 1e9, density = 2500, c = std::sqrt(E / density);
    PlanarTrial trial({density, E, 0}, glue(1e12));
    trial.settings = solid::planar_dda::settings_for(1);
    const std::int32_t wall = trial.add_material({density, E, 0}, {.normal_stiffness = 1e11, .shear_stiffness = 1e11});
    for (int k = 0; k < count; ++k) {
        trial.add_box({length * k / count, 0}, {length / count, 0.02});
    }
    solid::planar_dda::bond_contacts(trial.model, trial.settings, 1e-9, trial.state);
    trial.add_box({-0.5, -0.5}, {0.5, 1}, true, wall);
    for (int k = 0; k < count; ++k) {
        trial.set_velocity(k, {-speed, 0});
    }
    trial.gravity = {};
    trial.dt = 1e-6 * 50 / count;
    Curve stress{fmt::format("{} blocks", count), {}, {}, CurveStyle::line, -1};
    double first = std::nan(""), last = 0, plateau = 0;
    int plateau_count = 0;
    trial.run(2.6 * length / c, [&] {
        const double t = trial.time;
        if (trial.do_touch(0, count)) {
            first = std::isnan(first) ? t : first;
            last = t;
        }
        if (t > 0.4 * length / c && t < 1.6 * length / c) {
            plateau -= trial.state.stress_x[0];
            ++plateau_count;
        }
        stress.x.push_back(t * c / length);
        stress.y.push_back(-trial.state.stress_x[0] / (density * c * speed));
    });
    double momentum = 0;
    for (int k = 0; k < count; ++k) {
        momentum += trial.velocity(k).x / count;
    }
    const std::string name = fmt::format("bar of {} blocks: ", count);
    report.judge({name + "time at the wall", "s", {}, 2 * length / c, {}}, last - first, Relative{0.03});
    // A row of linear elements keeps a share of the impact as short waves; so does a row of blocks, which is one.
    const double element_rebound = rebound_of(
        {.elements = count, .length = length, .area = 0.02, .youngs_modulus = E, .density = density}, 2.6 * length / c);
    report.judge({name + "speed after it over that of linear finite elements", "-", {}, 1.0, {}},
                 momentum / speed / element_rebound, Relative{0.01});
    report.judge({name + "speed after it over the speed before", "-", {}, 1.0, {}}, momentum / speed, 0.98, 1.02,
                 CloseBand{element_rebound - 0.01, 1.02,
                           fmt::format("the elements that these blocks are keep {:.3f} of it: waves a few blocks long "
                                       "leave the front and stay in the bar",
                                       element_rebound)});
    report.judge({name + "mean stress at the wall", "Pa", {}, density * c * speed, {}}, plateau / plateau_count,
                 Relative{0.05});
    report.judge_below({name + "energy that the ledger misses, over its turnover", "-", {}, 0.0, {}, Kind::bookkeeping},
                       trial.ledger_error(), 1e-6);
    Plot plot;
    plot.title = "An elastic bar hits a wall";
    plot.x.label = "time c/L [-]";
    plot.y.label = "stress at the wall over density c v [-]";
    plot.curves = {stress};
    write_plot(setting, fmt::format("planar_bar_impact_{}", count), plot);
}

}  // namespace

void planar_bar_impact(const CaseSetting& setting, CaseReport& report) {
    for (const int count : {50, 100}) {
        hit_wall(count, setting, report);
    }
}

namespace {

/// A cantilever of quadrilaterals cut into four triangles each, held at its left end.
PlanarTrial cantilever(int along, int across) {
    const double length = 1, height = 0.1;
    PlanarTrial trial({1000, 1e6, 0.3}, glue(1e9));
    trial.settings = solid::planar_dda::settings_for(1, 0.002);
    for (int i = 0; i < along; ++i) {
        for (int j = 0; j < across; ++j) {
            const double x0 = length * i / along, x1 = length * (i + 1) / along;
            const double y0 = height * j / across, y1 = height * (j + 1) / across;
            const Vec2 middle{0.5 * (x0 + x1), 0.5 * (y0 + y1)};
            trial.add({{x0, y0}, {x1, y0}, middle});
            trial.add({{x1, y0}, {x1, y1}, middle});
            trial.add({{x1, y1}, {x0, y1}, middle});
            trial.add({{x0, y1}, {x0, y0}, middle});
        }
    }
    trial.add_box({-0.5, -0.5}, {0.5, 1.1}, true);
    solid::planar_dda::bond_contacts(trial.model, trial.settings, 1e-9, trial.state);
    trial.gravity = {};
    return trial;
}

/// The same as finite elements.
TriangleMesh cantilever_elements(int along, int across, double load) {
    const double length = 1, height = 0.1;
    TriangleMesh mesh(1e6, 0.3, 1000);
    for (int i = 0; i < along; ++i) {
        for (int j = 0; j < across; ++j) {
            const Vec2 a{length * i / along, height * j / across};
            const Vec2 c{length * (i + 1) / along, height * (j + 1) / across};
            const Vec2 b{c.x, a.y}, d{a.x, c.y}, middle = 0.5 * (a + c);
            for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, d}, {d, a}}) {
                mesh.add({p, q, middle});
            }
        }
    }
    for (int j = 0; j <= across; ++j) {
        mesh.hold({0, height * j / across});
        const double share = (j == 0 || j == across ? 0.5 : 1.0) / across;
        mesh.load({length, height * j / across}, {0, -share * load});
    }
    return mesh;
}

/// Lets a bent cantilever go with steps of `step` over the exact first frequency.
void swing_cantilever(const PlanarTrial& bent, double step, double start, std::int32_t tip, double element_frequency,
                      const CaseSetting& setting, CaseReport& report) {
    PlanarTrial swing = bent;
    const double omega = 3.20967, period = 2 * std::numbers::pi / omega;
    swing.dt = step / omega;
    std::vector<double> crossings;
    double before = swing.center(tip).y - start, early = 0, early_time = 0;
    Curve curve{"tip", {}, {}, CurveStyle::line, -1};
    swing.run(4 * period, [&] {
        const double now = swing.center(tip).y - start;
        if (before * now < 0) {
            crossings.push_back(swing.time - swing.dt * now / (now - before));
        }
        if (early == 0 && swing.time > period) {  // higher modes have died out
            early = energies_of(swing.model, swing.state).total();
            early_time = swing.time;
        }
        before = now;
        curve.x.push_back(swing.time);
        curve.y.push_back(now);
    });
    if (crossings.size() < 6) {
        report.fail("the cantilever does not swing");
        return;
    }
    const double measured = 4 * std::numbers::pi / (crossings[4] - crossings[0]);
    const double late = energies_of(swing.model, swing.state).total();
    const std::string name = fmt::format("let go, omega dt = {}: ", step);
    report.judge({name + "first frequency", "rad/s", {}, omega, "the mesh's own, see the line below"}, measured,
                 Relative{0.03});
    report.judge({name + "first frequency, against finite elements of this mesh", "rad/s", {}, element_frequency, {}},
                 measured, Relative{0.02});
    report.judge({name + "damping ratio by the integrator alone",
                  "-",
                  {},
                  0.25 * measured * swing.dt,
                  "omega dt/4 with the measured omega"},
                 std::log(early / late) / (2 * measured * (swing.time - early_time)), Relative{0.05});
    Plot plot;
    plot.title = "A cantilever of 256 bonded triangles let go";
    plot.x.label = "time [s]";
    plot.y.label = "tip [m]";
    plot.curves = {curve};
    write_plot(setting, fmt::format("planar_cantilever_{}", step), plot);
}

}  // namespace

void planar_cantilever(const CaseSetting& setting, CaseReport& report) {
    const int along = 16, across = 4;
    const double load = 1;
    PlanarTrial trial = cantilever(along, across);
    const auto add_tip_load = [&](double force) {
        auto builder = trial.builder();
        for (int j = 0; j < across; ++j) {
            const std::int32_t right = 4 * ((along - 1) * across + j) + 1;
            builder.add_load(right, {1, 0.1 * (j + 0.5) / across}, {0, -force / across});
        }
    };
    add_tip_load(load);
    const std::int32_t tip = 4 * ((along - 1) * across + across / 2) + 1;
    const double start = trial.center(tip).y;
    trial.settle(0.5, 200);
    report.judge({"tip load, 16 x 4 cells of four triangles: deflection",
                  "m",
                  {},
                  4.031e-3,
                  "Timoshenko; triangles of constant strain are too stiff in bending, see the line below"},
                 start - trial.center(tip).y, Relative{0.03});
    const TriangleMesh elements = cantilever_elements(along, across, load);
    const std::vector<double> deflected = elements.deflect();
    double element_deflection = 0;  // of the centroid of the block that is looked at
    const double y0 = 0.1 * (across / 2) / across, y1 = 0.1 * (across / 2 + 1) / across;
    for (const Vec2& corner : {Vec2{1, y0}, Vec2{1, y1}, Vec2{1 - 0.5 / along, 0.5 * (y0 + y1)}}) {
        element_deflection -= deflected[2 * at(elements.node_at(corner)) + 1] / 3;
    }
    report.judge({"tip load, against finite elements of this mesh: deflection of the block at the tip",
                  "m",
                  {},
                  element_deflection,
                  "blocks of constant strain tied at their corners"},
                 start - trial.center(tip).y, Relative{0.02});
    trial.model.point_loads.clear();
    for (const double step : {0.05, 0.1}) {
        swing_cantilever(trial, step, start, tip, elements.first_frequency(), setting, report);
    }
}

void planar_disc(const CaseSetting&, CaseReport& report) {
    // A disc of rings and sectors, each cell cut into triangles about its middle, pressed at top and bottom.
    const int rings = 8, sectors = 32;
    const double diameter = 0.1, load = 1e4;
    PlanarTrial trial({2500, 1e9, 0.2}, glue(1e12));
    trial.settings = solid::planar_dda::settings_for(0.1, 0.001);
    const auto point = [&](int ring, int sector) {
        const double r = 0.5 * diameter * ring / rings, a = 2 * std::numbers::pi * sector / sectors;
        return r * Vec2{std::cos(a), std::sin(a)};
    };
    std::int32_t top = -1, bottom = -1;
    double central_x = 0, central_y = 0, central_area = 0;
    std::vector<std::int32_t> central;
    for (int i = 0; i < sectors; ++i) {
        central.push_back(trial.add({{0, 0}, point(1, i), point(1, i + 1)}));
        for (int r = 1; r < rings; ++r) {
            const Vec2 a = point(r, i), b = point(r + 1, i), c = point(r + 1, i + 1), d = point(r, i + 1);
            const Vec2 middle = 0.25 * (a + b + c + d);
            trial.add({a, b, middle});
            const std::int32_t outer = trial.add({b, c, middle});
            trial.add({c, d, middle});
            trial.add({d, a, middle});
            top = r + 1 == rings && i == sectors / 4 ? outer : top;
            bottom = r + 1 == rings && i == 3 * sectors / 4 ? outer : bottom;
        }
    }
    solid::planar_dda::bond_contacts(trial.model, trial.settings, 1e-10, trial.state);
    trial.gravity = {};
    trial.builder().add_load(top, {0, 0.5 * diameter}, {0, -load});
    trial.builder().add_load(bottom, {0, -0.5 * diameter}, {0, load});
    // Nothing but inertia keeps the disc from toppling between its loads: 2 I/dt^2 of it against their P D, in steps of
    // 1 ms 50 times as much. The blocks carry the load after a few.
    trial.settle(1e-3, 40);
    for (const std::int32_t block : central) {
        const double area = trial.model.area[at(block)];
        central_area += area;
        central_x += area * trial.state.stress_x[at(block)];
        central_y += area * trial.state.stress_y[at(block)];
    }
    const double unit = load / (std::numbers::pi * diameter);
    const std::string name = fmt::format("{} blocks: mean stress in the middle, ", trial.model.block_count());
    report.judge({name + "across the load", "Pa", {}, 2 * unit, {}}, central_x / central_area, Relative{0.03});
    report.judge({name + "along it", "Pa", {}, -6 * unit, {}}, central_y / central_area, Relative{0.03});
}

}  // namespace riprap::validation::dda
