// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "riprap/scene/build_case.hpp"
#include "riprap/scene/limits.hpp"
#include "riprap/wave/wave_maker.hpp"

namespace riprap::scene {

namespace {

/// Heights above this share of the depth break at the paddle [-]: the limit of a solitary wave [McCowan1894].
constexpr double breaking_share = 0.78;

/// A flap's stroke is that of its line at still water: angle = atan(x/d).
void turn_about_hinge(wave::MotionSeries& series, double depth) {
    for (std::size_t i = 0; i < series.value.size(); ++i) {
        const double slope = series.value[i] / depth;
        series.value[i] = std::atan(slope);
        series.rate[i] /= depth * (1 + slope * slope);
    }
}

std::optional<wave::MotionSeries> regular_series(CaseBuild& build, const Value& table, wave::Paddle paddle, double g) {
    const Value* period = table.find("period");
    if (period == nullptr) {
        build.problem(table.place, "a regular wave without 'period'", "the period of the wave");
        return std::nullopt;
    }
    const double end = build.model.time.end;
    const double T = period->as_number();
    if (80 * end / T > static_cast<double>(limits::table_rows)) {
        build.problem(period->place, fmt::format("{:.4g} waves of {:.4g} s until the end at {:.4g} s", end / T, T, end),
                      fmt::format("at most {}", limits::table_rows / 80));
        return std::nullopt;
    }
    const wave::LinearWave wave = wave::linear_wave(get_number(table, "height"), T, get_number(table, "depth"), g);
    const bool is_second_order = get_text(table, "wave") == "second_order";
    const double ursell_limit = 8 * std::numbers::pi * std::numbers::pi / 3;
    const double ursell = wave.height * wave.length() * wave.length() / std::pow(wave.depth, 3);
    if (is_second_order && ursell >= ursell_limit) {
        build.problem(
            table.place,
            fmt::format("H L^2/d^3 = {:.4g} is beyond second-order theory: its crests would be double", ursell),
            fmt::format("below 8 pi^2/3 = {:.4g}", ursell_limit));
        return std::nullopt;
    }
    return wave::regular_motion({.wave = wave,
                                 .paddle = paddle,
                                 .phase = get_number(table, "phase"),
                                 .ramp = get_number_or(table, "ramp", 2 * T),
                                 .second_order = is_second_order},
                                end);
}

}  // namespace

std::optional<body::SplineMotion> wave_maker_motion(CaseBuild& build, const Value& table) {
    const Vec3 gravity = build.model.gravity.value;
    const double g = norm(gravity);
    const double height = get_number(table, "height");
    const double depth = get_number(table, "depth");
    const auto paddle = get_text(table, "paddle") == "flap" ? wave::Paddle::flap : wave::Paddle::piston;
    const std::string& kind = get_text(table, "wave");
    const std::size_t before = build.problems.size();
    if (g == 0) {
        build.problem(table.place, "a wave maker without gravity", "gravity that is not zero");
    }
    if (height >= breaking_share * depth) {
        build.problem(get(table, "height").place,
                      fmt::format("a wave {:.4g} m high in {:.4g} m of water breaks", height, depth),
                      fmt::format("less than {} of the depth", breaking_share));
    }
    if (paddle == wave::Paddle::flap && kind != "regular") {
        build.problem(table.place, fmt::format("a flap cannot make a '{}' wave here", kind), "paddle = \"piston\"");
    }
    if (paddle == wave::Paddle::flap && table.find("hinge") == nullptr) {
        build.problem(table.place, "a flap without 'hinge'", "a point of its hinge at the bed");
    }
    const Vec3 direction = normalized(get_vector(table, "direction"));
    if (g > 0 && std::abs(dot(direction, gravity)) > 1e-9 * g) {
        build.problem(get(table, "direction").place, "waves that go up or down", "a direction normal to gravity");
    }
    if (build.problems.size() > before) {
        return std::nullopt;
    }
    std::optional<wave::MotionSeries> series =
        kind == "solitary" ? wave::solitary_motion({height, depth, g}) : regular_series(build, table, paddle, g);
    if (!series) {
        return std::nullopt;
    }
    body::SplineMotion motion;
    motion.direction = direction;
    if (paddle == wave::Paddle::flap) {
        turn_about_hinge(*series, depth);
        motion.is_turn = true;
        motion.center = get_vector(table, "hinge");
        motion.direction = cross(-1 / g * gravity, direction);
    }
    motion.time = std::move(series->time);
    motion.stroke = std::move(series->value);
    motion.rate = std::move(series->rate);
    return motion;
}

}  // namespace riprap::scene
