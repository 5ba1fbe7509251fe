// SPDX-License-Identifier: Apache-2.0
// Paddles: the checks of all of them, and the kind of wave that each makes.
#include <fmt/format.h>

#include <cmath>

#include "riprap/scene/keys/bound_keys.hpp"
#include "riprap/scene/motions/build_motion.hpp"
#include "riprap/scene/motions/paddle_waves.hpp"

namespace riprap::scene {

namespace {

bool check_wave_maker(CaseBuild& build, const WaveMaker& maker, const Value& table) {
    const double g = norm(build.model.gravity.value);
    const bool is_flap = maker.paddle == wave::Paddle::flap;
    const std::size_t before = build.problems.size();
    if (g == 0) {
        build.problem(table.place, "a wave maker without gravity", "gravity that is not zero");
    } else if (build.model.gravity.changes()) {
        build.problem(table.place, "a wave maker in gravity that grows or turns", "gravity that stays as it is");
    }
    maker.wave->check(build, maker, table);
    if (is_flap && !maker.wave->is_of_flaps) {
        build.problem(table.place, fmt::format("a flap cannot make a '{}' wave here", maker.wave->word),
                      "paddle = \"piston\"");
    }
    if (is_flap && maker.absorb) {
        build.problem(table.place, "a flap cannot absorb waves here", "paddle = \"piston\"");
    }
    if (is_flap && !maker.hinge) {
        build.problem(table.place, "a flap without 'hinge'", "a point of its hinge at the bed");
    }
    if (g > 0 && std::abs(dot(maker.direction, build.model.gravity.value)) > 1e-9 * g) {
        build.problem(get(table, "direction").place, "waves that go up or down", "a direction normal to gravity");
    }
    return build.problems.size() == before;
}

}  // namespace

WaveMaker::WaveMaker() : wave(paddle_waves.front()) {}

KeyList<WaveMaker> WaveMaker::keys() {
    static const std::string wave_help = [] {
        std::string help = "The wave that the paddle makes.";
        for (const PaddleWaveKind* kind : paddle_waves) {
            help += fmt::format(" {}: {}{}.", kind->word, kind->help, kind->is_of_flaps ? "" : " (piston only)");
        }
        return help;
    }();
    std::vector<key::Word<const PaddleWaveKind*>> waves;
    for (const PaddleWaveKind* kind : paddle_waves) {
        waves.emplace_back(kind->word, kind);
    }
    using S = WaveMaker;
    return {key::choice(&S::paddle, "paddle", {{"piston", wave::Paddle::piston}, {"flap", wave::Paddle::flap}},
                        "An upright plate, or one hinged at the bed."),
            key::choice(&S::wave, "wave", waves, wave_help),
            key::number(&S::height, "height", dimension::length, key::positive(),
                        "Wave height, crest to trough; of a sea H_m0."),
            key::number(&S::depth, "depth", dimension::length, key::positive(), "Depth of still water.").required(),
            key::number(&S::period, "period", dimension::time, key::positive(),
                        "Wave period, of a sea that of its peak; not for a solitary wave."),
            key::direction(&S::direction, "direction", "Direction of the waves."),
            key::vector(&S::hinge, "hinge", dimension::length, "A point of a flap's hinge, at the bed."),
            key::vector(&S::absorb, "absorb", dimension::length,
                        "A point at the foot of the paddle's face: it then also takes up waves that come back, by the "
                        "surface in front of it (piston only; docs/theory/waves.md)."),
            key::number(&S::phase, "phase", dimension::angle, key::any(), "Phase of the sine at the start."),
            key::number(&S::ramp, "ramp", dimension::time, key::non_negative(),
                        "Time over which the stroke grows; two periods when not given.")};
}

WaveMaker read_wave_maker(const Value& table) {
    WaveMaker maker;
    read_keys(table, WaveMaker::keys(), maker);
    return maker;
}

std::optional<body::PrescribedMotion> wave_maker_motion(CaseBuild& build, const Value& table) {
    const WaveMaker maker = read_wave_maker(table);
    return check_wave_maker(build, maker, table) ? maker.wave->motion(build, maker, table) : std::nullopt;
}

std::optional<PaddleWave> paddle_wave(const CaseBuild& build, const Value& table) {
    const WaveMaker maker = read_wave_maker(table);
    if (maker.wave->describe == nullptr) {
        return std::nullopt;
    }
    PaddleWave told;
    told.kind = maker.wave->word;
    told.depth = maker.depth;
    maker.wave->describe(maker, norm(build.model.gravity.value), told);
    return told;
}

std::optional<coupling::PaddleAbsorption> paddle_absorption(CaseBuild& build, const Value& table) {
    const WaveMaker maker = read_wave_maker(table);
    const double g = norm(build.model.gravity.value);
    if (!maker.absorb || g == 0) {
        return std::nullopt;
    }
    coupling::PaddleAbsorption absorption;
    absorption.direction = maker.direction;
    absorption.foot = *maker.absorb;
    absorption.up = -1 / g * build.model.gravity.value;
    absorption.gravity = g;
    absorption.depth = maker.depth;
    return maker.wave->absorb(build, maker, table, absorption) ? std::optional(std::move(absorption)) : std::nullopt;
}

}  // namespace riprap::scene
