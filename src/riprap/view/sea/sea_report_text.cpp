// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "riprap/io/atomic_file.hpp"
#include "riprap/io/csv.hpp"
#include "riprap/view/plot_svg.hpp"
#include "riprap/view/sea/sea_report.hpp"

namespace riprap::view {

namespace {

using Json = nlohmann::ordered_json;

std::string shown(double value) { return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-"; }

/// A number, or null where there is none.
Json json_of(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// "0.031 to 0.035", or nothing without a band.
std::string band_text(double low, double high) {
    return std::isfinite(low) ? fmt::format("{:.4g} to {:.4g}", low, high) : "";
}

std::string formula_text(const SeaReport& report) {
    std::string text;
    for (const FormulaRow& row : report.formulas) {
        text += text.empty() ? "formulas, and the band of nine in ten of their tests\n" : "";
        text += fmt::format("{}: {} = {} {}{}{} [{}], {}{}\n", row.name, row.quantity, shown(row.predicted.value),
                            row.unit == "-" ? "" : row.unit,
                            row.has_band ? fmt::format(" ({})", band_text(row.predicted.low, row.predicted.high)) : "",
                            std::isfinite(row.found) ? fmt::format("; the run {}", shown(row.found)) : "", row.source,
                            row.range, row.is_in_range ? "" : ": OUTSIDE OF ITS RANGE here");
    }
    return text;
}

}  // namespace

std::string sea_text(const SeaReport& report) {
    std::size_t width = 6;
    for (const SeaNumber& one : report.numbers) {
        width = std::max(width, one.name.size());
    }
    std::string text =
        fmt::format("sea from {:.6g} to {:.6g} s{}, bands of 90 % by {} part{}\n", report.from, report.to,
                    report.runs > 1 ? fmt::format(" of {} runs", report.runs) : "",
                    report.runs * static_cast<std::size_t>(report.parts), report.runs * report.parts > 1 ? "s" : "");
    text += fmt::format("{:<{}} {:>10} {:<6} {:<20} {}\n", "number", width, "value", "unit", "band", "");
    for (const SeaNumber& one : report.numbers) {
        std::string line = fmt::format("{:<{}} {:>10} {:<6} {:<20} {}", one.name, width, shown(one.value), one.unit,
                                       band_text(one.low, one.high), one.note);
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    if (!report.reflection.is_empty()) {
        text += fmt::format(
            "between {:.3g} and {:.3g} Hz; {:.2g} % of the energy is noise, {:.2g} % in frequencies that "
            "are left out\n",
            report.reflection.low, report.reflection.high, 100 * report.reflection.noise,
            100 * report.reflection.blind_share);
    }
    text += formula_text(report);
    for (const std::string& notice : report.notices) {
        text += notice + '\n';
    }
    return text;
}

std::string sea_json(const SeaReport& report) {
    Json json{{"from", report.from}, {"to", report.to}, {"runs", report.runs}, {"parts", report.parts}};
    json["numbers"] = Json::array();
    for (const SeaNumber& one : report.numbers) {
        json["numbers"].push_back({{"name", one.name},
                                   {"unit", one.unit},
                                   {"value", json_of(one.value)},
                                   {"low", json_of(one.low)},
                                   {"high", json_of(one.high)},
                                   {"note", one.note}});
    }
    const wave::SeaReflection& found = report.reflection;
    json["spectrum"] = {{"frequency", found.frequency}, {"incident", found.incident}, {"reflected", found.reflected}};
    json["left_out"] = Json::array();
    for (const wave::BlindBand& band : found.blind) {
        json["left_out"].push_back({{"low", band.low}, {"high", band.high}, {"share", band.share}});
    }
    json["volumes"] = Json::array();
    for (const GaugeVolumes& gauge : report.volumes) {
        Json waves = Json::array();
        for (const wave::OvertoppingWave& wave : gauge.volumes.waves) {
            waves.push_back({{"begin", wave.begin}, {"volume", wave.volume}});
        }
        json["volumes"].push_back({{"gauge", gauge.name},
                                   {"run", gauge.run + 1},
                                   {"total", gauge.volumes.total},
                                   {"rest", gauge.volumes.rest},
                                   {"waves", waves}});
    }
    json["formulas"] = Json::array();
    for (const FormulaRow& row : report.formulas) {
        json["formulas"].push_back({{"name", row.name},
                                    {"quantity", row.quantity},
                                    {"unit", row.unit},
                                    {"value", json_of(row.predicted.value)},
                                    {"low", row.has_band ? json_of(row.predicted.low) : Json(nullptr)},
                                    {"high", row.has_band ? json_of(row.predicted.high) : Json(nullptr)},
                                    {"run", json_of(row.found)},
                                    {"source", row.source},
                                    {"is_in_range", row.is_in_range}});
    }
    json["notices"] = report.notices;
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

namespace {

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' ? "\"\"" : std::string(1, c);
    }
    return result + '"';
}

std::string numbers_csv(const SeaReport& report) {
    std::string text = "name,unit,value,low,high,note\n";
    for (const SeaNumber& one : report.numbers) {
        const std::vector<double> row{one.value, one.low, one.high};
        text += fmt::format("{},{},{},{}\n", quoted(one.name), one.unit, io::csv_row(row), quoted(one.note));
    }
    return text;
}

std::string spectrum_csv(const SeaReport& report) {
    const std::vector<io::CsvColumn> columns{
        {"frequency", "1/s"}, {"incident", "m^2 s"}, {"reflected", "m^2 s"}, {"K_r", "-"}};
    std::string text = io::csv_heading(columns) + '\n';
    for (std::size_t i = 0; i < report.reflection.frequency.size(); ++i) {
        const std::vector<double> row{report.reflection.frequency[i], report.reflection.incident[i],
                                      report.reflection.reflected[i], report.reflected_share[i]};
        text += io::csv_row(row) + '\n';
    }
    return text;
}

std::string volumes_csv(const SeaReport& report) {
    std::string text = "gauge,run,begin [s],volume [m^3/m]\n";
    for (const GaugeVolumes& gauge : report.volumes) {
        for (const wave::OvertoppingWave& wave : gauge.volumes.waves) {
            const std::vector<double> row{static_cast<double>(gauge.run + 1), wave.begin, wave.volume};
            text += fmt::format("{},{}\n", quoted(gauge.name), io::csv_row(row));
        }
    }
    return text;
}

Plot plot_of(const SeaReport& report) {
    Plot plot;
    plot.title = "Incident and reflected sea";
    plot.subtitle =
        fmt::format("K_r = {:.3g}, incident H_m0 = {:.4g} m, {:.6g} to {:.6g} s", report.reflection.coefficient,
                    report.reflection.incident_height, report.from, report.to);
    plot.x.label = "frequency [Hz]";
    plot.y.label = "spectral density [m^2 s]";
    plot.curves.push_back({"incident", report.reflection.frequency, report.reflection.incident, CurveStyle::line, 0});
    plot.curves.push_back(
        {"reflected", report.reflection.frequency, report.reflection.reflected, CurveStyle::dashed, 1});
    return plot;
}

}  // namespace

std::vector<std::filesystem::path> write_sea(const std::filesystem::path& folder, const SeaReport& report) {
    io::make_folder(folder);
    std::vector<std::filesystem::path> files{folder / "sea.csv"};
    io::write_file(files.back(), numbers_csv(report));
    if (!report.reflection.is_empty()) {
        files.push_back(folder / "sea_spectrum.csv");
        io::write_file(files.back(), spectrum_csv(report));
        files.push_back(folder / "sea.svg");
        write_svg(files.back(), plot_of(report));
    }
    if (!report.volumes.empty()) {
        files.push_back(folder / "sea_volumes.csv");
        io::write_file(files.back(), volumes_csv(report));
    }
    return files;
}

}  // namespace riprap::view
