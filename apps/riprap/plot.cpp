// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "commands.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/io/csv_reader.hpp"
#include "riprap/scene/text/suggest.hpp"
#include "riprap/validation/plot_svg.hpp"
#include "riprap/view/bad_request.hpp"
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

std::array<const io::CsvTable*, 2> tables_of(const view::RecordedRun& run) { return {&run.probes, &run.ledger}; }

/// What a user may have meant, or all that there is.
std::string remedy(const view::RecordedRun& run, const std::string& wanted) {
    std::vector<std::string> names;
    std::string list;
    for (const io::CsvTable* table : tables_of(run)) {
        for (std::size_t k = 1; k < table->columns.size(); ++k) {
            const std::string& name = table->columns[k].name;
            names.push_back(name);
            names.push_back(name.substr(0, name.rfind('.')));
            list += fmt::format("\n  {} [{}]", name, table->columns[k].unit);
        }
    }
    const std::string meant = scene::nearest(wanted, names);
    return meant.empty() ? "it has:" + list : fmt::format("did you mean '{}'?", meant);
}

/// The columns named. @throws BadRequest where there is no such column
std::vector<Source> choose(const view::RecordedRun& run, const std::vector<std::string>& wanted) {
    std::vector<Source> chosen;
    for (const std::string& name : wanted) {
        const std::size_t before = chosen.size();
        for (const io::CsvTable* table : tables_of(run)) {
            for (std::size_t k = 1; k < table->columns.size(); ++k) {
                const std::string& heading = table->columns[k].name;
                if (heading == name || heading.starts_with(name + '.')) {
                    chosen.push_back({table, k});
                }
            }
        }
        if (chosen.size() == before) {
            throw view::BadRequest(fmt::format("the run has no column '{}'; {}", name, remedy(run, name)));
        }
    }
    return chosen;
}

/// Without a wish: the gauges and bodies that share the unit of the first of them; in a run without any, its energies.
std::vector<Source> usual(const view::RecordedRun& run) {
    std::vector<Source> chosen;
    const auto add = [&chosen](const io::CsvTable& table, const auto& is_wanted) {
        for (std::size_t k = 1; k < table.columns.size(); ++k) {
            const Source source{&table, k};
            if (has_values(source) && is_wanted(source.heading().unit)) {
                chosen.push_back(source);
            }
        }
    };
    add(run.probes, [&](const std::string& unit) { return chosen.empty() || chosen.front().heading().unit == unit; });
    if (chosen.empty()) {
        add(run.ledger, [](const std::string& unit) { return unit == "J" || unit == "J/m"; });
    }
    if (chosen.empty() && run.probes.row_count() + run.ledger.row_count() == 0) {
        throw FileError("there is nothing to plot: neither probes.csv nor ledger.csv has a row that can be read");
    }
    if (chosen.empty()) {
        throw FileError(
            "no gauge, body or energy that can be read is ever anything but zero; --column names what to plot");
    }
    return chosen;
}

/// `is_change` draws what has changed since the first row: a large constant would flatten everything else.
validation::Plot plot_of(const view::RecordedRun& run, const std::vector<Source>& sources, bool is_change) {
    validation::Plot plot;
    plot.title = run.title;
    plot.subtitle = run.status;
    plot.x.label = "time [s]";
    plot.y.label = fmt::format("{}{}[{}]", sources.size() == 1 ? sources.front().heading().name + ' ' : "",
                               is_change ? "change since the start " : "", sources.front().heading().unit);
    for (const Source& source : sources) {
        const std::string& unit = source.heading().unit;
        if (unit != sources.front().heading().unit) {
            throw view::BadRequest(fmt::format("'{}' is in {} and '{}' in {}: one plot has one unit",
                                               sources.front().heading().name, sources.front().heading().unit,
                                               source.heading().name, unit));
        }
        validation::Curve curve;
        curve.label = source.heading().name;
        const std::vector<double>& values = source.table->values[source.column];
        const double start = is_change && !values.empty() ? values.front() : 0;
        const std::size_t stride = source.table->row_count() / plotted_rows + 1;
        for (std::size_t i = 0; i < source.table->row_count(); i += stride) {
            curve.x.push_back(source.table->values[0][i]);
            curve.y.push_back(values[i] - start);
        }
        constexpr std::array<validation::CurveStyle, 3> styles{
            validation::CurveStyle::line, validation::CurveStyle::dashed, validation::CurveStyle::markers};
        curve.style = styles[plot.curves.size() / validation::color_count % styles.size()];
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
    for (const std::string& notice : run.notices) {
        fmt::print(stderr, "riprap: {}\n", printable(notice));
    }
    const bool is_asked = !options.columns.empty();
    const std::vector<Source> sources = is_asked ? choose(run, options.columns) : usual(run);
    const bool is_change = !is_asked && sources.front().table == &run.ledger;
    const std::string svg = validation::to_svg(plot_of(run, sources, is_change));
    const std::filesystem::path out = options.out.empty() ? options.folder / "plot.svg" : options.out;
    io::write_file(out, out.extension() == ".png" ? png_of(svg) : svg);
    fmt::print("{}{}\n", out.string(),
               is_asked ? "" : "; --column NAME draws another column, more of them where it is repeated");
    return 0;
}

}  // namespace riprap
