// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "riprap/coupling/particle_walls/paddle_absorption.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"
#include "riprap/wave/paddle_sea.hpp"
#include "riprap/wave/wave_maker.hpp"

namespace riprap::coupling {
namespace {

constexpr double g = 9.81, gauge = 0.1;

PaddleAbsorption regular_paddle(double period) {
    PaddleAbsorption paddle;
    paddle.depth = 0.5;
    paddle.still = 0.5;
    paddle.regular = wave::linear_wave(0.05, period, 0.5, g);
    return paddle;
}

TEST(PaddleAbsorption, a_paddle_does_not_answer_the_wave_it_makes_itself) {
    const PaddleAbsorption paddle = regular_paddle(1.5);
    const wave::LinearWave& wave = *paddle.regular;
    const double half_stroke = wave::regular_stroke(wave, wave::Paddle::piston, false).first;
    for (const double t : {10.0, 10.3, 10.9}) {
        const double angle = wave.angular_frequency * t, x = half_stroke * std::sin(angle);
        const double eta =
            0.025 * std::cos(angle - wave.wave_number * gauge) + wave::evanescent_elevation(wave, gauge) * x;
        EXPECT_NEAR(absorbing_velocity(paddle, t, 0.5 + eta, x, 0, gauge), 0, 1e-12);
    }
}

TEST(PaddleAbsorption, a_wave_that_arrives_is_met_by_the_motion_that_makes_its_opposite) {
    for (const double period : {0.8, 1.5, 6.0}) {  // deep to shallow water
        const PaddleAbsorption paddle = regular_paddle(period);
        const wave::LinearWave& wave = *paddle.regular;
        const double own = absorbing_velocity(paddle, 20, 0.5, 0, 0, gauge);
        const double u = absorbing_velocity(paddle, 20, 0.5 + 0.01, 0, 0, gauge) - own;
        // A paddle of velocity u makes waves of amplitude u/w H/S.
        EXPECT_NEAR(u / wave.angular_frequency * height_over_stroke(wave::Paddle::piston, wave.kd()), -0.01, 1e-12);
    }
    PaddleAbsorption shallow;
    shallow.depth = 0.5;
    EXPECT_NEAR(absorbing_velocity(shallow, 0, 0.01, 0, 0, gauge), -0.01 * std::sqrt(g / 0.5), 1e-12);
}

TEST(PaddleAbsorption, a_paddle_that_was_carried_away_comes_back_within_periods) {
    const PaddleAbsorption paddle = regular_paddle(1.5);
    const double at_rest = absorbing_velocity(paddle, 20, 0.5, 0, 0, gauge);
    const double back = absorbing_velocity(paddle, 20, 0.5, 0, 0.2, gauge) - at_rest;
    EXPECT_NEAR(back, -0.2 / (5 * 1.5), 1e-12);
}

TEST(PaddleAbsorption, the_delay_takes_off_the_near_field_that_the_correction_makes) {
    // u = -G (eta - C_e (-u'/w^2)) for u = sin wt and the eta that goes with it: the delayed law gives u back.
    const PaddleAbsorption paddle = regular_paddle(1.5);
    const double w = paddle.regular->angular_frequency, delay = absorption_delay(paddle, 1e-4, gauge);
    const double gain = w / height_over_stroke(wave::Paddle::piston, paddle.regular->kd());
    EXPECT_NEAR(delay, gain * wave::evanescent_elevation(*paddle.regular, gauge) / (w * w), 1e-12);
    EXPECT_NEAR(absorption_delay(paddle, 10, gauge), 10 / std::sqrt(g * 0.5), 1e-12);
}

/// A paddle that makes a solitary wave, with its motion as a table from its start on.
PaddleAbsorption solitary_paddle(wave::MotionSeries& series) {
    PaddleAbsorption paddle;
    paddle.depth = 0.5;
    paddle.still = 0.5;
    paddle.solitary = wave::SolitaryWave{0.1, 0.5, g};
    series = wave::solitary_motion(*paddle.solitary);
    paddle.solitary_crest = 0.5 * series.time.back() - 0.5 * series.value.back() / paddle.solitary->celerity();
    return paddle;
}

TEST(PaddleAbsorption, a_paddle_does_not_answer_the_solitary_wave_it_makes_itself) {
    wave::MotionSeries series;
    const PaddleAbsorption paddle = solitary_paddle(series);
    const std::size_t middle = series.time.size() / 2;  // the crest is at the face: half time, half stroke
    for (const double later : {-0.3, 0.0, 0.2}) {
        const double t = series.time[middle] + later;
        const double face = series.value[middle];
        const double eta = paddle.solitary->elevation(face + gauge - (face + paddle.solitary->celerity() * later));
        EXPECT_NEAR(absorbing_velocity(paddle, t, 0.5 + eta, face, 0, gauge), 0, 1e-12);
    }
}

TEST(PaddleAbsorption, before_its_motion_starts_a_paddle_answers_all_there_is) {
    wave::MotionSeries series;
    for (PaddleAbsorption paddle : {solitary_paddle(series), regular_paddle(1.5)}) {
        paddle.start = 3;
        EXPECT_EQ(absorbing_velocity(paddle, 2.9, 0.5, 0, 0, gauge), 0);
        EXPECT_NE(absorbing_velocity(paddle, 3.0, 0.5, 0, 0, gauge), 0);
    }
}

TEST(PaddleAbsorption, where_the_gauge_is_dry_the_paddle_stays) {
    PaddleAbsorption paddle = regular_paddle(1.5);
    paddle.body = BodyId{0};
    body::BodySet bodies;
    bodies.driven.assign(1, -1);
    drive(bodies, paddle.body, 0, {});
    body::BodyState state;
    state.position.resize(1);
    state.drive_offset = {{0.1, 0, 0}};
    state.drive_rate.resize(1);
    fluid::SphSettings settings;
    settings.spacing = 0.025;
    settings.domain = {{-5, -5, 0}, {5, 5, 0}, {}, 2};
    std::vector<double> surge;
    absorb_waves(std::vector{paddle}, bodies, 20, 0.01, settings, {}, surge, state);
    EXPECT_EQ(state.drive_rate[0], Vec3{});
}

TEST(PaddleAbsorption, a_paddle_does_not_answer_the_sea_it_makes_itself) {
    PaddleAbsorption paddle;
    paddle.depth = 0.5;
    paddle.still = 0.5;
    paddle.sea = wave::jonswap_sea(0.04, 2.5, 3.3, 0.5, g, 20, 7);
    paddle.sea_period = 2.5;
    paddle.ramp = 5;
    prepare_sea(paddle, 0.25 * gauge);
    for (const double t : {10.0, 13.7, 21.2}) {
        double stroke = 0, eta = 0, alone = 0;  // the gauge goes with the face, progressive waves do not
        for (const wave::StrokeHarmonic& one : wave::first_order_stroke(*paddle.sea)) {
            stroke += (one.amplitude * std::polar(1.0, one.angular_frequency * t)).real();
            const double k = wave::wave_number(one.angular_frequency, 0.5, g);
            const wave::LinearWave linear{0, 0.5, g, one.angular_frequency, k};
            alone += wave::evanescent_elevation(linear, gauge) *
                     (one.amplitude * std::polar(1.0, one.angular_frequency * t)).real();
        }
        eta = paddle.sea->elevation(stroke + gauge, t) + alone;
        EXPECT_NEAR(absorbing_velocity(paddle, t, 0.5 + eta, stroke, 0, gauge), 0, 1e-9);
        EXPECT_LT(absorbing_velocity(paddle, t, 0.51 + eta, stroke, 0, gauge), -0.03);
    }
    paddle.start = 3;
    EXPECT_EQ(absorbing_velocity(paddle, 2.9, 0.5, 0, 0, gauge), 0);
}

}  // namespace
}  // namespace riprap::coupling
