// SPDX-License-Identifier: Apache-2.0
// A solitary wave on an upright wall.
#include <fmt/format.h>

#include <algorithm>

#include "riprap/fluid/grid/wave_side.hpp"
#include "riprap/validation/grid/cases.hpp"
#include "riprap/validation/grid/grid_trial.hpp"

namespace riprap::validation::grid {

namespace {

/// Edges from the bed to `top`: cells of h from `low` to `high`, of 4 h elsewhere.
std::vector<double> edges_around(double low, double high, double top, double h) {
    std::vector<double> y{0};
    const auto fill = [&y](double to, double width) {
        while (y.back() < to - 1e-9) {
            y.push_back(std::min(to, y.back() + width));
        }
    };
    fill(low, 4 * h);
    fill(high, h);
    fill(top, 4 * h);
    return y;
}

}  // namespace

void wall_run_up(const CaseSetting& setting, CaseReport& report) {
    // R/d = 2 e + e^2/2 + 3 e^3/4, e = H/d [SuMirie1980]; 8 cells to the height of the wave, 16 with --full.
    const double d = 0.5, end = 20 * d;
    for (const double e : {0.1, 0.2, 0.3}) {
        const double h = e * d / (setting.is_full ? 16 : 8);
        GridSettings settings;
        settings.mesh = Mesh({uniform_edges(0, end, static_cast<int>(end / (4 * h))),
                              edges_around((1 - 0.5 * e) * d, (1 + 3 * e) * d, (1 + 5 * e) * d, h),
                              {0, 0.1}},
                             2);
        settings.side[3].kind = SideKind::open;
        const wave::SteadyWave wave = wave::solitary_wave(e * d, d, 9.81);
        double foot = 0;
        while (wave.elevation(foot) > 1e-3 * e * d) {
            foot += 0.05 * d;
        }
        settings.side[0] = wave_side(settings.mesh, 0, 1, 0, d, waves_of(wave, foot / wave.celerity), false);
        GridTrial trial(settings, make_state(settings, [=](const Vec3& x) { return x.y < d; }));
        trial.add("wall", [=](const GridTrial& t) {
            return read_level(t.settings(), t.state(), {end - 2 * h, 0, 0}, 1) - d;
        });
        trial.run((foot + end + 6 * d) / wave.celerity);
        const std::vector<double>& wall = trial.column("wall");
        report.judge({fmt::format("H/d = {}: run-up on the wall over the depth", e),
                      "-",
                      {},
                      2 * e + 0.5 * e * e + 0.75 * e * e * e,
                      "2 e + e^2/2 + 3 e^3/4"},
                     *std::max_element(wall.begin(), wall.end()) / d, Relative{0.05});
        trial.report_books(report);
    }
}

}  // namespace riprap::validation::grid
