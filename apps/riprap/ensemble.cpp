// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/ensemble.hpp"

#include <fmt/format.h>

#include "commands.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/view/plot_svg.hpp"
#include "riprap/view/sweep_page.hpp"

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

}  // namespace

int run_ensemble(const run::EnsembleOptions& options) {
    const int code = run::run_ensemble(options);
    if (code > static_cast<int>(ExitCode::signal_base)) {
        return code;
    }
    std::vector<std::filesystem::path> folders;
    for (std::int64_t k = 1; k <= options.members; ++k) {
        folders.push_back(options.run.out / fmt::format("member-{}", k));
    }
    const run::Bands bands = run::gather_bands(folders);
    if (!bands.bands.empty()) {
        view::write_svg(options.run.out / "bands.svg", plot_of(bands));
    }
    const std::filesystem::path page = view::write_ensemble_page(options.run.out);
    if (!options.run.quiet) {
        fmt::print("{} members, {} bands in {}, shown in {}\n", options.members, bands.bands.size(),
                   printable((options.run.out / "bands.csv").string()), printable(page.string()));
    }
    return code;
}

}  // namespace riprap
