// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/ensemble/ensemble.hpp"

#include <fmt/format.h>

#include "commands.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/run/study/sweep_plan.hpp"
#include "riprap/view/plot_svg.hpp"
#include "riprap/view/sweep_page.hpp"
#include "slurm_options.hpp"

namespace riprap {

namespace {

constexpr std::size_t most_bands = 8;  // as many colours as a plot has

/// The bands that share the unit of the first one: the mean as a line, the limits dashed.
view::Plot plot_of(const run::Bands& bands) {
    view::Plot plot;
    plot.title = "Ensemble: mean, least and largest of the members";
    plot.x.label = "time [s]";
    int color = 0;
    for (const run::Band& band : bands.bands) {
        if (band.column.unit != bands.bands.front().column.unit || plot.curves.size() >= 3 * most_bands) {
            continue;
        }
        using view::CurveStyle;
        plot.curves.push_back({band.column.name, bands.time, band.mean, CurveStyle::line, color});
        plot.curves.push_back({"", bands.time, band.low, CurveStyle::dashed, color});
        plot.curves.push_back({"", bands.time, band.high, CurveStyle::dashed, color});
        ++color;
    }
    plot.y.label = fmt::format("[{}]", bands.bands.front().column.unit);
    return plot;
}

/// Draws the bands and writes the page of the members in a folder.
void show_ensemble(const std::filesystem::path& out, bool is_quiet) {
    std::vector<std::filesystem::path> folders;
    const std::vector<run::SweepPoint> members = run::read_plan(out).points;
    for (const run::SweepPoint& member : members) {
        folders.push_back(out / member.name);
    }
    const run::Bands bands = run::gather_bands(folders);
    if (!bands.bands.empty()) {
        view::write_svg(out / "bands.svg", plot_of(bands));
    }
    const std::filesystem::path page = view::write_ensemble_page(out);
    if (!is_quiet) {
        fmt::print("{} members, {} bands in {}, shown in {}\n", members.size(), bands.bands.size(),
                   printable((out / "bands.csv").string()), printable(page.string()));
    }
}

}  // namespace

int run_ensemble(const run::EnsembleOptions& options, const SlurmWords& slurm) {
    if (!slurm.submit.empty()) {
        if (!options.run.quiet) {
            tell_cost(options.run.case_path, options.run.overrides, "the case as it is",
                      static_cast<std::size_t>(options.members), options.run.threads, 0);
        }
        return hand_in(slurm, run::write_ensemble_scripts(options, slurm_of(slurm, options.jobs)));
    }
    const int code = run::run_ensemble(options);
    if (code <= static_cast<int>(ExitCode::signal_base)) {
        show_ensemble(options.run.out, options.run.quiet);
    }
    return code;
}

int gather_ensemble(const std::filesystem::path& out, bool is_quiet) {
    const int code = run::gather_ensemble(out, is_quiet);
    show_ensemble(out, is_quiet);
    return code;
}

}  // namespace riprap
