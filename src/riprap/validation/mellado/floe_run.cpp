// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/mellado/floe_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "riprap/validation/mellado/mean_surface.hpp"

namespace riprap::validation::mellado {

namespace {

using water::WaterTrial;

constexpr double length_up = 0.15, length = 0.7, width = 0.15;  ///< of the tank [m]

/// Depth below the dam in whole spacings: at a coarse spacing the bed of 1 cm is one layer of 1.25 cm.
double filled(double depth, double spacing) {
    return depth == 0 ? 0 : spacing * std::max(1.0, std::round(depth / spacing));
}

/// Support and weight of a method: both MPS take those of the article, with walls that go with them.
std::vector<std::string> sums_of(std::string_view fluid) {
    return fluid == "sph" ? std::vector<std::string>{}
                          : std::vector<std::string>{"fluid.smoothing_ratio=1.05", "fluid.weight=\"reciprocal\"",
                                                     "fluid.wall_pressure=\"mirrored\""};
}

std::vector<std::string> overrides_of(const FloeRun& run, double spacing) {
    const double gate = std::max(2 * spacing, 0.005);
    std::vector<std::string> all{fmt::format("fluid.spacing={}", spacing),
                                 fmt::format("end={}", run.end),
                                 fmt::format("fluid.method=\"{}\"", run.fluid),
                                 fmt::format("solid.method=\"{}\"", run.solid),
                                 fmt::format("body.gate.shape.box=[{},0.15,0.3]", gate),
                                 fmt::format("body.gate.position=[{},0.075,0.15]", length_up + 0.5 * gate)};
    // Over a dry bed the second region is the right half of the reservoir.
    const bool is_dry = run.depth == 0;
    all.push_back(fmt::format("fluid.region.0.box.high=[{},0.15,0.15]", is_dry ? 0.075 : 0.15));
    all.push_back(fmt::format("fluid.region.1.box.low=[{},0,0]", is_dry ? 0.075 : length_up + gate));
    all.push_back(is_dry ? "fluid.region.1.box.high=[0.15,0.15,0.15]"
                         : fmt::format("fluid.region.1.box.high=[0.7,0.15,{}]", filled(run.depth, spacing)));
    const std::vector<std::string> sums = sums_of(run.fluid);
    all.insert(all.end(), sums.begin(), sums.end());
    all.insert(all.end(), run.more.begin(), run.more.end());
    return all;
}

/// The highest that water stands within a spacing of the downstream wall; 0 where there is none [m].
double level_at_wall(const WaterTrial& trial, double near) {
    double level = 0;
    for (const Vec3& x : trial.state().fluid.position) {
        level = x.x > length - near ? std::max(level, x.z) : level;
    }
    return level;
}

/// Height above which a hundredth of the water stands: how high it splashes and runs up, but for single drops [m].
double splash_height(const WaterTrial& trial) {
    std::vector<double> heights;
    heights.reserve(trial.state().fluid.position.size());
    for (const Vec3& x : trial.state().fluid.position) {
        heights.push_back(x.z);
    }
    const auto top = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() * 99 / 100);
    std::nth_element(heights.begin(), top, heights.end());
    return top == heights.end() ? std::nan("") : *top;
}

/// Mass of the bodies that float [kg].
double floating_mass(const WaterTrial& trial) {
    const body::BodySet& bodies = trial.model().bodies;
    double mass = 0;
    for (std::size_t b = 0; b < bodies.drive.size(); ++b) {
        mass += bodies.drive[b] == body::Drive::free ? bodies.mass[b] : 0;
    }
    return mass;
}

/// First row at which water stands at the downstream wall, 1.5 spacings above the bed's own level [s].
double arrival_of(const WaterTrial& trial, double level) {
    const std::vector<double>& at_wall = trial.column("level_at_wall");
    const auto first = std::ranges::find_if(at_wall, [level](double z) { return z > level; });
    return first == at_wall.end() ? std::nan("") : trial.time()[static_cast<std::size_t>(first - at_wall.begin())];
}

CaseSetting in_folder(const CaseSetting& setting, const std::string& name) {
    CaseSetting other = setting;
    other.folder = setting.folder.parent_path() / name;
    return other;
}

}  // namespace

double floe_spacing(const CaseSetting& setting) { return setting.is_full ? 0.00326087 : 0.0125; }

std::size_t FloeOutcome::row_of_farthest(const std::string& block, double until) const {
    const std::vector<double>& x = trial->column(block + ".position.x");
    std::size_t row = 0;
    for (std::size_t i = 0; i < x.size() && trial->time()[i] <= until; ++i) {
        row = x[i] > x[row] ? i : row;
    }
    return row;
}

double FloeOutcome::farthest(const std::string& block) const {
    return trial->column(block + ".position.x")[row_of_farthest(block)];
}

double FloeOutcome::mean_height(std::span<const std::string> blocks, double start) const {
    double height = 0;
    for (const std::string& block : blocks) {
        height += trial->mean(block + ".position.z", start, trial->now()) / static_cast<double>(blocks.size());
    }
    return height;
}

double FloeOutcome::late_splash() const {
    const std::vector<double>& heights = trial->column("splash_height");
    double highest = 0;
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const bool is_late = trial->time()[i] >= late && trial->time()[i] <= late_end;
        highest = is_late ? std::max(highest, heights[i]) : highest;
    }
    return highest;
}

FloeOutcome run_floes(const CaseSetting& setting, const std::string& folder, const FloeRun& run) {
    const double spacing = floe_spacing(setting);
    FloeOutcome outcome;
    WaterTrial& trial = outcome.trial.emplace(in_folder(setting, folder), overrides_of(run, spacing));
    trial.record("level_at_wall", [spacing](const WaterTrial& now) { return level_at_wall(now, spacing); });
    trial.record("splash_height", splash_height);
    const double last = run.end - 0.5;
    trial.record("surface", [last](const WaterTrial& now) {
        return now.now() < last ? std::nan("") : mean_surface(now, {}, {length, width, 0.3});
    });
    if (setting.is_full && !setting.results.empty()) {
        trial.keep_in(setting.results / fmt::format("{}-{:016x}.trial", folder, trial.model().case_hash));
    }
    trial.run();
    outcome.level = last_surface(trial, "surface", 0.5);
    const double mass = trial.report().ledger.fluid.mass + floating_mass(trial);
    outcome.expected_level = mass / 1000 / (length * width);
    outcome.level_behind_gate = mass / 1000 / (length_up * width);
    outcome.arrival = arrival_of(trial, run.depth > 0 ? filled(run.depth, spacing) + 1.5 * spacing : 0);
    return outcome;
}

}  // namespace riprap::validation::mellado
