// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

#include "riprap/solid/explicit_dda/advance.hpp"
#include "riprap/solid/implicit_dda/advance.hpp"

namespace riprap::validation {

/// Deformable blocks moved by the implicit engine itself, without a case file.
struct ImplicitTrial {
    solid::affine::BlockSystem system;
    std::vector<solid::implicit_dda::FixedPoint> fixed_points;
    solid::implicit_dda::Settings settings{};
    solid::implicit_dda::State state;
    solid::implicit_dda::Scratch scratch;
    solid::implicit_dda::StepReport report{};
    solid::affine::BlockLoads external{};
    double dt{1e-2}, time{0};

    void step(int count = 1) {
        for (int i = 0; i < count; ++i) {
            const auto outcome =
                advance_in_pieces(system, fixed_points, settings, dt, external, state, scratch, report);
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
    /// Static steps that keep no velocity, until the largest motion of a corner is below `still` [m].
    void settle(int most, double still) {
        const double dynamic = settings.dynamic, before = time;
        settings.dynamic = 0;
        for (int i = 0; i < most; ++i) {
            step();
            if (report.largest_displacement < still) {
                break;
            }
        }
        rest();
        settings.dynamic = dynamic;
        time = before;
    }
    void rest() {
        for (std::int32_t b = 0; b < system.size(); ++b) {
            if (system.is_fixed[static_cast<std::size_t>(b)] == 0) {
                state.blocks.velocity[static_cast<std::size_t>(b)] = {};
                solid::affine::set_rows(state.blocks.velocity_gradient, static_cast<std::size_t>(b), Mat3{});
            }
        }
    }
    const Vec3& position(std::int32_t block) const { return state.blocks.position[static_cast<std::size_t>(block)]; }
    const Vec3& velocity(std::int32_t block) const { return state.blocks.velocity[static_cast<std::size_t>(block)]; }
};

/// Blocks moved by the explicit engine.
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
