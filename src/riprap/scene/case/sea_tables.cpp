// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/case/sea_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/direction.hpp"
#include "riprap/scene/keys/sea_words.hpp"
#include "riprap/scene/text/limits.hpp"
#include "riprap/scene/text/number_files.hpp"
#include "riprap/wave/linear_wave.hpp"
#include "riprap/wave/paddle_sea.hpp"

namespace riprap::scene {

namespace {

/// Components of the sea of a paddle: all their pairs count.
constexpr int paddle_components = 100;

/// Heights above this share of the depth break at the paddle [-], as solitary waves do [McCowan1894].
constexpr double breaking_share = 0.78;

/// Rows in a period of the peak: sums of two frequencies go up to six of the peak.
constexpr double rows_in_period = 100;

/// Of the surface elevation: m^2 s.
constexpr Dimension spectral_density{2, 0, 1, 0};

/// Points f [1/s], S [m^2 s] from a file; nothing with a problem.
std::optional<wave::Spectrum> read_spectrum(CaseBuild& build, const Value& file) {
    const geometry::TableForm form =
        form_of({{{"f", {"f", "frequency", "freq", "frequenz", "hz"}}, dimension::frequency},
                 {{"S", {"s", "density", "spectrum", "psd", "energy", "e", "see", "snn", "sxx", "syy", "szz", "seta"}},
                  spectral_density}},
                limits::table_rows);
    const auto rows = read_numbers(build.files, file.text, form, file.place, build.problems, build.notes);
    if (!rows) {
        return std::nullopt;
    }
    wave::Spectrum spectrum;
    double largest = 0;
    for (std::size_t i = 0; i < rows->row_count(); ++i) {
        const double f = rows->at(i, 0), density = rows->at(i, 1);
        const bool is_rising = f > (spectrum.is_empty() ? 0 : spectrum.frequency.back());
        if (!is_rising || density < 0) {
            const Diagnostic problem{
                rows->place(i, is_rising ? 1 : 0),
                fmt::format("row {} of the spectrum has f = {:.6g} 1/s and S = {:.6g} m^2 s", i + 1, f, density),
                "rising frequencies above 0, and densities of 0 or more"};
            add_problems_of(CaseError(problem), file.place, build.problems);
            return std::nullopt;
        }
        spectrum.frequency.push_back(f);
        spectrum.density.push_back(density);
        largest = std::max(largest, density);
    }
    if (spectrum.frequency.size() < 2 || !(largest > 0)) {
        build.problem(file.place, "a spectrum without variance", "two rows f, S or more, one of them above 0");
        return std::nullopt;
    }
    return spectrum;
}

wave::IrregularWave waves_of(const Sea& sea, double depth, double gravity) {
    return sea.spectrum.is_empty()
               ? wave::jonswap_sea(sea.height, sea.period, sea.gamma, depth, gravity, paddle_components, sea.seed)
               : wave::sea_of(sea.spectrum, depth, gravity, paddle_components, sea.seed);
}

/// Refuses seas beyond second-order theory, too high, steeper than a wave of their peak can be (as one of a spectrum
/// over rad/s is that is read as over 1/s), or too long for rows.
void check_sea(CaseBuild& build, const Value& table, const Sea& sea, double gravity) {
    const double depth = get_number(table, "depth"), end = build.model.time.end;
    const double most = sea.period / rows_in_period * static_cast<double>(limits::table_rows);
    const wave::LinearWave peak = wave::linear_wave(sea.height, sea.period, depth, gravity);
    const double length = peak.length();
    const double steepest = 0.142 * length * std::tanh(peak.kd());  // [Miche1944]
    const Value* file = table.find("spectrum_file");
    const double ursell = sea.height * length * length / (depth * depth * depth);
    if (end > most) {
        build.problem(table.place, fmt::format("a sea of {:.4g} s over {:.4g} s", sea.period, end),
                      fmt::format("at most {:.4g} s of it", most));
    } else if (!(sea.height < breaking_share * depth)) {
        build.problem(table.place,
                      fmt::format("a sea of H_m0 = {:.4g} m in {:.4g} m of water breaks", sea.height, depth),
                      fmt::format("less than {:.4g} m, {} of the depth", breaking_share * depth, breaking_share));
    } else if (!(sea.height < steepest)) {
        build.problem(file != nullptr ? file->place : table.place,
                      fmt::format("a sea {:.4g} m high whose peak at {:.4g} Hz is {:.4g} m long breaks", sea.height,
                                  1 / sea.period, length),
                      fmt::format("less than {:.4g} m, 0.142 L tanh kd{}", steepest,
                                  file != nullptr ? "; frequencies of the file in 1/s, not rad/s" : ""));
    } else if (get_boolean(table, "second_order") && ursell >= wave::second_order_limit) {
        build.problem(
            table.place,
            fmt::format("H_m0 L^2/d^3 = {:.4g} is beyond second-order theory: crests would be double", ursell),
            fmt::format("below 8 pi^2/3 = {:.4g}, or second_order = false", wave::second_order_limit));
    }
}

}  // namespace

std::optional<Sea> read_sea(CaseBuild& build, const Value& table) {
    const Value* file = table.find("spectrum_file");
    const Value* height = table.find("height");
    const Value* period = table.find("period");
    const bool is_pierson = get_word(table, "spectrum", spectra()) == SpectrumKind::pierson_moskowitz;
    Sea sea{height != nullptr ? height->as_number() : 0,
            period != nullptr ? period->as_number() : 0,
            is_pierson ? 1 : get_number(table, "gamma"),
            static_cast<std::uint64_t>(get_integer(table, "seed")),
            {}};
    if (file == nullptr) {
        if (height == nullptr || period == nullptr) {
            build.problem(table.place, fmt::format("a sea without '{}'", height == nullptr ? "height" : "period"),
                          "H_m0 and the period of the peak, or a 'spectrum_file'");
            return std::nullopt;
        }
        return sea;
    }
    auto spectrum = read_spectrum(build, *file);
    if (!spectrum) {
        return std::nullopt;
    }
    if (period != nullptr) {
        build.problem(period->place, "a sea with a 'period' and a spectrum from a file, which has its own",
                      "leave out 'period'");
        return std::nullopt;
    }
    const double own = spectrum->significant_height();
    sea.height = height != nullptr ? sea.height : own;
    for (double& density : spectrum->density) {
        density *= sea.height * sea.height / (own * own);
    }
    sea.period = spectrum->peak_period();
    sea.spectrum = std::move(*spectrum);
    return sea;
}

std::optional<body::SplineMotion> sea_motion(CaseBuild& build, const Value& table) {
    const std::size_t before = build.problems.size();
    const double depth = get_number(table, "depth"), g = norm(build.model.gravity.value);
    const auto sea = read_sea(build, table);
    if (sea && g > 0) {
        check_sea(build, table, *sea, g);
    }
    if (build.problems.size() > before) {
        return std::nullopt;
    }
    const wave::IrregularWave waves = waves_of(*sea, depth, g);
    std::vector<wave::StrokeHarmonic> stroke = wave::first_order_stroke(waves);
    if (get_boolean(table, "second_order")) {
        const auto second = wave::second_order_stroke(waves, g);
        stroke.insert(stroke.end(), second.begin(), second.end());
    }
    wave::MotionSeries series = wave::series_of(stroke, get_number_or(table, "ramp", 2 * sea->period),
                                                sea->period / rows_in_period, build.model.time.end);
    const auto [low, high] = std::minmax_element(series.value.begin(), series.value.end());
    const wave::LinearWave peak = wave::linear_wave(sea->height, sea->period, depth, g);
    build.notes.push_back(fmt::format(
        "a sea of H_m0 = {:.4g} m in {:.4g} m of water, T_p = {:.4g} s, {:.4g} m long there (kd = {:.3g}); the paddle "
        "goes from {:.4g} to {:.4g} m",
        sea->height, depth, sea->period, peak.length(), peak.kd(), *low, *high));
    body::SplineMotion motion;
    motion.direction = direction_of(get_vector(table, "direction"));
    motion.time = std::move(series.time);
    motion.stroke = std::move(series.value);
    motion.rate = std::move(series.rate);
    return motion;
}

std::optional<PaddleSea> paddle_sea(CaseBuild& build, const Value& table) {
    const std::size_t before = build.problems.size();
    const auto sea = read_sea(build, table);
    if (!sea || build.problems.size() > before) {
        build.problems.resize(before);  // said by sea_motion
        return std::nullopt;
    }
    return PaddleSea{waves_of(*sea, get_number(table, "depth"), norm(build.model.gravity.value)), sea->period};
}

}  // namespace riprap::scene
