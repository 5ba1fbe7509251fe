// SPDX-License-Identifier: Apache-2.0
// Dam breaks on a dry floor: the pressure on the far wall.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/grid/cases.hpp"
#include "riprap/validation/grid/grid_trial.hpp"

namespace riprap::validation::grid {

namespace {

/// A plane tank with a column of water at its left, open above.
GridTrial column_in_tank(double width, double height, double length, double top, double h, Phase water) {
    GridSettings settings = make_tank(
        {}, {length, top, h}, {static_cast<int>(std::lround(length / h)), static_cast<int>(std::lround(top / h)), 1});
    settings.side[3].kind = SideKind::open;
    settings.water = water;
    return {settings, make_state(settings, [=](const Vec3& x) { return x.x < width && x.y < height; })};
}

double integral(const std::vector<double>& x, const std::vector<double>& y, double from, double to) {
    return mean_over(x, y, from, to) * (to - from);
}
double first_above(const std::vector<double>& x, const std::vector<double>& y, double level) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (y[i] > level) {
            return x[i];
        }
    }
    return std::nan("");
}

}  // namespace

void wall_impact(const CaseSetting& setting, CaseReport& report) {
    // [Lobovsky2014]; the incompressible comparison is that of [DeCourcy2024].
    const double depth = 0.3, unit = std::sqrt(depth / 9.81), scale = 997 * 9.81 * depth;
    const double h = depth / (setting.is_full ? 120 : 60);
    GridTrial trial = column_in_tank(0.6, depth, 1.61, 0.6, h, {997, 8.9e-7});
    const std::array<double, 4> heights{0.003, 0.015, 0.030, 0.080};
    const std::array<double, 4> impulses{4.011, 3.562, 2.933, 1.158};
    for (const double z : heights) {
        trial.add(fmt::format("{}", z), [z, scale](const GridTrial& t) {
            return read_pressure(t.settings(), t.state(), {1.61, z, 0}) / scale;
        });
    }
    trial.run(7.1 * unit);
    std::vector<double> time;
    for (const double t : trial.time()) {
        time.push_back(t / unit);
    }
    const std::vector<double>& low = trial.column("0.015");
    std::vector<double> mean = low;  // over 1 ms, as the record
    for (std::size_t i = 0; i < mean.size(); ++i) {
        mean[i] = i == 0 ? low[0] : mean_over(trial.time(), low, trial.time()[i] - 5e-4, trial.time()[i] + 5e-4);
    }
    mean.back() = low.back();
    report.judge({"arrival 15 mm above the floor, t sqrt(g/H)", "-", 2.468, {}, "median; no gate in the simulation"},
                 first_above(time, mean, 0.3), 2.418, 2.518);
    report.judge({"peak of the impact there, means over 1 ms, p/(rho g H)", "-", 1.858, {}, "2.5 to 97.5 %"},
                 *std::max_element(mean.begin(), mean.end()), 1.750, 2.013);
    report.judge({"impulse there from 2.4 to 4.0", "-", 1.426, {}, "median of the experiments"},
                 integral(time, low, 2.4, 4.0), 0.9 * 1.426, 1.1 * 1.426);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        report.judge({fmt::format("impulse at {} mm from 2.4 to 6.0", heights[i] * 1e3),
                      "-",
                      impulses[i],
                      {},
                      "another incompressible simulation"},
                     integral(time, trial.column(fmt::format("{}", heights[i])), 2.4, 6.0), 0.95 * impulses[i],
                     1.05 * impulses[i]);
    }
    trial.report_books(report);
    Plot plot{
        "Impact of a dam break, 15 mm above the floor", "", {"t sqrt(g/H)", false}, {"p/(rho g H)", false}, {}, false};
    plot.curves.push_back({"Riprap", time, mean, CurveStyle::line, 0});
    write_plot(setting, "wall_impact", plot);
}

void wall_pressure(const CaseSetting& setting, CaseReport& report) {
    // [Buchner2002]: column 2 H long, H high, tank 5.366 H long, pressure 0.2 H above the floor as transcribed. The
    // disc of the experiment, 0.09 m across and 0.16 m above the floor by its drawing, is reported.
    const double depth = 0.6, unit = std::sqrt(depth / 9.81), scale = 1000 * 9.81 * depth;
    GridTrial trial = column_in_tank(1.2, depth, 3.22, 1.8, depth / (setting.is_full ? 80 : 40), {1000, 1e-6});
    trial.add("disc", [scale](const GridTrial& t) {
        double sum = 0;
        for (int i = 0; i < 9; ++i) {
            sum += read_pressure(t.settings(), t.state(), {3.22, 0.115 + 0.09 * (i + 0.5) / 9, 0}) / 9;
        }
        return sum / scale;
    });
    trial.add("point", [scale](const GridTrial& t) {
        return read_pressure(t.settings(), t.state(), {3.22, 0.12, 0}) / scale;
    });
    trial.run(6.8 * unit);
    std::vector<double> time;
    for (const double t : trial.time()) {
        time.push_back(t / unit);
    }
    report.state({"mean from 2.7 to 5.2 over the disc"}, mean_over(time, trial.column("disc"), 2.7, 5.2));
    const auto& p = trial.column("point");
    report.judge({"arrival at the gauge, t sqrt(g/H)", "-", 2.49, {}, {}}, first_above(time, p, 0.1), 2.39, 2.59);
    report.judge({"mean from 2.7 to 5.2, p/(rho g H)", "-", 0.575, {}, "read as 0.55 to 0.60"},
                 mean_over(time, p, 2.7, 5.2), 0.9 * 0.55, 1.1 * 0.60);
    double second = 0, valley = 1e9;
    for (std::size_t i = 0; i < time.size(); ++i) {
        valley = time[i] > 4.5 && time[i] < 5.4 ? std::min(valley, p[i]) : valley;
        second = time[i] > 5.4 && time[i] < 6.5 ? std::max(second, p[i]) : second;
    }
    report.judge(
        {"second rise over the valley before it", "-", 0.78 / 0.51, {}, "air cushions it: there, of any height"},
        second / valley, 1.1, 10);
    trial.report_books(report);
}

}  // namespace riprap::validation::grid
