// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "riprap/solid/planar_dda/step.hpp"

namespace riprap::solid::planar_dda {

/// A scene of the tests: model, state and what advances them.
struct Blocks {
    Model model;
    State state;
    Settings settings;
    Scratch scratch;
    StepReport report;

    explicit Blocks(const Joint& joint = {}, const Material& material = {}) {
        model.materials.push_back(material);
        model.set_joint(0, 0, joint);
        settings = settings_for(10);
    }
    std::int32_t add(const std::vector<Vec2>& corners, bool is_fixed = false) {
        return Builder(model, state).add_block(corners, 0, is_fixed).value();
    }
    std::int32_t add_box(const Vec2& low, const Vec2& size, bool is_fixed = false) {
        return add({low, {low.x + size.x, low.y}, low + size, {low.x, low.y + size.y}}, is_fixed);
    }
    Outcome step(double dt, const Vec2& gravity = {}) {
        return advance(model, settings, {dt, gravity, {}, {}}, state, scratch, report);
    }
    /// Steps until `end`; false when a step is refused.
    bool run(int count, double dt, const Vec2& gravity = {}) {
        for (int k = 0; k < count; ++k) {
            if (const Outcome outcome = step(dt, gravity); !outcome.ok()) {
                ADD_FAILURE() << "step " << k << ": " << outcome.problem;
                return false;
            }
        }
        return true;
    }
};

}  // namespace riprap::solid::planar_dda
