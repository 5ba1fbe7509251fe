// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/motions/paddle_waves.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "riprap/scene/case/sea_tables.hpp"
#include "riprap/scene/case/wave_range.hpp"

namespace riprap::scene {

namespace {

/// Heights above this share of the depth break at the paddle [-]: the limit of a solitary wave [McCowan1894].
constexpr double breaking_share = 0.78;

/// True where a motion.wave_maker has a height, in gravity; a problem where it has none.
bool has_height(CaseBuild& build, const WaveMaker& maker, const Value& table) {
    if (!maker.height) {
        build.problem(table.place, "a wave without 'height'", "the height of the wave, or wave = \"none\"");
        return false;
    }
    return norm(build.model.gravity.value) > 0;
}

/// Height at which a wave breaks [m], and what is allowed, in words.
struct BreakingLimit {
    double height;
    std::string allowed;
};
BreakingLimit solitary_limit(double depth) {
    return {breaking_share * depth,
            fmt::format("less than {:.4g} m, {} of the depth", breaking_share * depth, breaking_share)};
}

/// Refuses a wave that would break.
/// @param length  " and 2 m long", for the message
void refuse_breaking(CaseBuild& build, const WaveMaker& maker, const Value& table, const std::string& length,
                     const BreakingLimit& limit) {
    if (!(*maker.height < limit.height)) {
        build.problem(
            get(table, "height").place,
            fmt::format("a wave {:.4g} m high{} in {:.4g} m of water breaks", *maker.height, length, maker.depth),
            limit.allowed);
    }
}

/// Waves break above H = 0.142 L tanh kd [Miche1944].
constexpr double steepest = 0.142;

/// A wave that would break is refused with the lower of its two limits, and one that no paddle can make.
void check_regular(CaseBuild& build, const WaveMaker& maker, const Value& table) {
    if (!has_height(build, maker, table)) {
        return;
    }
    const BreakingLimit shallow = solitary_limit(maker.depth);
    if (!maker.period) {
        refuse_breaking(build, maker, table, "", shallow);
        return;
    }
    const double g = norm(build.model.gravity.value);
    const wave::LinearWave wave = wave::linear_wave(*maker.height, *maker.period, maker.depth, g);
    if (check_wave_length(build, get(table, "period").place, wave.height, *maker.period, wave.depth, " for a paddle")) {
        const double steep = steepest * wave.length() * std::tanh(wave.kd());
        const BreakingLimit limit{steep, fmt::format("less than {:.4g} m, 0.142 L tanh kd, or a longer period", steep)};
        refuse_breaking(build, maker, table, fmt::format(" and {:.4g} m long", wave.length()),
                        steep < shallow.height ? limit : shallow);
    }
}

/// The wave of a table that check_regular has accepted.
std::optional<wave::LinearWave> regular_wave(CaseBuild& build, const WaveMaker& maker, const Value& table,
                                             bool is_second_order) {
    if (!maker.period) {
        build.problem(table.place, "a regular wave without 'period'", "the period of the wave");
        return std::nullopt;
    }
    const wave::LinearWave wave =
        wave::linear_wave(*maker.height, *maker.period, maker.depth, norm(build.model.gravity.value));
    const double ursell_limit = 8 * std::numbers::pi * std::numbers::pi / 3;
    const double ursell = wave.height * wave.length() * wave.length() / std::pow(wave.depth, 3);
    if (is_second_order && ursell >= ursell_limit) {
        build.problem(
            table.place,
            fmt::format("H L^2/d^3 = {:.4g} is beyond second-order theory: its crests would be double", ursell),
            fmt::format("below 8 pi^2/3 = {:.4g}", ursell_limit));
        return std::nullopt;
    }
    return wave;
}

template <bool is_second_order>
std::optional<body::PrescribedMotion> regular_motion(CaseBuild& build, const WaveMaker& maker, const Value& table) {
    const std::optional<wave::LinearWave> made = regular_wave(build, maker, table, is_second_order);
    if (!made) {
        return std::nullopt;
    }
    const wave::LinearWave& wave = *made;
    const Vec3 gravity = build.model.gravity.value;
    const wave::RegularStroke stroke = wave::regular_stroke(wave, maker.paddle, is_second_order);
    body::HarmonicMotion motion;
    motion.amplitude = {stroke.first, stroke.second};
    motion.angular_frequency = wave.angular_frequency;
    motion.phase = maker.phase;
    motion.ramp = maker.ramp.value_or(4 * std::numbers::pi / wave.angular_frequency);
    motion.direction = maker.direction;
    if (maker.paddle == wave::Paddle::flap) {
        motion.arm = wave.depth;  // the stroke is that of its line at still water
        motion.center = *maker.hinge;
        motion.direction = cross(-1 / norm(gravity) * gravity, motion.direction);
    }
    return body::PrescribedMotion{motion};
}

void describe_regular(const WaveMaker& maker, double gravity, PaddleWave& told) {
    told.height = *maker.height;
    told.period = *maker.period;
    const wave::LinearWave wave = wave::linear_wave(told.height, told.period, told.depth, gravity);
    told.length = wave.length();
    told.celerity = wave.celerity();
    told.stroke = wave.height / wave::height_over_stroke(maker.paddle, wave.kd());
}

bool absorb_regular(CaseBuild& /*build*/, const WaveMaker& maker, const Value& /*table*/,
                    coupling::PaddleAbsorption& absorption) {
    absorption.regular = wave::linear_wave(*maker.height, *maker.period, absorption.depth, absorption.gravity);
    absorption.phase = maker.phase;
    absorption.ramp = maker.ramp.value_or(2 * *maker.period);
    return true;
}

wave::SolitaryWave solitary_wave(const WaveMaker& maker, double gravity) {
    return {*maker.height, maker.depth, gravity};
}

void check_solitary(CaseBuild& build, const WaveMaker& maker, const Value& table) {
    if (has_height(build, maker, table)) {
        refuse_breaking(build, maker, table, "", solitary_limit(maker.depth));
    }
}

std::optional<body::PrescribedMotion> solitary_motion(CaseBuild& build, const WaveMaker& maker,
                                                      const Value& /*table*/) {
    wave::MotionSeries series = wave::solitary_motion(solitary_wave(maker, norm(build.model.gravity.value)));
    body::SplineMotion motion;
    motion.direction = maker.direction;
    motion.time = std::move(series.time);
    motion.stroke = std::move(series.value);
    motion.rate = std::move(series.rate);
    return body::PrescribedMotion{std::move(motion)};
}

void describe_solitary(const WaveMaker& maker, double gravity, PaddleWave& told) {
    const wave::SolitaryWave wave = solitary_wave(maker, gravity);
    told.height = wave.height;
    told.celerity = wave.celerity();
    told.stroke = wave.volume() / wave.depth;
}

bool absorb_solitary(CaseBuild& /*build*/, const WaveMaker& maker, const Value& /*table*/,
                     coupling::PaddleAbsorption& absorption) {
    absorption.solitary = solitary_wave(maker, absorption.gravity);
    // The crest leaves the paddle at half its time, when it has gone half its stroke from its place at rest.
    const wave::MotionSeries series = wave::solitary_motion(*absorption.solitary);
    absorption.solitary_crest = 0.5 * series.time.back() - 0.5 * series.value.back() / absorption.solitary->celerity();
    return true;
}

std::optional<body::PrescribedMotion> paddle_of_sea(CaseBuild& build, const WaveMaker& /*maker*/, const Value& table) {
    std::optional<body::SplineMotion> motion = sea_motion(build, table);
    return motion ? std::optional(body::PrescribedMotion{std::move(*motion)}) : std::nullopt;
}

bool absorb_sea(CaseBuild& build, const WaveMaker& maker, const Value& table, coupling::PaddleAbsorption& absorption) {
    auto sea = paddle_sea(build, table);
    if (!sea) {
        return false;
    }
    absorption.sea = std::move(sea->waves);
    absorption.sea_period = sea->period;
    absorption.ramp = maker.ramp.value_or(2 * sea->period);
    return true;
}

}  // namespace

const PaddleWaveKind regular_paddle{"regular",        "a sine",      true, check_regular, regular_motion<false>,
                                    describe_regular, absorb_regular};
const PaddleWaveKind second_order_paddle{"second_order",
                                         "a sine whose free second harmonic is cancelled",
                                         false,
                                         check_regular,
                                         regular_motion<true>,
                                         describe_regular,
                                         absorb_regular};

const PaddleWaveKind solitary_paddle{"solitary",      "one solitary wave", false,          check_solitary,
                                     solitary_motion, describe_solitary,   absorb_solitary};

const PaddleWaveKind no_wave{
    "none",
    "for a paddle that only absorbs",
    false,
    [](CaseBuild& build, const WaveMaker& maker, const Value& table) {
        if (!maker.absorb) {
            build.problem(table.place, "a paddle that neither makes nor absorbs waves", "'absorb', or another wave");
        }
    },
    [](CaseBuild&, const WaveMaker&, const Value&) {
        return std::optional(body::PrescribedMotion{body::LinearMotion{}});
    },
    [](const WaveMaker&, double, PaddleWave&) {},
    [](CaseBuild&, const WaveMaker&, const Value&, coupling::PaddleAbsorption&) { return true; }};
/// Its spectrum may have the height: sea_motion looks at that.
const PaddleWaveKind sea_paddle{"irregular",   "a sea", false,     [](CaseBuild&, const WaveMaker&, const Value&) {},
                                paddle_of_sea, nullptr, absorb_sea};

}  // namespace riprap::scene
