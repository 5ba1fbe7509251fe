// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "riprap/view/wave_report.hpp"

namespace riprap::view {

namespace {

std::string number(double value) { return std::isnan(value) ? "-" : fmt::format("{:.4g}", value); }

/// A number, or null where there is none.
nlohmann::ordered_json json_of(double value) { return std::isfinite(value) ? nlohmann::ordered_json(value) : nullptr; }

std::string reflection_text(const WaveReport& report) {
    if (!report.reflection) {
        return fmt::format("no reflection: {}\n", report.why_no_reflection);
    }
    const Reflection& found = *report.reflection;
    const std::size_t count = found.gauges.size();
    return fmt::format(
        "reflection over {} gauges, {:.0f} periods of {:.4g} s, {:.4g} m long waves in {:.4g} m of water: incident H "
        "{:.4g} m, reflected H {:.4g} m, K_r = {:.3g}{}\n",
        count, (report.to - report.whole_from) / *report.period, *report.period, found.length, found.depth,
        2 * found.parts.incident, 2 * found.parts.reflected, found.parts.reflection,
        count > 2 ? fmt::format("; the two leave {:.2g} % of the incident wave", 100 * found.parts.misfit) : "");
}

/// Heights by the share of waves that exceed them, where there are waves enough for a tenth.
std::string exceedance_text(const WaveReport& report, std::size_t width) {
    std::string text;
    constexpr std::size_t least = 3;
    for (const GaugeWaves& gauge : report.gauges) {
        if (gauge.exceeded.size() < least) {
            continue;
        }
        text += text.empty() ? "height [m] exceeded by a share of the waves\n" : "";
        text += fmt::format("{:<{}}", gauge.name, width);
        for (const wave::Exceedance& one : gauge.exceeded) {
            text += fmt::format("  {:g} %: {:.4g}", 100 * one.share, one.height);
        }
        text += '\n';
    }
    return text;
}

/// Shares with the heights that they exceed.
nlohmann::ordered_json json_of(const std::vector<wave::Exceedance>& exceeded) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const wave::Exceedance& one : exceeded) {
        rows.push_back({{"share", one.share}, {"height", one.height}});
    }
    return rows;
}

}  // namespace

std::string wave_text(const WaveReport& report) {
    std::size_t width = 5;
    for (const GaugeWaves& gauge : report.gauges) {
        width = std::max(width, gauge.name.size());
    }
    std::string text = fmt::format("waves from {:.6g} to {:.6g} s", report.from, report.to);
    text += fmt::format("\n{:<{}} {:>9} {:>9} {:>5} {:>9} {:>9} {:>9} {:>8} {:>8} {:>9} {:>8}{}\n", "gauge", width,
                        "at [m]", "mean [m]", "waves", "H_m [m]", "H_1/3", "H_max", "T_m [s]", "T_1/3", "H_m0 [m]",
                        "T_p [s]", report.period ? fmt::format(" {:>9}", "H_T [m]") : "");
    for (const GaugeWaves& gauge : report.gauges) {
        const wave::WaveStatistics& w = gauge.waves;
        text += fmt::format("{:<{}} {:>9} {:>9} {:>5} {:>9} {:>9} {:>9} {:>8} {:>8} {:>9} {:>8}{}\n", gauge.name, width,
                            number(gauge.place), number(w.mean_level), w.count, number(w.mean_height),
                            number(w.significant_height), number(w.highest), number(w.mean_period),
                            number(w.significant_period), number(w.spectral_height), number(gauge.peak_period),
                            report.period ? fmt::format(" {:>9}", number(2 * std::abs(gauge.amplitude))) : "");
    }
    const bool has_waves = std::any_of(report.gauges.begin(), report.gauges.end(),
                                       [](const GaugeWaves& gauge) { return gauge.waves.count > 0; });
    for (const GaugeWaves& gauge : report.gauges) {
        if (!has_waves) {  // a single wave has no two up-crossings
            text += fmt::format("{}: highest {:.4g} m above its start, at {:.4g} s\n", gauge.name, gauge.rise,
                                gauge.rise_time);
        }
    }
    text += exceedance_text(report, width);
    for (const GaugeFlow& flow : report.flows) {
        const wave::Overtopping& over = flow.over;
        text += fmt::format("{}: {:.4g} {} went through, {:.4g} {} on average, in {} event{}", flow.name, over.volume,
                            report.is_planar ? "m^3/m" : "m^3", over.mean, report.is_planar ? "m^3/s/m" : "m^3/s",
                            over.events, over.events == 1 ? "" : "s");
        text += over.events > 0 ? fmt::format(", {:.4g} in the largest, from {:.4g} s\n", over.largest, over.at) : "\n";
    }
    for (const std::string& notice : report.notices) {
        text += notice + '\n';
    }
    return text + reflection_text(report);
}

std::string wave_json(const WaveReport& report) {
    nlohmann::ordered_json json{{"from", report.from}, {"to", report.to}};
    json["period"] = report.period ? json_of(*report.period) : nullptr;
    json["gauges"] = nlohmann::ordered_json::array();
    for (const GaugeWaves& gauge : report.gauges) {
        const wave::WaveStatistics& w = gauge.waves;
        json["gauges"].push_back(
            {{"name", gauge.name},
             {"place", gauge.place},
             {"mean_level", json_of(w.mean_level)},
             {"rows_missing", gauge.missing},
             {"waves", w.count},
             {"mean_height", json_of(w.mean_height)},
             {"significant_height", json_of(w.significant_height)},
             {"highest", json_of(w.highest)},
             {"mean_period", json_of(w.mean_period)},
             {"significant_period", json_of(w.significant_period)},
             {"spectral_height", json_of(w.spectral_height)},
             {"peak_period", json_of(gauge.peak_period)},
             {"exceeded", json_of(gauge.exceeded)},
             {"rise", json_of(gauge.rise)},
             {"rise_time", json_of(gauge.rise_time)},
             {"height_at_period", report.period ? json_of(2 * std::abs(gauge.amplitude)) : nullptr}});
    }
    json["flows"] = nlohmann::ordered_json::array();
    for (const GaugeFlow& flow : report.flows) {
        json["flows"].push_back({{"name", flow.name},
                                 {"volume", flow.over.volume},
                                 {"mean", flow.over.mean},
                                 {"events", flow.over.events},
                                 {"largest", flow.over.largest},
                                 {"largest_at", flow.over.at}});
    }
    if (report.reflection) {
        const Reflection& found = *report.reflection;
        json["reflection"] = {{"gauges", found.gauges},
                              {"from", report.whole_from},
                              {"length", found.length},
                              {"depth", found.depth},
                              {"incident_height", 2 * found.parts.incident},
                              {"reflected_height", 2 * found.parts.reflected},
                              {"coefficient", json_of(found.parts.reflection)},
                              {"misfit", json_of(found.parts.misfit)}};
    } else {
        json["reflection"] = nullptr;
        json["why_no_reflection"] = report.why_no_reflection;
    }
    json["notices"] = report.notices;
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace riprap::view
