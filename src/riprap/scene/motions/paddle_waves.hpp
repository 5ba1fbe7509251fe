// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "riprap/core/key.hpp"
#include "riprap/scene/case/case_build.hpp"
#include "riprap/wave/wave_maker.hpp"

namespace riprap::scene {

struct PaddleWaveKind;

/// A paddle as motion.wave_maker says it; what it says of a sea is read by sea_motion.
struct WaveMaker {
    wave::Paddle paddle{wave::Paddle::piston};
    const PaddleWaveKind* wave{nullptr};
    std::optional<double> height, period;  ///< [m], [s]
    double depth{0};                       ///< of still water [m]
    Vec3 direction{1, 0, 0};               ///< of the waves [-]
    std::optional<Vec3> hinge, absorb;     ///< of a flap; the foot of the face of a paddle that absorbs [m]
    double phase{0};                       ///< of the sine at the start [rad]
    std::optional<double> ramp;            ///< [s]
    WaveMaker();
    static KeyList<WaveMaker> keys();
};
WaveMaker read_wave_maker(const Value& table);

/// Kind of wave that a paddle makes, one of `paddle_waves`: `wave` of motion.wave_maker with its words and help, its
/// checks and what is told of it are made from that list. `table` has the places of the keys.
struct PaddleWaveKind {
    std::string_view word;  ///< as a case names it
    std::string_view help;  ///< what the paddle makes, without a full stop
    bool is_of_flaps;       ///< a flap can make it too; every kind is of pistons
    /// Adds problems of the wave by itself.
    void (*check)(CaseBuild& build, const WaveMaker& maker, const Value& table);
    /// The motion of the paddle; nothing, with problems, where the wave cannot be made.
    std::optional<body::PrescribedMotion> (*motion)(CaseBuild& build, const WaveMaker& maker, const Value& table);
    /// Sets what is told of the wave, but for its depth; nullptr for waves without one period and height.
    void (*describe)(const WaveMaker& maker, double gravity, PaddleWave& wave);
    /// Sets the waves that an absorbing paddle makes itself; false where they are wrong, which `motion` has told.
    bool (*absorb)(CaseBuild& build, const WaveMaker& maker, const Value& table,
                   coupling::PaddleAbsorption& absorption);
};

extern const PaddleWaveKind regular_paddle, second_order_paddle, solitary_paddle, no_wave, sea_paddle;

/// Every kind, in the order of the manual. One line registers a kind.
inline constexpr std::array paddle_waves{&regular_paddle, &second_order_paddle, &solitary_paddle, &no_wave,
                                         &sea_paddle};

}  // namespace riprap::scene
