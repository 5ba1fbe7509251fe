// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

#include "riprap/solid/explicit_dda/advance.hpp"

namespace riprap::validation {

/// Deformable blocks moved by the explicit engine itself, without a case file.
struct ExplicitTrial {
    solid::affine::BlockSystem system;
    solid::explicit_dda::Settings settings{};
    solid::explicit_dda::State state{};
    solid::explicit_dda::Scratch scratch;
    solid::explicit_dda::StepReport report{};
    solid::affine::BlockLoads external{};
    double dt{1e-4}, time{0};

    void step(std::int64_t count = 1) {
        for (std::int64_t i = 0; i < count; ++i) {
            const auto outcome = advance(system, settings, dt, external, state, scratch, report);
            if (!outcome.ok()) {
                throw std::runtime_error(outcome.problem);
            }
            time += dt;
        }
    }
    void run_until(double end) {
        while (time < end - 1e-9 * dt) {
            step();
        }
    }
    const Vec3& position(std::int32_t block) const { return state.blocks.position[static_cast<std::size_t>(block)]; }
    const Vec3& velocity(std::int32_t block) const { return state.blocks.velocity[static_cast<std::size_t>(block)]; }
};

}  // namespace riprap::validation
