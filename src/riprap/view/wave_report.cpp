// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/wave_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/core/error.hpp"
#include "riprap/scene/text/suggest.hpp"
#include "riprap/view/bad_request.hpp"
#include "riprap/view/case_waves.hpp"
#include "riprap/wave/linear_wave.hpp"

namespace riprap::view {

namespace {

void check_numbers(const WaveRequest& request) {
    for (const std::optional<double>& value : {request.from, request.to, request.period, request.depth}) {
        if (value && !std::isfinite(*value)) {
            throw BadRequest(fmt::format("{} is no time, period or depth", *value));
        }
    }
    for (const std::optional<double>& value : {request.period, request.depth}) {
        if (value && !(*value > 0)) {
            throw BadRequest(fmt::format("{:.6g} is no period or depth: above 0", *value));
        }
    }
    if (request.direction && !(std::isfinite(norm(*request.direction)) && norm(*request.direction) > 0)) {
        throw BadRequest("the waves go nowhere: a direction that is not zero");
    }
}

/// The gauges asked for, in the order of the case.
std::vector<CaseWaves::Place> chosen(const CaseWaves& known, const std::vector<std::string>& wanted) {
    if (known.gauges.empty()) {
        throw BadRequest(
            "waves are read from gauges of kind 'level', or of kind 'surface' along an upright line; the run has none");
    }
    std::vector<std::string> names;
    for (const CaseWaves::Place& gauge : known.gauges) {
        names.push_back(gauge.gauge);
    }
    for (const std::string& name : wanted) {
        if (std::find(names.begin(), names.end(), name) == names.end()) {
            const std::string meant = scene::nearest(name, names);
            throw BadRequest(fmt::format("the run has no level or surface gauge '{}'; {}", name,
                                         meant.empty() ? fmt::format("it has {}", fmt::join(names, ", "))
                                                       : fmt::format("did you mean '{}'?", meant)));
        }
    }
    std::vector<CaseWaves::Place> gauges = known.gauges;
    std::erase_if(gauges, [&](const CaseWaves::Place& gauge) {
        return !wanted.empty() && std::find(wanted.begin(), wanted.end(), gauge.gauge) == wanted.end();
    });
    return gauges;
}

struct Record {
    std::vector<double> time, level;
};

/// Rows of one gauge from `from` to `to`.
Record record_of(const io::CsvTable& table, const std::string& gauge, double from, double to) {
    const auto column = std::find_if(table.columns.begin(), table.columns.end(),
                                     [&](const io::CsvColumn& one) { return one.name == gauge; });
    if (column == table.columns.end()) {
        throw FileError(fmt::format("probes.csv has no column '{}': it is of another case than resolved.toml", gauge));
    }
    const std::vector<double>& level = table.values[static_cast<std::size_t>(column - table.columns.begin())];
    const double slack = 1e-9 * (to - from);  // a row at an end of the stretch is in it
    Record record;
    for (std::size_t i = 0; i < table.row_count(); ++i) {
        const double time = table.values[0][i];
        if (time >= from - slack && time <= to + slack) {
            record.time.push_back(time);
            record.level.push_back(level[i]);
        }
    }
    return record;
}

/// The stretch asked for, as far as there are rows.
void set_stretch(const io::CsvTable& table, const WaveRequest& request, WaveReport& report) {
    if (table.row_count() == 0) {
        throw BadRequest("probes.csv has no row yet");
    }
    const double first = table.values[0].front(), last = table.values[0].back();
    report.from = request.from.value_or(0.5 * (first + last));
    report.to = request.to.value_or(last);
    if (!(report.from < report.to && report.from < last && report.to > first)) {
        throw BadRequest(fmt::format("the record goes from {:.6g} to {:.6g} s, asked for is {:.6g} to {:.6g} s", first,
                                     last, report.from, report.to));
    }
    report.from = std::max(report.from, first);
    report.to = std::min(report.to, last);
}

/// Keeps the period where the stretch holds it whole and rows tell it from others.
void set_period(const WaveRequest& request, const CaseWaves& known, double row_count, WaveReport& report) {
    const std::optional<double> period = request.period ? request.period : known.period;
    const double duration = report.to - report.from;
    constexpr double rows = 4;  // a period
    if (!period) {
        report.why_no_reflection = known.why_no_period;
    } else if (duration < *period * (1 - 1e-9)) {
        report.why_no_reflection =
            fmt::format("from {:.6g} to {:.6g} s is less than one period of {:.4g} s", report.from, report.to, *period);
    } else if (row_count < rows * duration / *period) {
        report.why_no_reflection =
            fmt::format("rows are {:.3g} s apart, too far for a period of {:.4g} s", duration / row_count, *period);
    } else {
        report.period = period;
        report.whole_from = report.to - std::floor(duration / *period * (1 + 1e-9)) * *period;
    }
}

void separate(double depth, double gravity, WaveReport& report) {
    const wave::LinearWave wave = wave::linear_wave(0, *report.period, depth, gravity);
    Reflection found{depth, wave.length(), {}, {}};
    std::vector<double> places;
    std::vector<std::complex<double>> amplitudes;
    for (const GaugeWaves& gauge : report.gauges) {
        if (std::isfinite(std::abs(gauge.amplitude))) {
            found.gauges.push_back(gauge.name);
            places.push_back(gauge.place);
            amplitudes.push_back(gauge.amplitude);
        } else {
            report.notices.push_back(
                fmt::format("'{}' has too few values for the reflection and is left out", gauge.name));
        }
    }
    found.parts = wave::separate_reflection(places, amplitudes, wave.wave_number);
    constexpr double least = 1e-6;  // of the depth: round-off has a height too
    if (places.size() < 2) {
        report.why_no_reflection = "it takes two gauges or more with values";
    } else if (!std::isfinite(found.length) || std::isnan(found.parts.incident)) {
        report.why_no_reflection = fmt::format(
            "the gauges cannot tell the two ways apart: waves are {:.4g} m long, and gauges should be 0.05 to 0.45 of "
            "that "
            "apart along them, or halves of it more",
            found.length);
    } else if (!(found.parts.incident > least * depth)) {
        report.why_no_reflection = fmt::format("there are no waves of {:.4g} s", *report.period);
    } else {
        report.reflection = std::move(found);
    }
}

/// Reports the spectrum of a record and the heights of its waves.
void set_shares(const Record& record, GaugeWaves& gauge) {
    constexpr std::int64_t waves_in_band = 40;  // smoother with more waves, and a fortieth of the peak wide at most
    const int bands = static_cast<int>(std::max<std::int64_t>(1, gauge.waves.count / waves_in_band));
    gauge.peak_period = wave::weighted_peak_period(wave::spectrum_of(record.time, record.level, bands));
    std::vector<double> heights;
    for (const wave::ZeroCrossingWave& one : wave::zero_crossing_waves(record.time, record.level)) {
        heights.push_back(one.height);
    }
    gauge.exceeded = wave::exceedances(std::move(heights));
}

/// The highest value of a record, above the first: what there is to say of a single wave.
void set_rise(const Record& record, GaugeWaves& waves) {
    const auto first = std::find_if(record.level.begin(), record.level.end(), [](double v) { return !std::isnan(v); });
    for (auto v = first; v != record.level.end(); ++v) {
        if (*v - *first > waves.rise) {
            waves.rise = *v - *first;
            waves.rise_time = record.time[static_cast<std::size_t>(v - record.level.begin())];
        }
    }
}

}  // namespace

WaveReport analyse_waves(const RecordedRun& run, const WaveRequest& request) {
    check_numbers(request);
    const CaseWaves known = waves_of_case(run);
    const std::vector<CaseWaves::Place> gauges = chosen(known, request.gauges);
    const Vec3 direction = normalized(request.direction.value_or(known.direction.value_or(Vec3{1, 0, 0})));
    WaveReport report{};
    set_stretch(run.probes, request, report);
    const Record any = record_of(run.probes, gauges.front().gauge, report.from, report.to);
    set_period(request, known, static_cast<double>(any.time.size()), report);
    for (const CaseWaves::Place& gauge : gauges) {
        const Record record = record_of(run.probes, gauge.gauge, report.from, report.to);
        GaugeWaves waves{
            gauge.gauge, dot(direction, gauge.point), wave::statistics_of(record.time, record.level), 0, {}, 0, 0};
        waves.missing = std::count_if(record.level.begin(), record.level.end(), [](double v) { return std::isnan(v); });
        if (waves.missing > 0) {
            report.notices.push_back(
                fmt::format("'{}' has no value in {} of {} rows: waves with such rows are not counted", gauge.gauge,
                            waves.missing, record.level.size()));
        }
        // A single wave may be over before the second half begins.
        const double begin = request.from ? report.from : run.probes.values[0].front();
        set_rise(record_of(run.probes, gauge.gauge, begin, report.to), waves);
        set_shares(record, waves);
        if (report.period) {
            const Record whole = record_of(run.probes, gauge.gauge, report.whole_from, report.to);
            waves.amplitude = wave::harmonic(whole.time, whole.level, 2 * std::numbers::pi / *report.period);
        }
        report.gauges.push_back(std::move(waves));
    }
    report.is_planar = run.is_planar;
    for (const std::string& name : known.flows) {
        const Record record = record_of(run.probes, name, report.from, report.to);
        report.flows.push_back({name, wave::overtopping_of(record.time, record.level)});
    }
    const std::optional<double> depth = request.depth ? request.depth : known.depth;
    if (report.period && !(norm(run.gravity) > 0)) {
        report.why_no_reflection = "the case has no gravity";
    } else if (report.period && !depth) {
        report.why_no_reflection = "no wave maker of the case gives a depth: give one";
    } else if (report.period) {
        separate(*depth, norm(run.gravity), report);
    }
    return report;
}

}  // namespace riprap::view
