// SPDX-License-Identifier: Apache-2.0
// What the flow at the breakwater looks like [Ding2021, section 6.4.1].
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/ding/breakwater.hpp"

namespace riprap::validation::ding {

using namespace grid;

namespace {

GridTrial::Gauge level_at(double x) {
    return [x](const GridTrial& t) { return read_level(t.settings(), t.state(), {x, 0, 0}, 1) - Breakwater::depth; };
}

/// Returns whether a column holds air below water: a breaker or a jet.
bool overhangs(const GridTrial& trial, int i) {
    const Mesh& mesh = trial.settings().mesh;
    bool has_air = false;
    for (int j = 0; j < mesh.box.cells[1]; ++j) {
        const double fraction = trial.state().fraction[at(mesh.box.index(i, j, 0))];
        has_air = has_air || fraction < 0.1;
        if (has_air && fraction > 0.9) {
            return true;
        }
    }
    return false;
}

/// Mean velocity up the seaward slope in the armour layer [m/s].
double velocity_in_layer(const GridTrial& trial) {
    const double slope = Breakwater{}.slope;
    const double toe = Breakwater::caisson_front - slope * Breakwater::slope_height;
    double sum = 0;
    for (int k = 1; k < 6; ++k) {
        const double x = toe + 2 * k, y = (x - toe) / slope - 0.8;
        const Vec3 u = read_velocity(trial.settings(), trial.state(), {x, std::max(y, 0.3), 0});
        sum += (slope * u.x + u.y) / std::hypot(slope, 1) / 5;
    }
    return sum;
}

}  // namespace

void flow_patterns(const CaseSetting& setting, CaseReport& report) {
    const double h = setting.is_full ? 0.4 : 1.0;
    GridTrial trial = make_breakwater({h, h * 0.625, 2, 2});
    const std::array<double, 4> gauges{143, 169, 182, 201.5};
    for (const double x : gauges) {
        trial.add(fmt::format("{}", x), level_at(x));
    }
    trial.add("front", height_at_front);
    trial.add("layer", velocity_in_layer);
    double first_overhang = 0;
    trial.run(25, [&](GridTrial& t) {
        const Mesh& mesh = t.settings().mesh;
        for (int i = mesh.cell_at(0, 180); first_overhang == 0 && i < mesh.cell_at(0, Breakwater::caisson_front + 13);
             ++i) {
            if (t.state().time > 15 && overhangs(t, i)) {
                first_overhang = t.state().time;
            }
        }
    });
    report.judge({"height of the water at the wall, 19.5 s less 18.5 s", "m", "the crest grows", {}, {}},
                 trial.at_time("front", 19.5) - trial.at_time("front", 18.5), 0.01, 30);
    report.judge({"first air below water near the caisson: breaking", "s", 20.5, {}, {}}, first_overhang, 19.5, 21.5);
    report.judge({"highest water at the wall, 21.5 s", "m", "a jet, above 16 m", {}, {}}, trial.at_time("front", 21.5),
                 16, 30);
    std::array<double, 4> crest{};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& column = trial.column(fmt::format("{}", gauges[i]));
        crest[i] = *std::max_element(column.begin(), column.end());
        report.state({fmt::format("crest at P{}", i + 2), "m"}, crest[i]);
    }
    report.judge({"crest at P5 over that at P2", "-", "grows", {}, {}}, crest[3] / crest[0], 1, 3);
    const auto& layer = trial.column("layer");
    double forth = 0, back = 0, forth_at = 0, back_at = 0;
    for (std::size_t k = 0; k < layer.size(); ++k) {
        if (trial.time()[k] > 15 && layer[k] > forth) {
            forth = layer[k];
            forth_at = trial.time()[k];
        }
        if (trial.time()[k] > 15 && layer[k] < back) {
            back = layer[k];
            back_at = trial.time()[k];
        }
    }
    report.judge({"fastest flow in the layer, up the slope", "m/s", "with the wave", {}, {}}, forth, 0.05, 5);
    report.judge({"fastest flow in the layer, down the slope", "m/s", "then against it", {}, {}}, back, -5, -0.05);
    report.judge({"time of peak flow down the slope less that of peak flow up it", "s", "later", {}, {}},
                 back_at - forth_at, 0, 10);
    trial.report_books(report);
    Plot plot;
    plot.title = "Surface at P2 to P5 and height of the water at the caisson";
    plot.x.label = "time [s]";
    plot.y.label = "above the still water, and above the bed at the wall [m]";
    for (const double x : gauges) {
        plot.curves.push_back({fmt::format("x = {} m", x), trial.time(), trial.column(fmt::format("{}", x))});
    }
    plot.curves.push_back({"at the wall", trial.time(), trial.column("front")});
    write_plot(setting, "flow_patterns", plot);
}

}  // namespace riprap::validation::ding
