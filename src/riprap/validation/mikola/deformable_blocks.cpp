// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/solid/affine/step_update.hpp"
#include "riprap/solid/explicit_dda/critical_step.hpp"
#include "riprap/validation/block_trial.hpp"
#include "riprap/validation/mikola/cases.hpp"

// Explicit DDA on scenes with exact answers: the source prints no number.

namespace riprap::validation::mikola {

namespace {

using solid::affine::rows_at;
using solid::explicit_dda::Form, solid::explicit_dda::stable_step, solid::explicit_dda::strain_frequency_squared;

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

void bar_waves(const CaseSetting& setting, CaseReport& report) {
    // A row of rigid-like cubes pressed together: masses m on springs K, a pulse travels at a sqrt(K/m) where it is
    // long.
    const int count = 90;
    const double side = 1, modulus = 1e9, stiffness = 1e7, density = 2500;
    ExplicitTrial trial;
    add_material(trial.system, {density, modulus, 0}, {stiffness / 4, 0});
    for (int i = 0; i < count; ++i) {
        // Pressed by 1 mm a joint, so that no joint opens; the pulse is a smooth bump of velocity at the left.
        const double bump = i > 0 && i < 20 ? 1e-2 * std::pow(std::sin(M_PI * (i + 0.5) / 20), 2) : 0;
        add_box(
            trial.system, trial.state.blocks, {side, side, side},
            {.position = {i * (side - 1e-3), 0, 0}, .velocity = {bump, 0, 0}, .is_fixed = i == 0 || i == count - 1});
    }
    const double mass = density * side * side * side;
    // The block is a spring too: E A/L in series with the joint.
    const double together = 1 / (1 / stiffness + side / (modulus * side * side));
    const double speed = side * std::sqrt(together / mass);
    trial.dt = 0.3 * stable_step(trial.system, trial.state.blocks);
    const auto energy = [&] { return trial.report.sums.kinetic + trial.report.strain + trial.report.contact; };
    const auto crest = [&] {
        // Centre of the pulse that runs to the right: mean place weighted by the velocity squared, right of the start.
        double sum = 0, moment = 0;
        for (int i = 25; i < count - 1; ++i) {
            const double v = trial.velocity(i).x;
            sum += v * v;
            moment += v * v * i * side;
        }
        return moment / sum;
    };
    trial.step();
    const double before = energy();
    trial.run_until(45 / speed);
    const double first = crest(), at_first = trial.time;
    Curve pulse{"velocity at the end", {}, {}, CurveStyle::line, 0};
    trial.run_until(65 / speed);
    for (int i = 0; i < count; ++i) {
        pulse.x.push_back(i * side);
        pulse.y.push_back(trial.velocity(i).x);
    }
    write_plot(setting, "pulse",
               {"A pulse in a bar of blocks", "explicit DDA", {"place [m]"}, {"velocity [m/s]"}, {pulse}});
    report.judge({"speed of a long pulse", "m/s", {}, speed, {}}, (crest() - first) / (trial.time - at_first),
                 Relative{0.02});
    const double drift = std::abs(energy() - before);
    report.judge_below({"drift of the energy over that of the pulse and the springs", "-", {}, 0, {}}, drift / before,
                       1e-4);
    // Two such cubes meet face to face: as fast as they came.
    ExplicitTrial impact;
    add_material(impact.system, {density, 1e11, 0.25}, {1e6, 1e6});
    add_box(impact.system, impact.state.blocks, {1, 1, 1}, {.velocity = {1, 0, 0}});
    add_box(impact.system, impact.state.blocks, {1, 1, 1}, {.position = {1.01, 0, 0}, .velocity = {-1, 0, 0}});
    impact.dt = 2e-5;
    impact.run_until(0.1);
    report.judge({"two cubes face to face: restitution", "-", {}, 1, {}},
                 (impact.velocity(1).x - impact.velocity(0).x) / 2, Relative{1e-3});
    // Highest frequency of the strain of one cube against the formula of the card of the method.
    const double exact = side * std::sqrt(density * (1 - 2 * 0.25) / (3 * 5e10));
    const Mat3 inertia = Mat3::diagonal({mass / 12, mass / 12, mass / 12});
    report.judge({"critical step of a free cube, 1 m, 50 GPa", "s", {}, exact, {}},
                 2 / std::sqrt(strain_frequency_squared({density, 5e10, 0.25}, 1, inertia)), Relative{1e-12});
}

}  // namespace riprap::validation::mikola
