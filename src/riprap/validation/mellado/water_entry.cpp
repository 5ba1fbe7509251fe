// SPDX-License-Identifier: Apache-2.0
// Water entry of a block [Mellado2021, 5.3.1] and of a cylinder [Mellado2021, 5.3.2] [Greenhow1983].
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/validation/mellado/cases.hpp"
#include "riprap/validation/mellado/mean_surface.hpp"
#include "riprap/validation/water/water_trial.hpp"

namespace riprap::validation::mellado {

namespace {

using water::interpolated;
using water::WaterTrial;

constexpr double gravity = 9.81;

double mean_of(const WaterTrial& trial, const std::string& name, double start, double end) {
    return trial.mean(name, start, std::min(end, trial.now()));
}

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

/// Mean centre of the block over 1.3 s in two published models [Mellado2021, tables 5.10, 5.11].
struct BlockEntry {
    double density;
    double robb_x, robb, lee, thesis;  ///< [m]
    double tolerance;                  ///< [-]
};
constexpr std::array block_entries{BlockEntry{500, 0.2522, 0.5255, 0.5253, 0.5396, 0.03},
                                   BlockEntry{1000, 0.2506, 0.4186, 0.4161, 0.4792, 0.05},
                                   BlockEntry{2000, 0.2473, 0.2056, 0.1904, 0.2088, 0.08}};

void judge_means(CaseReport& report, const WaterTrial& trial, const BlockEntry& entry, const std::string& run) {
    const double y = mean_of(trial, "block.position.y", 0, 1.3);
    report.judge({run + ": mean height of the centre over 1.3 s",
                  "m",
                  entry.thesis,
                  {},
                  fmt::format("Robb {} m, Lee {} m; the source prints no window", entry.robb, entry.lee)},
                 y, std::min(entry.robb, entry.lee) * (1 - entry.tolerance),
                 std::max(entry.robb, entry.lee) * (1 + entry.tolerance));
    report.judge({run + ": mean x of the centre over 1.3 s", "m", entry.robb_x, 0.25, "symmetry"},
                 mean_of(trial, "block.position.x", 0, 1.3), Relative{0.022});
    for (const double end : {1.2, 2.0}) {
        report.state({fmt::format("{}: mean height over {} s", run, end), "m", ""},
                     mean_of(trial, "block.position.y", 0, end));
    }
}

void judge_end(CaseReport& report, const WaterTrial& trial, double density, const std::string& run, double spacing) {
    const double end = trial.now(), depth = 0.5, weight = density * 0.01 * gravity;
    report.judge({run + ": level at the end",
                  "m",
                  {},
                  depth + 0.01 * std::min(density, 1000.0) / 1000 / 0.5,
                  "volume over width; mean of half a second"},
                 last_surface(trial, "surface", 0.5), Relative{0.01});
    const std::vector<double>& y = trial.column("block.position.y");
    if (density == 500) {
        report.judge(
            {run + ": height of the centre at the end", "m", {}, 0.51, "the level rises by 10 mm; half a spacing"},
            mean_of(trial, "block.position.y", end - 0.5, end), Absolute{0.5 * spacing});
    } else if (density == 2000) {
        report.judge({run + ": height of the centre at the end", "m", {}, 0.05, "on the bottom; half a spacing"},
                     y.back(), Absolute{0.5 * spacing});
    } else {
        double highest = 0;
        for (std::size_t i = 0; i < y.size(); ++i) {
            highest = trial.time()[i] > 1 ? std::max(highest, y[i]) : highest;
        }
        report.judge(
            {run + ": highest centre after 1 s", "m", {}, {}, "the thesis' block comes back to the surface at 1.2 s"},
            highest, 0, depth + 0.01 - 0.05);
        report.judge({run + ": mean vertical load of the water over the weight, last second", "-", {}, 1.0, {}},
                     mean_of(trial, "block.fluid_force.y", end - 1, end) / weight, Relative{0.01});
    }
}

struct BlockRun {
    BlockEntry entry;
    std::string_view fluid, solid;
    double end;
};

std::string name_of(const BlockRun& run) {
    return fmt::format("{:g}, {}, {}", run.entry.density, run.fluid,
                       run.solid == "sphere_dem" ? "spheres" : "polyhedron");
}

/// Sums of the source, as those of the floes.
const std::vector<std::string> published{"fluid.weight=\"reciprocal\"", "fluid.wall_pressure=\"mirrored\""};

std::vector<std::string> overrides_of(const BlockRun& run, double spacing) {
    std::vector<std::string> all{fmt::format("body.block.density={}", run.entry.density),
                                 fmt::format("fluid.method=\"{}\"", run.fluid),
                                 fmt::format("solid.method=\"{}\"", run.solid),
                                 fmt::format("fluid.spacing={}", spacing), fmt::format("end={}", run.end)};
    if (run.fluid != "sph") {
        all.insert(all.end(), published.begin(), published.end());
    }
    return all;
}

/// Mean lift of the block held 0.25 m under the surface over the weight of its water [-].
double held_lift(const CaseSetting& setting, double spacing, const std::string& loads) {
    std::vector<std::string> held{"body.block.fixed=true", "body.block.position=[0.25,0.25]", "end=1.0",
                                  fmt::format("fluid.spacing={}", spacing),
                                  fmt::format("fluid.wall_loads=\"{}\"", loads)};
    held.insert(held.end(), published.begin(), published.end());
    WaterTrial trial(setting, held);
    trial.run();
    return mean_of(trial, "block.fluid_force.y", 0.5, 1) / (0.01 * 1000 * gravity);
}

void judge_buoyancy(CaseReport& report, const CaseSetting& setting, double spacing, const std::string& which) {
    report.judge(
        {"lift of the held block over the weight of its water" + which, "-", {}, 1.0, "mean of the second half of 1 s"},
        held_lift(setting, spacing, "pair_sum"), Relative{0.01});
}

/// The load of the source, -p A n of the outermost layer [Mellado2021, eq. 5.45].
void judge_pressure_area(CaseReport& report, const CaseSetting& setting, double spacing) {
    report.judge(
        {"the same from pressure times area, the source's load", "-", {}, 1.0, "mean of the second half of 1 s"},
        held_lift(setting, spacing, "pressure_area"), Relative{0.05});
}

/// The heavy block at twice the spacing of the other runs. At half of it the smaller spheres are pressed to more than
/// half their radius into the floor, at 0.64 s, and the run ends.
void judge_convergence(CaseReport& report, const CaseSetting& setting, BlockRun run, double spacing, double mean) {
    run.end = 1.3;
    WaterTrial trial(setting, overrides_of(run, 2 * spacing));
    trial.run();
    const double coarse = mean_of(trial, "block.position.y", 0, 1.3);
    report.judge_below({"2000: mean height over 1.3 s at twice the spacing, less this one",
                        "m",
                        {},
                        0.0,
                        "as wide as Robb's less Lee's"},
                       coarse - mean, 0.0152);
}

/// The other reading of "0.1 m above the water": that of the centre.
void state_lower_release(CaseReport& report, const CaseSetting& setting, double spacing) {
    for (const BlockEntry& entry : block_entries) {
        std::vector<std::string> changes = overrides_of({entry, "wcmps", "sphere_dem", 1.3}, spacing);
        changes.emplace_back("body.block.position=[0.25,0.6]");
        WaterTrial trial(setting, changes);
        trial.run();
        report.state(
            {fmt::format("{:g}, let go with its centre 0.1 m above: mean height over 1.3 s", entry.density), "m", ""},
            mean_of(trial, "block.position.y", 0, 1.3));
    }
}

}  // namespace

void block_entry(const CaseSetting& setting, CaseReport& report) {
    const double spacing = setting.is_full ? 0.0025 : 0.0125;
    std::vector<BlockRun> runs;
    for (const BlockEntry& entry : block_entries) {
        runs.push_back({entry, "wcmps", "sphere_dem", entry.density == 1000 ? 3.0 : 2.0});
    }
    runs.push_back({block_entries[1], "sph", "distance_potential_dem", 3.0});
    runs.push_back({block_entries[1], "mps", "distance_potential_dem", 3.0});
    Plot plot{"A block falls into water", "", {"time [s]", false}, {"height of the centre [m]", false}, {}, false};
    double fine = 0;
    for (const BlockRun& run : runs) {
        WaterTrial trial(setting, overrides_of(run, spacing));
        trial.record("surface", [last = run.end - 0.5](const WaterTrial& now) {
            return now.now() < last ? std::nan("") : mean_surface(now, {}, {0.5, 1.0, 0});
        });
        trial.run();
        const std::string name = name_of(run);
        judge_means(report, trial, run.entry, name);
        if (run.end >= 2) {
            judge_end(report, trial, run.entry.density, name, spacing);
        }
        judge_books(report, trial, name);
        fine = run.entry.density == 2000 ? mean_of(trial, "block.position.y", 0, 1.3) : fine;
        plot.curves.push_back({name, trial.time(), trial.column("block.position.y"), CurveStyle::line, -1});
    }
    judge_convergence(report, setting, runs[2], spacing, fine);
    state_lower_release(report, setting, spacing);
    judge_buoyancy(report, setting, spacing, "");
    judge_pressure_area(report, setting, spacing);
    if (!setting.is_full) {
        judge_buoyancy(report, setting, 0.5 * spacing, ", at half the spacing");
    }
    write_plot(setting, "block_entry", plot);
}

namespace {

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
