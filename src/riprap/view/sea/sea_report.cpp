// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/sea/sea_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/scene/text/suggest.hpp"
#include "riprap/view/bad_request.hpp"
#include "riprap/view/case_waves.hpp"
#include "riprap/view/sea/sea_samples.hpp"
#include "riprap/wave/analysis/sea_statistics.hpp"

namespace riprap::view {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The word or the nearest there is. @throws BadRequest
void require_known(const std::string& word, const std::vector<std::string>& known, const std::string& what) {
    if (std::find(known.begin(), known.end(), word) == known.end()) {
        const std::string meant = scene::nearest(word, known);
        throw BadRequest(fmt::format("there is no {} '{}'; {}", what, word,
                                     meant.empty() ? fmt::format("there are: {}", fmt::join(known, ", "))
                                                   : fmt::format("did you mean '{}'?", meant)));
    }
}

/// Gauges and columns of one run.
SeaGauges gauges_of(const RecordedRun& run, const SeaRequest& request, const WaveReport& waves) {
    SeaGauges gauges;
    gauges.levels = waves.gauges;
    for (const GaugePlace& gauge : run.gauges) {
        if (gauge.kind == "run_up") {
            gauges.run_ups.push_back(gauge);
        } else if (gauge.kind == "flow") {
            gauges.flows.push_back(gauge);
        }
    }
    std::vector<std::string> columns;
    for (std::size_t c = 1; c < run.probes.columns.size(); ++c) {
        columns.push_back(run.probes.columns[c].name);
    }
    for (const std::string& force : request.forces) {
        require_known(force, columns, "column");
        gauges.forces.push_back(force);
    }
    gauges.depth = request.waves.depth ? request.waves.depth : waves_of_case(run).depth;
    return gauges;
}

void require_inputs(const wave::FormulaValues& given) {
    std::vector<std::string> known;
    for (const wave::FormulaInput& input : wave::formula_inputs()) {
        known.emplace_back(input.key);
    }
    for (const auto& [key, value] : given) {
        require_known(key, known, "input of a formula");
        if (!std::isfinite(value)) {
            throw BadRequest(fmt::format("{} is no value of {}", value, key));
        }
    }
}

/// Means over the whole stretches of all runs, with bands by their parts.
std::vector<SeaNumber> numbers_of(const std::vector<SeaSample>& wholes, const std::vector<SeaSample>& parts) {
    std::vector<SeaNumber> numbers;
    const auto values_of = [](const std::vector<SeaSample>& samples, const std::string& name) {
        std::vector<double> values;
        for (const SeaSample& sample : samples) {
            for (const SeaSample::Value& value : sample.values) {
                if (value.name == name) {
                    values.push_back(value.value);
                }
            }
        }
        return values;
    };
    for (const SeaSample::Value& first : wholes.front().values) {
        const wave::Confidence whole = wave::confidence_of(values_of(wholes, first.name));
        const wave::Confidence band = wave::confidence_of(values_of(parts, first.name));
        // Numbers of the highest waves grow with the length of a record: those of parts are of other numbers.
        const bool grows = first.name.find("max") != std::string::npos || first.name.find("min") != std::string::npos ||
                           first.name.find("1/250") != std::string::npos || first.name.starts_with("N_ow");
        const double reach = grows ? none : 0.5 * (band.high - band.low);
        numbers.push_back({first.name, first.unit, whole.mean, whole.mean - reach, whole.mean + reach, first.note});
    }
    return numbers;
}

double number(const SeaReport& report, const std::string& name) {
    for (const SeaNumber& one : report.numbers) {
        if (one.name.starts_with(name)) {
            return one.value;
        }
    }
    return none;
}

/// Inputs that the sea itself gives, those that are given before them.
wave::FormulaValues inputs_of(const SeaReport& report, const SeaSample& sample, const SeaRequest& request,
                              const std::optional<double>& depth) {
    wave::FormulaValues values = request.given;
    const auto add = [&values](const char* key, double value) {
        if (std::isfinite(value) && value > 0) {
            values.emplace(key, value);
        }
    };
    add("height", number(report, report.reflection.is_empty() ? "H_m0" : "H_m0 incident"));
    add("energy_period", number(report, report.reflection.is_empty() ? "T_m-1,0" : "T_m-1,0 incident"));
    add("mean_period", sample.mean_period);
    add("significant_period", sample.significant_period);
    add("highest", sample.highest);
    add("waves", sample.waves);
    add("depth", depth.value_or(none));
    return values;
}

void add_formulas(const wave::FormulaValues& values, SeaReport& report) {
    for (const wave::Formula& formula : wave::formulas()) {
        if (!wave::lacks(formula, values).empty()) {
            continue;
        }
        const double litres = formula.unit == "m^2/s" ? 1e3 : 1;
        wave::Predicted predicted = wave::predict(formula, values);
        for (double* part : {&predicted.value, &predicted.low, &predicted.high}) {
            *part *= litres;
        }
        const std::string quantity(formula.quantity);
        const bool is_measured = quantity == "q" || quantity == "R_u2%";
        report.formulas.push_back(
            {std::string(formula.name), quantity, litres > 1 ? "l/s/m" : std::string(formula.unit),
             std::string(formula.source), std::string(formula.range), predicted,
             is_measured ? number(report, quantity + ' ') : none, formula.is_in_range(values), formula.has_band});
    }
}

/// Says which frequencies the gauges leave out, and whether there are waves enough.
void add_notices(const SeaSample& whole, const SeaGauges& gauges, SeaReport& report) {
    constexpr double told = 0.002;  // of the energy
    for (const wave::BlindBand& band : whole.reflection.blind) {
        if (band.share > told) {
            report.notices.push_back(fmt::format(
                "frequencies from {:.3g} to {:.3g} Hz, {:.2g} % of the energy, are left out: their waves, about {:.3g} "
                "m "
                "long, have all gauges near multiples of half a wave length apart; move a gauge, or add one",
                band.low, band.high, 100 * band.share, band.length));
        }
    }
    if (!whole.reflection.is_empty() && gauges.levels.size() == 2) {
        report.notices.emplace_back("two gauges cannot tell noise from waves: with three it is taken off");
    }
    if (gauges.levels.size() > 1 && !gauges.depth) {
        report.notices.emplace_back("incident and reflected sea take the depth of still water: --depth");
    } else if (gauges.levels.size() > 1 && whole.reflection.is_empty()) {
        report.notices.emplace_back("the gauges cannot tell incident and reflected sea apart at any frequency of it");
    }
    if (whole.waves < static_cast<double>(wave::least_waves_for_2_percent)) {
        report.notices.push_back(fmt::format("{:.0f} waves: numbers of 2 % take {}, and 500 to 1000 are usual",
                                             whole.waves, wave::least_waves_for_2_percent));
    }
}

}  // namespace

SeaReport sea_report(const std::vector<RecordedRun>& runs, const SeaRequest& request) {
    require_inputs(request.given);
    SeaReport report{};
    report.runs = runs.size();
    report.parts = std::max(1, request.parts);
    std::vector<SeaSample> wholes, parts;
    std::optional<double> depth;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const WaveReport waves = analyse_waves(runs[r], request.waves);
        const SeaGauges gauges = gauges_of(runs[r], request, waves);
        SeaSample whole = sample_sea(runs[r], gauges, waves.from, waves.to);
        for (const auto& [name, volumes] : whole.volumes) {
            report.volumes.push_back({name, r, volumes});
        }
        for (int p = 0; p < report.parts; ++p) {
            const double length = (waves.to - waves.from) / report.parts;
            parts.push_back(sample_sea(runs[r], gauges, waves.from + p * length, waves.from + (p + 1) * length));
        }
        if (r == 0) {
            report.from = waves.from;
            report.to = waves.to;
            report.reflection = whole.reflection;
            depth = gauges.depth;
            add_notices(whole, gauges, report);
        }
        wholes.push_back(std::move(whole));
    }
    for (std::size_t i = 0; i < report.reflection.frequency.size(); ++i) {
        report.reflected_share.push_back(std::sqrt(report.reflection.reflected[i] / report.reflection.incident[i]));
    }
    report.numbers = numbers_of(wholes, parts);
    add_formulas(inputs_of(report, wholes.front(), request, depth), report);
    return report;
}

}  // namespace riprap::view
