// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "riprap/validation/zhao/cases.hpp"
#include "riprap/validation/zhao/pile.hpp"

namespace riprap::validation::zhao {

namespace {

/// The potential that the normal force f asks of a corner of a large tetrahedron, r_a = R/3 = 2/3 mm, upright on a face
/// of a small one, r_b = 1/6 mm. The corner takes the volume V = 0.2165 d^3, the energy k V d (1/(4 r_b) + 1/(12 r_a)),
/// so f = 0.2165 k d^3 (1/r_b + 1/(3 r_a)); phi = d/r_b.
double corner_potential(double force) {
    constexpr double stiffness = 1e6, large = 2e-3 / 3, small = 0.5e-3 / 3;  // [Pa], [m], [m]
    const double corner = std::pow(1.5, 1.5) / (6 * std::sqrt(2.0));
    return std::cbrt(force / (corner * stiffness * (1 / small + 1 / (3 * large)))) / small;
}

}  // namespace

void mixed_pile(const CaseSetting& setting, CaseReport& report) {
    Trial pile = trial_of(setting);
    const PileRun run = fall_to_rest(pile, 20e-3, setting, "mixed_pile");
    judge_pile(run, corner_potential, "a corner of a large tetrahedron on a small one", "1093 blocks, ", report);
    report.judge(
        {"1093 blocks, fall of the centre of mass", "m", 5e-3, {}, "the heap before the fall is only in a figure"},
        run.fall, 4.5e-3, 5.5e-3);
    Plot plot;
    plot.title = "1093 blocks: kinetic energy over its largest";
    plot.subtitle = "means over 0.02 s";
    plot.x.label = "time [s]";
    plot.y = {"kinetic energy over its largest [-]", true};
    plot.curves.push_back({"ours", run.times, run.kinetic, CurveStyle::line, -1});
    write_plot(setting, "mixed_pile_energy", plot);
}

}  // namespace riprap::validation::zhao
