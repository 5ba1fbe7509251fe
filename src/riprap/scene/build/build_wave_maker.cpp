// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "riprap/scene/build/build_case.hpp"
#include "riprap/scene/build/direction.hpp"
#include "riprap/scene/build/sea_tables.hpp"
#include "riprap/scene/build/wave_range.hpp"
#include "riprap/scene/keys/words.hpp"
#include "riprap/wave/wave_maker.hpp"

namespace riprap::scene {

namespace {

/// Heights above this share of the depth break at the paddle [-]: the limit of a solitary wave [McCowan1894].
constexpr double breaking_share = 0.78;

/// Waves break above H = 0.142 L tanh kd [Miche1944].
constexpr double steepest = 0.142;

/// k d beyond which the transfer function of a paddle is lost in round-off, or in numbers too large.
constexpr double least_kd = 1e-4, most_kd = 300;

WaveKind wave_of(const Value& table) { return get_word(table, "wave", wave_kinds()); }

/// Tells whether a regular wave of the period of `table` can be made at all; adds a problem where not.
bool check_length(CaseBuild& build, const Value& period, const wave::LinearWave& wave, double g) {
    const double kd = wave.kd();
    if (kd >= least_kd && kd <= most_kd) {
        return true;
    }
    build.problem(period.place,
                  fmt::format("waves of {:.4g} s in {:.4g} m of water are too {} for a paddle", period.as_number(),
                              wave.depth, is_short_wave(period.as_number(), wave.depth, g) ? "short" : "long"),
                  fmt::format("a period with kd = 2 pi d/L from {:g} to {:g}", least_kd, most_kd));
    return false;
}

/// A wave that would break is refused with the lower of its two limits, and one that no paddle can make.
void check_height(CaseBuild& build, const Value& table, double g) {
    const double height = get_number(table, "height"), depth = get_number(table, "depth");
    double highest = breaking_share * depth;
    std::string limit = fmt::format("less than {:.4g} m, {} of the depth", highest, breaking_share);
    std::string length;
    if (const Value* period = table.find("period"); wave_of(table) != WaveKind::solitary && period != nullptr) {
        const wave::LinearWave wave = wave::linear_wave(height, period->as_number(), depth, g);
        if (!check_length(build, *period, wave, g)) {
            return;
        }
        length = fmt::format(" and {:.4g} m long", wave.length());
        if (const double steep = steepest * wave.length() * std::tanh(wave.kd()); steep < highest) {
            highest = steep;
            limit = fmt::format("less than {:.4g} m, 0.142 L tanh kd, or a longer period", highest);
        }
    }
    if (!(height < highest)) {
        build.problem(get(table, "height").place,
                      fmt::format("a wave {:.4g} m high{} in {:.4g} m of water breaks", height, length, depth), limit);
    }
}

std::optional<wave::LinearWave> regular_wave(CaseBuild& build, const Value& table, double g) {
    const Value* period = table.find("period");
    if (period == nullptr) {
        build.problem(table.place, "a regular wave without 'period'", "the period of the wave");
        return std::nullopt;
    }
    const wave::LinearWave wave =
        wave::linear_wave(get_number(table, "height"), period->as_number(), get_number(table, "depth"), g);
    const double ursell_limit = 8 * std::numbers::pi * std::numbers::pi / 3;
    const double ursell = wave.height * wave.length() * wave.length() / std::pow(wave.depth, 3);
    if (wave_of(table) == WaveKind::second_order && ursell >= ursell_limit) {
        build.problem(
            table.place,
            fmt::format("H L^2/d^3 = {:.4g} is beyond second-order theory: its crests would be double", ursell),
            fmt::format("below 8 pi^2/3 = {:.4g}", ursell_limit));
        return std::nullopt;
    }
    return wave;
}

body::HarmonicMotion regular_motion(const Value& table, const wave::LinearWave& wave, wave::Paddle paddle,
                                    const Vec3& up) {
    const wave::RegularStroke stroke = wave::regular_stroke(wave, paddle, wave_of(table) == WaveKind::second_order);
    body::HarmonicMotion motion;
    motion.amplitude = {stroke.first, stroke.second};
    motion.angular_frequency = wave.angular_frequency;
    motion.phase = get_number(table, "phase");
    motion.ramp = get_number_or(table, "ramp", 4 * std::numbers::pi / wave.angular_frequency);
    motion.direction = direction_of(get_vector(table, "direction"));
    if (paddle == wave::Paddle::flap) {
        motion.arm = wave.depth;  // the stroke is that of its line at still water
        motion.center = get_vector(table, "hinge");
        motion.direction = cross(up, motion.direction);
    }
    return motion;
}

body::SplineMotion solitary_motion(const Value& table, const wave::SolitaryWave& wave) {
    wave::MotionSeries series = wave::solitary_motion(wave);
    body::SplineMotion motion;
    motion.direction = direction_of(get_vector(table, "direction"));
    motion.time = std::move(series.time);
    motion.stroke = std::move(series.value);
    motion.rate = std::move(series.rate);
    return motion;
}

bool check_wave_maker(CaseBuild& build, const Value& table, wave::Paddle paddle, double g) {
    const WaveKind kind = wave_of(table);
    const std::size_t before = build.problems.size();
    if (g == 0) {
        build.problem(table.place, "a wave maker without gravity", "gravity that is not zero");
    }
    if (kind != WaveKind::none && table.find("height") == nullptr) {
        build.problem(table.place, "a wave without 'height'", "the height of the wave, or wave = \"none\"");
    } else if (kind != WaveKind::none && g > 0) {
        check_height(build, table, g);
    }
    if (kind == WaveKind::none && table.find("absorb") == nullptr) {
        build.problem(table.place, "a paddle that neither makes nor absorbs waves", "'absorb', or another wave");
    }
    if (paddle == wave::Paddle::flap && kind != WaveKind::regular) {
        build.problem(table.place, fmt::format("a flap cannot make a '{}' wave here", get_text(table, "wave")),
                      "paddle = \"piston\"");
    }
    if (paddle == wave::Paddle::flap && table.find("absorb") != nullptr) {
        build.problem(table.place, "a flap cannot absorb waves here", "paddle = \"piston\"");
    }
    if (paddle == wave::Paddle::flap && table.find("hinge") == nullptr) {
        build.problem(table.place, "a flap without 'hinge'", "a point of its hinge at the bed");
    }
    const Vec3 direction = direction_of(get_vector(table, "direction"));
    if (g > 0 && std::abs(dot(direction, build.model.gravity.value)) > 1e-9 * g) {
        build.problem(get(table, "direction").place, "waves that go up or down", "a direction normal to gravity");
    }
    return build.problems.size() == before;
}

}  // namespace

std::optional<body::PrescribedMotion> wave_maker_motion(CaseBuild& build, const Value& table) {
    const Vec3 gravity = build.model.gravity.value;
    const double g = norm(gravity);
    const auto paddle = get_word(table, "paddle", paddles());
    if (!check_wave_maker(build, table, paddle, g)) {
        return std::nullopt;
    }
    const WaveKind kind = wave_of(table);
    body::PrescribedMotion motion;
    if (kind == WaveKind::solitary) {
        motion.law = solitary_motion(table, {get_number(table, "height"), get_number(table, "depth"), g});
    } else if (kind == WaveKind::none) {
        motion.law = body::LinearMotion{};
    } else if (const auto wave = regular_wave(build, table, g)) {
        motion.law = regular_motion(table, *wave, paddle, -1 / g * gravity);
    } else {
        return std::nullopt;
    }
    return motion;
}

PaddleWave paddle_wave(const CaseBuild& build, const Value& table) {
    PaddleWave result;
    result.kind = wave_of(table);
    result.depth = get_number(table, "depth");
    if (result.kind == WaveKind::none) {
        return result;
    }
    const double g = norm(build.model.gravity.value);
    result.height = get_number(table, "height");
    if (result.kind == WaveKind::solitary) {
        const wave::SolitaryWave wave{result.height, result.depth, g};
        result.celerity = wave.celerity();
        result.stroke = wave.volume() / wave.depth;
        return result;
    }
    const wave::LinearWave wave = wave::linear_wave(result.height, get_number(table, "period"), result.depth, g);
    const auto paddle = get_word(table, "paddle", paddles());
    result.period = get_number(table, "period");
    result.length = wave.length();
    result.celerity = wave.celerity();
    result.stroke = wave.height / wave::height_over_stroke(paddle, wave.kd());
    return result;
}

std::optional<coupling::PaddleAbsorption> paddle_absorption(CaseBuild& build, const Value& table) {
    const Value* absorb = table.find("absorb");
    const double g = norm(build.model.gravity.value), depth = get_number(table, "depth");
    if (absorb == nullptr || g == 0) {
        return std::nullopt;
    }
    coupling::PaddleAbsorption absorption;
    absorption.direction = direction_of(get_vector(table, "direction"));
    absorption.foot = to_vector(*absorb);
    absorption.up = -1 / g * build.model.gravity.value;
    absorption.gravity = g;
    absorption.depth = depth;
    if (makes_sea(table)) {
        auto sea = paddle_sea(build, table);
        if (!sea) {
            return std::nullopt;
        }
        absorption.sea = std::move(sea->waves);
        absorption.sea_period = sea->period;
        absorption.ramp = get_number_or(table, "ramp", 2 * sea->period);
        return absorption;
    }
    const WaveKind kind = wave_of(table);
    if (kind == WaveKind::solitary) {
        absorption.solitary = wave::SolitaryWave{get_number(table, "height"), depth, g};
        // The crest leaves the paddle at half its time, when it has gone half its stroke from its place at rest.
        const wave::MotionSeries series = wave::solitary_motion(*absorption.solitary);
        absorption.solitary_crest =
            0.5 * series.time.back() - 0.5 * series.value.back() / absorption.solitary->celerity();
    } else if (kind != WaveKind::none) {
        absorption.regular = wave::linear_wave(get_number(table, "height"), get_number(table, "period"), depth, g);
        absorption.phase = get_number(table, "phase");
        absorption.ramp = get_number_or(table, "ramp", 2 * get_number(table, "period"));
    }
    return absorption;
}

}  // namespace riprap::scene
