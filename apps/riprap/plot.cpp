// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "commands.hpp"
#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/csv_reader.hpp"
#include "riprap/run/run_folder.hpp"
#include "riprap/validation/plot_svg.hpp"
#include "riprap/view/browser.hpp"
#include "riprap/view/recorded_run.hpp"

namespace riprap {

namespace {

constexpr std::size_t plotted_rows = 4000;  // more cannot be told apart on paper
constexpr int png_width = 960, png_height = 640;

/// A column of one of the tables of a run.
struct Source {
    const io::CsvTable* table;
    std::size_t column;
    const io::CsvColumn& heading() const { return table->columns[column]; }
};

bool has_values(const Source& source) {
    const std::vector<double>& values = source.table->values[source.column];
    return std::any_of(values.begin(), values.end(), [](double v) { return v != 0 && v == v; });
}

/// What a user may name.
std::string known_columns(const view::RecordedRun& run) {
    std::string list;
    for (const io::CsvTable* table : {&run.probes, &run.ledger}) {
        for (std::size_t k = 1; k < table->columns.size(); ++k) {
            list += fmt::format("\n  {} [{}]", table->columns[k].name, table->columns[k].unit);
        }
    }
    return list;
}

/// The columns that are asked for; without a wish the gauges and bodies that share the unit of the first of them.
std::vector<Source> choose(const view::RecordedRun& run, const std::vector<std::string>& wanted) {
    std::vector<Source> chosen;
    for (const std::string& name : wanted) {
        const std::size_t before = chosen.size();
        for (const io::CsvTable* table : {&run.probes, &run.ledger}) {
            for (std::size_t k = 1; k < table->columns.size(); ++k) {
                const std::string& heading = table->columns[k].name;
                if (heading == name || heading.starts_with(name + '.')) {
                    chosen.push_back({table, k});
                }
            }
        }
        if (chosen.size() == before) {
            throw FileError(fmt::format("the run has no column '{}'; it has:{}", name, known_columns(run)));
        }
    }
    for (const io::CsvTable* table : {&run.probes, &run.ledger}) {
        for (std::size_t k = 1; wanted.empty() && k < table->columns.size(); ++k) {
            const Source source{table, k};
            if (has_values(source) && (chosen.empty() || (chosen.front().table == table &&
                                                          chosen.front().heading().unit == source.heading().unit))) {
                chosen.push_back(source);
            }
        }
    }
    if (chosen.empty()) {
        throw FileError("the run has no column with anything but zeros in it");
    }
    return chosen;
}

validation::Plot plot_of(const view::RecordedRun& run, const std::vector<Source>& sources) {
    validation::Plot plot;
    plot.title = run.title;
    plot.subtitle = run.status;
    plot.x.label = "time [s]";
    plot.y.label = fmt::format("{} [{}]", sources.size() == 1 ? sources.front().heading().name : "",
                               sources.front().heading().unit);
    for (const Source& source : sources) {
        const std::string& unit = source.heading().unit;
        if (unit != sources.front().heading().unit) {
            throw FileError(fmt::format("'{}' is in {} and '{}' in {}: one plot has one unit",
                                        sources.front().heading().name, sources.front().heading().unit,
                                        source.heading().name, unit));
        }
        validation::Curve curve;
        curve.label = source.heading().name;
        const std::size_t stride = source.table->row_count() / plotted_rows + 1;
        for (std::size_t i = 0; i < source.table->row_count(); i += stride) {
            curve.x.push_back(source.table->values[0][i]);
            curve.y.push_back(source.table->values[source.column][i]);
        }
        plot.curves.push_back(std::move(curve));
    }
    return plot;
}

/// An SVG drawn by the browser that also draws the scenes.
std::string png_of(const std::string& svg) {
    const view::ScratchFolder scratch;
    const std::filesystem::path page = scratch.path() / "plot.html";
    io::write_file(
        page, "<!doctype html><html data-opened=\"1\"><style>*{margin:0}svg{width:100vw;height:100vh}</style>" + svg,
        io::Durability::later);
    view::Browser browser(view::find_browser(), png_width, png_height);
    browser.open(page);
    return browser.picture();
}

}  // namespace

int plot_run(const PlotOptions& options) {
    const view::RecordedRun run = view::read_run(options.folder);
    const std::string svg = validation::to_svg(plot_of(run, choose(run, options.columns)));
    const std::filesystem::path out = options.out.empty() ? options.folder / "plot.svg" : options.out;
    io::write_file(out, out.extension() == ".png" ? png_of(svg) : svg);
    fmt::print("{}\n", out.string());
    return 0;
}

}  // namespace riprap
