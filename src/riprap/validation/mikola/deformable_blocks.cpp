// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/solid/affine/step_update.hpp"
#include "riprap/validation/block_trial.hpp"
#include "riprap/validation/mikola/cases.hpp"

// A block that turns many times, by explicit DDA.

namespace riprap::validation::mikola {

namespace {

using solid::affine::rows_at;
using solid::explicit_dda::Form;

}  // namespace

void rotating_block(const CaseSetting& setting, CaseReport& report) {
    const double modulus = 1e6, density = 2500;
    const int steps_per_turn = 2000, turns = setting.is_full ? 1000 : 50;
    const Vec3 size{1, 0.7, 0.4};
    const double dt = 1e-3, angle = 2 * M_PI / steps_per_turn;
    {
        // Poses at mid-step on a circle, those between them in the middle of the chords: no swing about equilibrium.
        ExplicitTrial trial;
        add_material(trial.system, {density, modulus, 0.25}, {});
        const double w2 = 2 * (1 - std::cos(angle)) / (dt * dt) * density / 12;
        const Mat3 strain = solid::affine::elastic_strain(
            trial.system.materials[0], Mat3::diagonal({w2 * size.x * size.x, w2 * size.y * size.y, 0}));
        const auto stretch = [&](int i) { return std::sqrt(1 + 2 * strain(i, i)); };
        const double chord = std::cos(0.5 * angle);
        add_box(trial.system, trial.state.blocks, size,
                {.deformation = Mat3::diagonal({chord * stretch(0), chord * stretch(1), stretch(2)}),
                 .spin = {0, 0, 2 / dt * std::tan(0.5 * angle)}});
        trial.dt = dt;
        const double volume = determinant(rows_at(trial.state.blocks.deformation, 0));
        const Vec3 momentum = measure(trial.system, trial.state.blocks).angular_momentum;
        double growth = 0;
        for (int i = 0; i < turns; ++i) {
            trial.step(steps_per_turn);
            growth = std::max(growth, std::abs(determinant(rows_at(trial.state.blocks.deformation, 0)) / volume - 1));
        }
        report.judge_below({fmt::format("finite strain, {} turns: change of volume", turns), "-", {}, 0, {}}, growth,
                           1e-10);
        report.judge_below({"finite strain: change of angular momentum", "-", {}, 0, {}},
                           norm(measure(trial.system, trial.state.blocks).angular_momentum - momentum) / norm(momentum),
                           1e-10);
    }
    {
        ExplicitTrial trial;
        trial.settings.form = Form::twelve_unknowns;
        add_material(trial.system, {density, 0, 0}, {});
        add_box(trial.system, trial.state.blocks, size, {.spin = {0.02, angle / dt, 0.01}});
        trial.dt = dt;
        const Vec3 momentum = measure(trial.system, trial.state.blocks).angular_momentum;
        trial.step(static_cast<std::int64_t>(turns) * steps_per_turn);
        report.judge_below({"twelve unknowns, tumbling: change of volume",
                            "-",
                            {},
                            0,
                            "the linear displacement function alone grows it by the square of the angle a step"},
                           determinant(rows_at(trial.state.blocks.deformation, 0)) - 1, 1e-10);
        report.judge_below({"twelve unknowns, tumbling: change of angular momentum", "-", {}, 0, {}},
                           norm(measure(trial.system, trial.state.blocks).angular_momentum - momentum) / norm(momentum),
                           1e-10);
    }
}

}  // namespace riprap::validation::mikola
