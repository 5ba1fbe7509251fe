// SPDX-License-Identifier: Apache-2.0
// A solitary wave travels along a flume and runs up an upright wall.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/validation/water/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"
#include "riprap/wave/solitary_wave.hpp"

namespace riprap::validation::water {

namespace {

constexpr double depth = 0.5, height = 0.1;  ///< of case.toml

}  // namespace

void solitary_wave(const CaseSetting& setting, CaseReport& report) {
    std::vector<std::string> finer;
    if (setting.is_full) {
        finer = {"fluid.spacing=0.0125"};
    }
    WaterTrial trial(setting, finer);
    trial.run();
    const wave::SolitaryWave theory{height, depth, 9.81};
    // The crest comes by at x before it can return from the wall at 12.5 m.
    const double start = 0.5 * trial.time().back();
    const auto crest = [&](const char* gauge, double until) {
        return crest_of(trial.time(), trial.column(gauge), until);
    };
    const Crest near = crest("near", start + 1.5), middle = crest("middle", start + 2.5);
    const Crest far = crest("far", start + 3.2);
    report.judge({"height at 5 m", "m", {}, height, "of the wave asked for"}, near.level - depth, Relative{0.02});
    report.judge({"celerity from 5 to 10 m", "m/s", {}, theory.celerity(), "sqrt(g (d + H))"},
                 5 / (far.time - near.time), Relative{0.01});
    report.judge_below({"loss of height over ten depths", "-", {}, 0.0, {}},
                       1 - (far.level - depth) / (near.level - depth), 0.02);
    report.judge({"height at 7.5 m", "m", {}, height, "likewise"}, middle.level - depth, Relative{0.02});
    // Run-up on an upright wall to third order of e = H/d, H as it arrives [SuMirie1980].
    const double e = (far.level - depth) / depth, run_up = depth * (2 * e + 0.5 * e * e + 0.75 * e * e * e);
    const std::vector<double>& wall = trial.column("wall");  // reads too low at rest: the wall cuts its kernel
    report.judge({"run-up on the wall", "m", {}, run_up, "2 e + e^2/2 + 3 e^3/4 depths"},
                 *std::max_element(wall.begin(), wall.end()) - wall.front(), Relative{0.08});
    judge_ledger(report, trial);
    Plot plot{"A solitary wave", "0.1 m high over 0.5 m", {"time [s]", false}, {"surface [m]", false}, {}, false};
    for (const char* name : {"near", "middle", "far", "wall"}) {
        plot.curves.push_back({name, trial.time(), trial.column(name), CurveStyle::line, -1});
    }
    std::vector<double> shape;
    for (const double t : trial.time()) {
        shape.push_back(depth + theory.elevation(theory.celerity() * (t - near.time)));
    }
    plot.curves.push_back({"theory at 5 m", trial.time(), shape, CurveStyle::dashed, 0});
    write_plot(setting, "solitary_wave", plot);
}

}  // namespace riprap::validation::water
