// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

/// Adds the motion of a body to the model. @returns its index, or -1 with a problem.
std::int32_t add_motion(CaseBuild& build, const Value& motion);

/// The motion of a paddle, from wave theory; nothing, with a problem, when the wave cannot be made.
std::optional<body::PrescribedMotion> wave_maker_motion(CaseBuild& build, const Value& table);
/// The wave of that table; nothing for a sea, which has no period.
std::optional<PaddleWave> paddle_wave(const CaseBuild& build, const Value& table);
/// Returns the absorption of that paddle; nothing where it absorbs no waves.
std::optional<coupling::PaddleAbsorption> paddle_absorption(CaseBuild& build, const Value& table);

}  // namespace riprap::scene
