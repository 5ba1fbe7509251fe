// SPDX-License-Identifier: Apache-2.0
// Water entry of a cylinder [Mellado2021, 5.3.2] [Greenhow1983].
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/mellado/cases.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::mellado {

namespace {

using water::interpolated;
using water::WaterTrial;

constexpr double gravity = 9.81;

/// Worst of the momentum that both ledgers miss, over `scale` [-].
double momentum_gap(const WaterTrial& trial, double scale) {
    const sim::Ledger& ledger = trial.report().ledger;
    return (norm(ledger.momentum_residual) + norm(ledger.fluid.momentum_residual)) / scale;
}

void judge_books(CaseReport& report, const WaterTrial& trial, const std::string& run) {
    water::judge_ledger(report, trial, run);
    // Pair forces are summed in float: off by up to 2^-24 of terms that are 100 times the weight of a particle.
    report.judge_below({run + ": momentum that the ledgers miss, over weight of water times time",
                        "-",
                        {},
                        0.0,
                        {},
                        Kind::bookkeeping},
                       momentum_gap(trial, trial.report().ledger.fluid.mass * gravity * trial.now()),
                       100.0 / (1 << 24));
}

/// Penetration over D against t sqrt(g/D), of boundary elements and of SPH.
struct CylinderEntry {
    double density, until;  ///< [kg/m^3], [-]
    std::vector<double> bem_time, bem, sph_time, sph, measured_time, measured;
};

const std::array<CylinderEntry, 2>& cylinder_entries() {
    static const std::array<CylinderEntry, 2> all{
        {{500,
          1.3,
          {0.151, 0.321, 0.504, 0.668, 0.838, 0.985, 1.159, 1.279},
          {0.263, 0.526, 0.768, 0.956, 1.129, 1.267, 1.388, 1.479},
          {0.153, 0.334, 0.485, 0.688, 0.860, 1.035, 1.162, 1.293, 1.417, 1.500},
          {0.306, 0.574, 0.764, 0.989, 1.144, 1.274, 1.351, 1.415, 1.456, 1.475},
          {0.100, 0.277, 0.378, 0.797, 1.131},
          {0.168, 0.495, 0.609, 1.068, 1.220}},
         {1000,
          1.8,
          {0.112, 0.250, 0.449, 0.587, 0.862, 1.077, 1.269, 1.558, 1.811},
          {0.245, 0.547, 0.891, 1.125, 1.542, 1.865, 2.089, 2.411, 2.672},
          {0.163, 0.250, 0.465, 0.628, 0.808, 0.949, 1.160, 1.404, 1.554, 1.740, 1.901},
          {0.396, 0.563, 0.943, 1.219, 1.495, 1.682, 1.943, 2.182, 2.323, 2.448, 2.542},
          {0.138, 0.843, 1.032, 1.881},
          {0.401, 1.682, 2.010, 2.724}}}};
    return all;
}

struct CylinderRun {
    std::vector<double> time, depth;  ///< t sqrt(g/D), penetration over D
    double worst{0};                  ///< largest distance from the band of both models [-]
    double slam{0};                   ///< largest load over rho v^2 D/2 [-]
};

CylinderRun run_cylinder(const CaseSetting& setting, CaseReport* report, const CylinderEntry& entry, double spacing) {
    constexpr double diameter = 0.11, level = 0.88, speed = 2.955;
    const double unit = std::sqrt(diameter / gravity);
    const std::vector<std::string> overrides{fmt::format("body.cylinder.density={}", entry.density),
                                             fmt::format("fluid.spacing={}", spacing)};
    WaterTrial trial(setting, overrides);
    trial.run();
    CylinderRun run;
    const std::vector<double>&y = trial.column("cylinder.position.y"), &force = trial.column("cylinder.fluid_force.y");
    for (std::size_t i = 0; i < trial.time().size(); ++i) {
        const double time = trial.time()[i] / unit, depth = (level - y[i]) / diameter + 0.5;
        run.time.push_back(time);
        run.depth.push_back(depth);
        run.slam = std::max(run.slam, force[i] / (0.5 * 1000 * speed * speed * diameter));
        if (time >= std::max(entry.bem_time.front(), entry.sph_time.front()) && time <= entry.until) {
            const double a = interpolated(entry.bem_time, entry.bem, time),
                         b = interpolated(entry.sph_time, entry.sph, time);
            run.worst = std::max({run.worst, std::min(a, b) - depth, depth - std::max(a, b)});
        }
    }
    if (report != nullptr) {
        judge_books(*report, trial, fmt::format("{:g}", entry.density));
    }
    return run;
}

}  // namespace

void cylinder_entry(const CaseSetting& setting, CaseReport& report) {
    const double spacing = setting.is_full ? 0.0022 : 0.006875;  // D/50, D/16
    Plot plot{"A cylinder falls into water",
              "Greenhow and Lin 1983, Sun and others 2018",
              {"t sqrt(g/D) [-]", false},
              {"penetration/D [-]", false},
              {},
              false};
    for (const CylinderEntry& entry : cylinder_entries()) {
        const std::string name = fmt::format("{:g}", entry.density);
        const CylinderRun fine = run_cylinder(setting, &report, entry, spacing),
                          coarse = run_cylinder(setting, nullptr, entry, 2 * spacing);
        report.judge_below(
            {name + ": largest distance of the penetration over D from both models", "-", {}, 0.0, "must"}, fine.worst,
            0.06);
        report.judge_below({name + ": the same, beyond the source", "-", {}, 0.0, {}}, fine.worst, 0.03);
        report.judge({name + ": distance at twice the spacing over that", "-", {}, {}, "falls with the spacing"},
                     coarse.worst / std::max(fine.worst, 1e-3), 1, 1e3);
        report.state({name + ": largest load over rho v^2 D/2", "-", "von Karman's first instant: pi"}, fine.slam);
        double worst = 0;
        for (std::size_t i = 0; i < entry.measured.size(); ++i) {
            worst = std::max(worst,
                             std::abs(interpolated(fine.time, fine.depth, entry.measured_time[i]) - entry.measured[i]));
        }
        report.judge_below({name + ": largest distance from the experiment, over D", "-", {}, 0.0, "Greenhow and Lin"},
                           worst, 0.08);
        plot.curves.push_back({name + ", measured", entry.measured_time, entry.measured, CurveStyle::markers, -1});
        plot.curves.push_back({name + ", boundary elements", entry.bem_time, entry.bem, CurveStyle::markers, -1});
        plot.curves.push_back({name + ", ours", fine.time, fine.depth, CurveStyle::line, -1});
    }
    write_plot(setting, "cylinder_entry", plot);
}

}  // namespace riprap::validation::mellado
