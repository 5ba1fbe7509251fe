// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/wave_report.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/core/error.hpp"
#include "riprap/scene/suggest.hpp"
#include "riprap/scene/toml_reader.hpp"
#include "riprap/view/bad_request.hpp"
#include "riprap/wave/linear_wave.hpp"

#include <fmt/format.h>

namespace riprap::view {

namespace {

/// What the case says of its waves.
struct CaseWaves {
    struct Place {
        std::string gauge;
        Vec3 point;
    };
    std::vector<Place> gauges;  ///< of kind level or surface
    Vec3 direction{1, 0, 0};
    std::optional<double> period, depth;  ///< of regular waves, where all wave makers agree
};

const scene::Value* at_path(const scene::Value& root, std::initializer_list<std::string_view> keys) {
    const scene::Value* value = &root;
    for (const std::string_view key : keys) {
        value = value != nullptr && value->is_table() ? value->find(key) : nullptr;
    }
    return value;
}

void read_wave_maker(const scene::Value& maker, int& count, CaseWaves& waves) {
    const scene::Value *kind = maker.find("wave"), *depth = maker.find("depth"), *period = maker.find("period");
    if (kind == nullptr || kind->text == "none" || depth == nullptr) {
        return;
    }
    const bool is_regular = kind->text != "solitary" && period != nullptr;
    const std::optional<double> its_period = is_regular ? std::optional(period->as_number()) : std::nullopt;
    if (count++ == 0) {
        waves.period = its_period;
        waves.depth = depth->as_number();
        if (const scene::Value* direction = maker.find("direction")) {
            waves.direction = normalized(scene::to_vector(*direction));
        }
    } else if (waves.period != its_period || waves.depth != depth->as_number()) {
        waves.period = waves.depth = std::nullopt;
    }
}

CaseWaves waves_of_case(const RecordedRun& run) {
    std::vector<Diagnostic> problems;
    const scene::Value root = scene::parse_toml(run.resolved_text, "resolved.toml", problems);
    CaseWaves waves;
    if (const scene::Value* gauges = at_path(root, {"output", "gauge"})) {
        for (const scene::Value& gauge : gauges->items) {
            const scene::Value *kind = gauge.find("kind"), *name = gauge.find("name"), *point = gauge.find("point");
            if (kind != nullptr && (kind->text == "level" || kind->text == "surface") && name != nullptr &&
                point != nullptr) {
                waves.gauges.push_back({name->text, scene::to_vector(*point)});
            }
        }
    }
    int makers = 0;
    if (const scene::Value* bodies = root.is_table() ? root.find("body") : nullptr) {
        for (const scene::Value& body : bodies->items) {
            if (const scene::Value* maker = at_path(body, {"motion", "wave_maker"})) {
                read_wave_maker(*maker, makers, waves);
            }
        }
    }
    return waves;
}

/// The gauges asked for, in the order of the case.
std::vector<CaseWaves::Place> chosen(const CaseWaves& known, const std::vector<std::string>& wanted) {
    if (known.gauges.empty()) {
        throw BadRequest("the run has no gauge of kind 'level' or 'surface', which waves are read from");
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

/// Rows of one gauge from `from` to `to`; rows without a value are left out.
Record record_of(const io::CsvTable& table, const std::string& gauge, double from, double to) {
    Record record;
    const auto column = std::find_if(table.columns.begin(), table.columns.end(),
                                     [&](const io::CsvColumn& one) { return one.name == gauge; });
    if (column == table.columns.end()) {
        throw BadRequest(fmt::format("probes.csv has no column '{}': it is of another case than resolved.toml", gauge));
    }
    const std::vector<double>& level = table.values[static_cast<std::size_t>(column - table.columns.begin())];
    for (std::size_t i = 0; i < table.row_count(); ++i) {
        const double time = table.values[0][i];
        const double slack = 1e-9 * (to - from);  // a row at an end of the stretch is in it
        if (time >= from - slack && time <= to + slack && !std::isnan(level[i])) {
            record.time.push_back(time);
            record.level.push_back(level[i]);
        }
    }
    return record;
}

/// Cuts [from, to] at its beginning to whole periods.
void cut_to_periods(WaveReport& report) {
    const double periods = std::floor((report.to - report.from) / *report.period * (1 + 1e-9));
    if (periods < 1) {
        throw BadRequest(
            fmt::format("from {:.6g} to {:.6g} s is less than one period of {:.6g} s: ask for a "
                        "longer stretch or another period",
                        report.from, report.to, *report.period));
    }
    report.from = report.to - periods * *report.period;
}

void separate(WaveReport& report, double depth, double gravity) {
    const wave::LinearWave wave = wave::linear_wave(0, *report.period, depth, gravity);
    std::vector<double> places;
    std::vector<std::complex<double>> amplitudes;
    for (const GaugeWaves& gauge : report.gauges) {
        places.push_back(gauge.place);
        amplitudes.push_back(gauge.amplitude);
    }
    const wave::Separation parts = wave::separate_reflection(places, amplitudes, wave.wave_number);
    if (std::isnan(parts.incident)) {
        report.why_no_reflection = fmt::format(
            "the gauges stand a multiple of half a wavelength apart along the waves, or in one place (L = {:.4g} m)",
            wave.length());
        return;
    }
    report.reflection = Reflection{*report.period, depth, wave.length(), parts};
}

void take_apart(const RecordedRun& run, const WaveRequest& request, const CaseWaves& known, WaveReport& report) {
    const std::optional<double> depth = request.depth ? request.depth : known.depth;
    const double gravity = norm(run.gravity);
    if (!report.period) {
        report.why_no_reflection = "no regular wave maker in the case gives a period: give one, and a depth";
    } else if (report.gauges.size() < 2) {
        report.why_no_reflection = "it takes two gauges or more";
    } else if (!depth || !(gravity > 0)) {
        report.why_no_reflection =
            gravity > 0 ? "no wave maker in the case gives a depth: give one" : "the case has no gravity";
    } else {
        separate(report, *depth, gravity);
    }
}

}  // namespace

WaveReport analyse_waves(const RecordedRun& run, const WaveRequest& request) {
    const CaseWaves known = waves_of_case(run);
    const std::vector<CaseWaves::Place> gauges = chosen(known, request.gauges);
    if (run.probes.row_count() == 0) {
        throw BadRequest("probes.csv has no row yet");
    }
    const double first = run.probes.values[0].front(), last = run.probes.values[0].back();
    WaveReport report{request.from.value_or(0.5 * (first + last)), request.to.value_or(last), {}, {}, {}, {}};
    if (!(report.from < report.to && report.from < last && report.to > first)) {
        throw BadRequest(fmt::format("the record goes from {:.6g} to {:.6g} s, asked for is {:.6g} to {:.6g} s", first,
                                     last, report.from, report.to));
    }
    report.from = std::max(report.from, first);
    report.to = std::min(report.to, last);
    report.period = request.period ? request.period : known.period;
    if (report.period) {
        cut_to_periods(report);
    }
    for (const CaseWaves::Place& gauge : gauges) {
        const Record record = record_of(run.probes, gauge.gauge, report.from, report.to);
        GaugeWaves waves{gauge.gauge, dot(known.direction, gauge.point),
                         wave::statistics_of(record.time, record.level)};
        if (report.period) {
            waves.amplitude = wave::harmonic(record.time, record.level, 2 * std::numbers::pi / *report.period);
        }
        report.gauges.push_back(std::move(waves));
    }
    take_apart(run, request, known, report);
    return report;
}

}  // namespace riprap::view
