// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/core/index.hpp"
#include "riprap/solid/planar_dda/submatrices.hpp"
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

}  // namespace

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
