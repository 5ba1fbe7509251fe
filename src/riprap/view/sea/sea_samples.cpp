// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/sea/sea_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/error.hpp"
#include "riprap/wave/analysis/sea_statistics.hpp"
#include "riprap/wave/wave_analysis.hpp"

namespace riprap::view {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Rows of the table within a stretch.
struct Rows {
    const io::CsvTable& table;
    std::size_t begin, end;

    std::vector<double> time() const { return {table.values[0].begin() + first(), table.values[0].begin() + last()}; }
    std::vector<double> column(const std::string& name) const {
        const std::vector<double>& all = whole(name);
        return {all.begin() + first(), all.begin() + last()};
    }
    const std::vector<double>& whole(const std::string& name) const {
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            if (table.columns[c].name == name) {
                return table.values[c];
            }
        }
        throw FileError(fmt::format("probes.csv has no column '{}': it is of another case than resolved.toml", name));
    }

 private:
    std::ptrdiff_t first() const { return static_cast<std::ptrdiff_t>(begin); }
    std::ptrdiff_t last() const { return static_cast<std::ptrdiff_t>(end); }
};

Rows rows_of(const io::CsvTable& table, double from, double to) {
    const std::vector<double>& time = table.values[0];
    const double slack = 1e-9 * (to - from);
    const auto begin = std::lower_bound(time.begin(), time.end(), from - slack);
    const auto end = std::upper_bound(begin, time.end(), to + slack);
    return {table, static_cast<std::size_t>(begin - time.begin()), static_cast<std::size_t>(end - time.begin())};
}

/// Heights and periods of a record, wave by wave.
struct WaveTrain {
    std::vector<double> heights;
    wave::WaveStatistics waves;
};

WaveTrain train_of(const std::vector<double>& time, const std::vector<double>& level) {
    WaveTrain train{{}, wave::statistics_of(time, level)};
    for (const wave::ZeroCrossingWave& one : wave::zero_crossing_waves(time, level)) {
        train.heights.push_back(one.height);
    }
    return train;
}

/// H_2%, where there are waves enough for it.
void add_2_percent(SeaSample& sample, const std::string& of, const WaveTrain& train) {
    const auto count = static_cast<std::int64_t>(train.heights.size());
    const bool is_enough = count >= wave::least_waves_for_2_percent;
    sample.values.push_back(
        {"H_2% " + of, "m", is_enough ? wave::exceeded_by(train.heights, 0.02, static_cast<double>(count)) : none,
         is_enough ? "" : fmt::format("{} waves: H_2% takes {}", count, wave::least_waves_for_2_percent)});
}

void set_train(SeaSample& sample, const WaveTrain& train) {
    sample.mean_period = train.waves.mean_period;
    sample.significant_period = train.waves.significant_period;
    sample.waves = static_cast<double>(train.waves.count);
    sample.highest = wave::mean_of_highest(train.heights, 1, 250);
}

void add_reflection(const SeaGauges& gauges, const Rows& rows, double gravity, SeaSample& sample) {
    wave::SeaRecord record{rows.time(), {}, {}, gauges.depth.value_or(none), gravity};
    for (const GaugeWaves& gauge : gauges.levels) {
        record.place.push_back(gauge.place);
        record.levels.push_back(rows.column(gauge.name));
    }
    sample.reflection = wave::reflect_sea(record);
    const wave::SeaReflection& found = sample.reflection;
    if (found.is_empty()) {
        return;
    }
    sample.values.push_back({"H_m0 incident", "m", found.incident_height, ""});
    sample.values.push_back({"H_m0 reflected", "m", found.reflected_height, ""});
    sample.values.push_back({"K_r", "-", found.coefficient, ""});
    sample.values.push_back({"T_m-1,0 incident", "s", found.energy_period, ""});
    sample.values.push_back({"T_p incident", "s", found.peak_period, ""});
    constexpr double most_blind = 0.05;  // of the energy: a record without more of it is another sea
    if (found.blind_share > most_blind) {
        sample.values.push_back(
            {"H_1/3 incident", "m", none, "too much of the sea is in frequencies that are left out"});
        return;
    }
    std::vector<double> time;
    for (std::size_t i = 0; i < found.incident_record.rows.size(); ++i) {
        time.push_back(found.incident_record.time(i));
    }
    const WaveTrain train = train_of(time, found.incident_record.rows);
    sample.values.push_back({"H_1/3 incident", "m", train.waves.significant_height, ""});
    add_2_percent(sample, "incident", train);
    set_train(sample, train);
    // The record of the incident sea is shorter by its faded ends.
    sample.waves *= (rows.time().back() - rows.time().front()) / (time.back() - time.front());
}

void add_levels(const SeaGauges& gauges, const Rows& rows, SeaSample& sample) {
    const std::vector<double> time = rows.time();
    for (const GaugeWaves& gauge : gauges.levels) {
        const std::vector<double> level = rows.column(gauge.name);
        const WaveTrain train = train_of(time, level);
        if (sample.waves == 0) {
            set_train(sample, train);
        }
        sample.values.push_back({"H_m0 " + gauge.name, "m", train.waves.spectral_height, ""});
        sample.values.push_back({"T_m-1,0 " + gauge.name, "s", wave::energy_period_of(time, level), ""});
        add_2_percent(sample, gauge.name, train);
    }
}

/// Run-up above the water line that the gauge reads before the first wave: a share of the incident waves exceeds it.
void add_run_ups(const SeaGauges& gauges, const Rows& rows, const Vec3& gravity, SeaSample& sample) {
    for (const GaugePlace& gauge : gauges.run_ups) {
        const std::vector<double>& whole = rows.whole(gauge.name);
        const auto still = std::find_if(whole.begin(), whole.end(), [](double v) { return std::isfinite(v); });
        if (still == whole.end() || !gauge.end) {
            continue;
        }
        const Vec3 way = normalized(*gauge.end - gauge.point);
        const double rise = -dot(way, gravity) / norm(gravity);
        std::vector<double> heights;
        for (const double reading : rows.column(gauge.name)) {
            heights.push_back((reading - *still) * rise);
        }
        const std::vector<double> peaks = wave::peaks_above(heights, 0);
        const double waves = sample.waves > 0 ? sample.waves : static_cast<double>(peaks.size());
        const bool is_enough = waves >= static_cast<double>(wave::least_waves_for_2_percent);
        sample.values.push_back(
            {"R_u2% " + gauge.name, "m", is_enough ? wave::exceeded_by(peaks, 0.02, waves) : none,
             is_enough ? fmt::format("{} run-ups of {:.0f} waves", peaks.size(), waves)
                       : fmt::format("{:.0f} waves: R_u2% takes {}", waves, wave::least_waves_for_2_percent)});
        sample.values.push_back(
            {"R_u,max " + gauge.name, "m", peaks.empty() ? none : *std::max_element(peaks.begin(), peaks.end()), ""});
    }
}

/// Width of a gauge of flow across the water: 1 m in planar scenes.
double width_of(const RecordedRun& run, const GaugePlace& gauge) {
    if (run.is_planar || !gauge.end) {
        return 1;
    }
    const Vec3 up = normalized(run.gravity), across = *gauge.end - gauge.point;
    return norm(across - up * dot(up, across));
}

void add_flows(const RecordedRun& run, const SeaGauges& gauges, const Rows& rows, SeaSample& sample) {
    const std::vector<double> time = rows.time();
    for (const GaugePlace& gauge : gauges.flows) {
        const double width = width_of(run, gauge);
        std::vector<double> flow = rows.column(gauge.name);
        for (double& value : flow) {
            value /= width;
        }
        wave::OvertoppingVolumes over = wave::overtopping_volumes(time, flow, 0.5 * std::max(0.0, sample.mean_period));
        const auto count = static_cast<double>(over.waves.size());
        constexpr double litre = 1e3;
        sample.values.push_back({"q " + gauge.name, "l/s/m", litre * over.total / over.duration, ""});
        sample.values.push_back({"V_max " + gauge.name, "l/m", litre * over.largest(), ""});
        sample.values.push_back({"N_ow " + gauge.name, "-", count,
                                 sample.waves > 0
                                     ? fmt::format("{:.3g} % of {:.0f} waves", 100 * count / sample.waves, sample.waves)
                                     : ""});
        sample.volumes.emplace_back(gauge.name, std::move(over));
    }
}

void add_forces(const SeaGauges& gauges, const Rows& rows, SeaSample& sample) {
    const std::vector<double> time = rows.time();
    for (const std::string& name : gauges.forces) {
        for (const bool is_negative : {false, true}) {
            std::vector<double> values = rows.column(name);
            for (double& value : values) {
                value = is_negative ? -value : value;
            }
            const double period = sample.mean_period > 0 ? sample.mean_period : 0;
            const std::vector<double> peaks = wave::separate_peaks(time, values, 0.5 * period);
            const double sign = is_negative ? -1 : 1;
            const std::string way = is_negative ? "min " : "max ";
            std::string unit;
            for (const io::CsvColumn& column : rows.table.columns) {
                unit = column.name == name ? column.unit : unit;
            }
            sample.values.push_back(
                {way + name, unit, peaks.empty() ? none : sign * *std::max_element(peaks.begin(), peaks.end()), ""});
            const auto count = static_cast<double>(peaks.size());
            const double waves = sample.waves > 0 ? sample.waves : count;
            sample.values.push_back({way + "1/250 " + name, unit,
                                     sign * wave::mean_of_highest(peaks, waves / count, 250),
                                     waves < 250 ? fmt::format("{:.0f} waves: the highest alone", waves)
                                                 : fmt::format("of {:.0f} waves", waves)});
        }
    }
}

}  // namespace

SeaSample sample_sea(const RecordedRun& run, const SeaGauges& gauges, double from, double to) {
    SeaSample sample;
    const Rows rows = rows_of(run.probes, from, to);
    if (rows.end - rows.begin < 2) {
        return sample;
    }
    if (gauges.depth && gauges.levels.size() > 1 && norm(run.gravity) > 0) {
        add_reflection(gauges, rows, norm(run.gravity), sample);
    }
    add_levels(gauges, rows, sample);
    add_run_ups(gauges, rows, run.gravity, sample);
    add_flows(run, gauges, rows, sample);
    add_forces(gauges, rows, sample);
    return sample;
}

}  // namespace riprap::view
