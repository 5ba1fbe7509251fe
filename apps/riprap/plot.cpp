// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "commands.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/io/csv_reader.hpp"
#include "riprap/scene/text/suggest.hpp"
#include "riprap/view/bad_request.hpp"
#include "riprap/view/figure.hpp"
#include "riprap/view/plot_svg.hpp"
#include "riprap/view/read_run.hpp"

namespace riprap {

namespace {

constexpr std::size_t plotted_rows = 4000;  // more cannot be told apart on paper

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

/// Returns names that a user may have meant, or all that there are.
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

/// The column of that name, or the components of a vector.
std::vector<Source> columns_of(const view::RecordedRun& run, const std::string& name) {
    std::vector<Source> found;
    for (const io::CsvTable* table : tables_of(run)) {
        for (std::size_t k = 1; k < table->columns.size(); ++k) {
            const std::string& heading = table->columns[k].name;
            if (heading == name || heading.starts_with(name + '.')) {
                found.push_back({table, k});
            }
        }
    }
    return found;
}

/// The columns named; of a vector the components that are ever anything but zero, such as two in a planar scene.
/// @throws BadRequest where there is no such column
std::vector<Source> choose(const view::RecordedRun& run, const std::vector<std::string>& wanted) {
    std::vector<Source> chosen;
    for (const std::string& name : wanted) {
        std::vector<Source> found = columns_of(run, name);
        if (found.empty()) {
            throw view::BadRequest(fmt::format("the run has no column '{}'; {}", name, remedy(run, name)));
        }
        if (std::any_of(found.begin(), found.end(), has_values)) {
            std::erase_if(found, [](const Source& source) { return !has_values(source); });
        }
        chosen.insert(chosen.end(), found.begin(), found.end());
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

/// Columns of one unit each, in the order in which the units first appear.
std::vector<std::vector<Source>> by_unit(const std::vector<Source>& sources) {
    std::vector<std::vector<Source>> panels;
    for (const Source& source : sources) {
        const auto same = std::find_if(panels.begin(), panels.end(), [&source](const std::vector<Source>& panel) {
            return panel.front().heading().unit == source.heading().unit;
        });
        if (same == panels.end()) {
            panels.push_back({source});
        } else {
            same->push_back(source);
        }
    }
    return panels;
}

/// Plots below each other as one.
std::string stacked(const std::vector<std::string>& panels) {
    if (panels.size() == 1) {
        return panels.front();
    }
    double width = 0, height = 0;
    std::string inside;
    for (std::string panel : panels) {
        width = std::max(width, view::svg_number(panel, "width"));
        const double own = view::svg_number(panel, "height");
        panel.erase(0, panel.find("<svg"));
        inside += panel.insert(4, fmt::format(" y='{}'", height));
        height += own;
    }
    return fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' width='{0}' height='{1}' viewBox='0 0 {0} {1}'>\n{2}</svg>\n", width,
        height, inside);
}

/// `is_change` draws what has changed since the first row: a large constant would flatten everything else.
view::Plot plot_of(const view::RecordedRun& run, const std::vector<Source>& sources, bool is_change) {
    view::Plot plot;
    plot.title = run.title;
    plot.subtitle = run.status;
    plot.x.label = "time [s]";
    plot.y.label = fmt::format("{}{}[{}]", sources.size() == 1 ? sources.front().heading().name + ' ' : "",
                               is_change ? "change since the start " : "", sources.front().heading().unit);
    for (const Source& source : sources) {
        view::Curve curve;
        curve.label = source.heading().name;
        const std::vector<double>& values = source.table->values[source.column];
        const double start = is_change && !values.empty() ? values.front() : 0;
        const std::size_t stride = source.table->row_count() / plotted_rows + 1;
        for (std::size_t i = 0; i < source.table->row_count(); i += stride) {
            curve.x.push_back(source.table->values[0][i]);
            curve.y.push_back(values[i] - start);
        }
        constexpr std::array<view::CurveStyle, 3> styles{view::CurveStyle::line, view::CurveStyle::dashed,
                                                         view::CurveStyle::markers};
        curve.style = styles[plot.curves.size() / view::color_count % styles.size()];
        plot.curves.push_back(std::move(curve));
    }
    return plot;
}

/// The chart as the user wants it: size, words. @throws BadRequest where one word would stand for several
view::Plot as_asked(view::Plot plot, const PlotOptions& options, std::size_t count) {
    constexpr double inch = 25.4;  // [mm]
    if (!options.y_label.empty() && count > 1) {
        throw view::BadRequest(fmt::format(
            "--y-label names one axis, and columns of {} units have one each; plot those of one unit", count));
    }
    const auto take = [](std::string& word, const std::string& asked) { word = asked.empty() ? word : asked; };
    plot.subtitle = options.title.empty() ? plot.subtitle : "";
    take(plot.title, options.title);
    take(plot.x.label, options.x_label);
    take(plot.y.label, options.y_label);
    if (options.width > 0) {
        plot.width = std::round(options.width / inch * view::svg_dpi);
        plot.height = std::round(options.height / inch * view::svg_dpi);
    }
    return plot;
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
    std::vector<std::string> panels;
    const std::vector<std::vector<Source>> groups = by_unit(sources);
    for (const std::vector<Source>& group : groups) {
        panels.push_back(view::to_svg(as_asked(plot_of(run, group, is_change), options, groups.size())));
    }
    const std::string svg = stacked(panels);
    const std::filesystem::path out = options.out.empty() ? options.folder / "plot.svg" : options.out;
    view::write_figure(out, svg, options.dpi);
    fmt::print("{}{}\n", out.string(),
               is_asked ? "" : "; --column NAME draws another column, more of them where it is repeated");
    return 0;
}

}  // namespace riprap
