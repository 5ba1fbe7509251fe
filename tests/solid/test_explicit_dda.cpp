// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "riprap/core/fields.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/quat.hpp"
#include "riprap/solid/affine/bonds.hpp"
#include "riprap/solid/affine/step_update.hpp"
#include "riprap/solid/explicit_dda/advance.hpp"
#include "riprap/solid/explicit_dda/critical_step.hpp"
#include "solid/block_scene.hpp"

namespace riprap::solid::explicit_dda {
namespace {

using affine::rows_at, affine::set_rows;

constexpr double gravity = 9.81;

/// A scene under way.
struct Trial {
    affine::BlockScene system;
    Settings settings{};
    State state{};
    Scratch scratch{};
    StepReport report{};
    affine::BlockLoads external{};
    double dt{1e-4};

    void step(int count = 1) {
        for (int i = 0; i < count; ++i) {
            ASSERT_EQ(advance(system, settings, dt, external, state, scratch, report).problem, "");
        }
    }
    void rock(double youngs_modulus = 1e7, const affine::Surface& surface = {1e6, 1e6}) {
        set_material(system, {2500, youngs_modulus, 0.25}, surface);
    }
    double volume(std::size_t block) const {
        return system.shape_of(static_cast<std::int32_t>(block)).volume *
               determinant(rows_at(state.blocks.deformation, block));
    }
};

TEST(ExplicitDda, free_fall_follows_the_parabola_for_any_step) {
    for (const Form form : {Form::pseudo_rigid, Form::twelve_unknowns}) {
        Trial run;
        run.settings.form = form;
        run.rock();
        run.system.gravity = {0, 0, -gravity};
        add_box(run.system, run.state.blocks, {1, 2, 3}, {.velocity = {1, 0, 0}});
        run.dt = 1e-3;
        run.step(1000);
        EXPECT_NEAR(run.state.blocks.position[0].z, -0.5 * gravity, 1e-11);
        EXPECT_NEAR(run.state.blocks.velocity[0].z, -gravity, 1e-11);
        EXPECT_NEAR(run.state.blocks.position[0].x, 1, 1e-12);
        EXPECT_NEAR(run.volume(0), 6, 1e-12);
    }
}

/// A block that spins about z by the angle `turn` each step without swinging, exactly in the discrete scheme: its poses
/// at mid-step lie on a circle, 2 (1 - cos turn)/dt^2 E0 = V0 (lambda tr(e) + 2 mu e) in x and y, those at the ends of
/// steps in the middle of the chords.
affine::NewBlock spinning(const affine::Rock& material, const Vec3& size, double turn, double dt) {
    const double w2 = 2 * (1 - std::cos(turn)) / (dt * dt) * material.density / 12;
    const affine::Elasticity rock{material.youngs_modulus, material.poisson_ratio};
    const Mat3 e = affine::elastic_strain(rock, Mat3::diagonal({w2 * size.x * size.x, w2 * size.y * size.y, 0}));
    const double chord = std::cos(0.5 * turn);
    return {.deformation = Mat3::diagonal(
                {chord * std::sqrt(1 + 2 * e(0, 0)), chord * std::sqrt(1 + 2 * e(1, 1)), std::sqrt(1 + 2 * e(2, 2))}),
            .spin = {0, 0, 2 / dt * std::tan(0.5 * turn)}};
}

TEST(ExplicitDda, a_spinning_block_keeps_its_volume_and_its_angular_momentum) {
    Trial run;
    run.rock(5e10);
    const Vec3 size{1, 0.7, 0.4};
    run.dt = 1e-5;
    const double turn = 2 * std::numbers::pi / 20000;
    add_box(run.system, run.state.blocks, size, spinning({2500, 5e10, 0.25}, size, turn, run.dt));
    const double volume = run.volume(0);
    const Vec3 momentum = measure(run.system, run.state.blocks).angular_momentum;
    run.step(40000);  // two turns
    EXPECT_NEAR(run.volume(0) / volume, 1, 1e-10);
    EXPECT_NEAR(norm(measure(run.system, run.state.blocks).angular_momentum - momentum) / norm(momentum), 0, 1e-10);
    EXPECT_NEAR(run.state.blocks.deformation[0].y, 0, 1e-8);  // back where it began
}

TEST(ExplicitDda, the_twelve_unknown_form_turns_without_growing) {
    // The linear displacement function alone would grow the volume by 1e-4 a step, 10 % in 1000 steps.
    Trial run;
    run.settings.form = Form::twelve_unknowns;
    run.rock(0);
    add_box(run.system, run.state.blocks, {1, 0.7, 0.4}, {.spin = {0.3, 10, 0.2}});
    run.dt = 1e-3;
    const Vec3 momentum = measure(run.system, run.state.blocks).angular_momentum;
    run.step(1000);
    EXPECT_NEAR(run.volume(0), 0.28, 1e-12);
    EXPECT_NEAR(norm(measure(run.system, run.state.blocks).angular_momentum - momentum) / norm(momentum), 0, 1e-10);
}

TEST(ExplicitDda, the_twelve_unknown_form_keeps_the_energy_of_a_tumbling_slab) {
    Trial run;
    run.settings.form = Form::twelve_unknowns;
    run.rock(0);
    add_box(run.system, run.state.blocks, {4, 2, 1}, {.spin = {0.1, 3, 0.05}});
    run.dt = 5e-3;
    const double before = measure(run.system, run.state.blocks).kinetic;
    for (int turn = 0; turn < 20; ++turn) {
        run.step(420);
        EXPECT_NEAR(measure(run.system, run.state.blocks).kinetic / before, 1, 1e-3);
    }
}

TEST(ExplicitDda, strain_modes_of_a_cube_have_the_frequency_of_the_formula) {
    const affine::Elasticity rock{5e10, 0.25};
    const double mass = 2500 * 8;
    const Mat3 inertia = Mat3::diagonal({mass / 3, mass / 3, mass / 3});  // m L^2/12, L = 2
    EXPECT_NEAR(strain_frequency_squared(rock, 8, inertia), 12 * 5e10 / ((1 - 0.5) * 2500 * 4), 1);
    // The breathing mode swings at that frequency.
    Trial run;
    set_material(run.system, {2500, 5e10, 0.25}, {});
    const double stretch = 1e-7;
    add_box(run.system, run.state.blocks, {2, 2, 2}, {.deformation = (1 + stretch) * Mat3::identity()});
    const double period = 2 * std::numbers::pi / std::sqrt(strain_frequency_squared(rock, 8, inertia));
    run.dt = period / 200;
    run.step(200);
    EXPECT_NEAR(run.state.blocks.deformation[0].x - 1, stretch, 1e-3 * stretch);
    run.step(100);
    EXPECT_NEAR(run.state.blocks.deformation[0].x - 1, -stretch, 1e-3 * stretch);
}

TEST(ExplicitDda, pull_strains_a_block_as_a_stress_would) {
    for (const Form form : {Form::pseudo_rigid, Form::twelve_unknowns}) {
        Trial run;
        run.settings.form = form;
        run.settings.mass_damping = 2000;
        run.rock(1e9);
        add_box(run.system, run.state.blocks, {1, 1, 1}, {});
        const double stress = 1e3;
        const std::vector<Mat3> pull{Mat3::diagonal({stress, 0, 0})};
        run.external.pull = pull;
        run.dt = 1e-5;
        run.step(2000);
        EXPECT_NEAR(run.state.blocks.stress[0].x, stress, 1e-2 * stress * 1e-3);
        EXPECT_NEAR(run.state.blocks.deformation[0].x - 1, stress / 1e9, 1e-5 * stress / 1e9);
        EXPECT_NEAR(run.state.blocks.deformation[1].y - 1, -0.25 * stress / 1e9, 1e-5 * stress / 1e9);
    }
}

TEST(ExplicitDda, a_torque_gives_its_angular_momentum) {
    for (const Form form : {Form::pseudo_rigid, Form::twelve_unknowns}) {
        Trial run;
        run.settings.form = form;
        run.rock(1e9);
        add_box(run.system, run.state.blocks, {1, 2, 3}, {});
        const std::vector<Vec3> torque{{300, -200, 500}};
        run.external.torque = torque;
        run.step(50);
        const Vec3 gained = measure(run.system, run.state.blocks).angular_momentum;
        EXPECT_LT(norm(gained - 50 * run.dt * torque[0]), 1e-9 * norm(gained));
    }
}

TEST(ExplicitDda, a_block_at_rest_weighs_on_its_four_corners) {
    Trial run;
    run.rock(1e8, {1e6, 1e6});
    run.system.gravity = {0, 0, -gravity};
    run.settings.mass_damping = 20;
    add_half_space(run.system, run.state.blocks, {0, 0, 1}, 0);
    add_box(run.system, run.state.blocks, {1, 1, 1}, {.position = {0, 0, 0.5}});
    run.dt = 2e-4;
    run.step(8000);
    EXPECT_EQ(run.report.contact_count, 4);
    double push = 0;
    for (const ContactForce& force : run.scratch.forces) {
        push += force.answer.normal_force;
    }
    EXPECT_NEAR(push, 2500 * gravity, 1e-4 * 2500 * gravity);
    EXPECT_NEAR(run.report.deepest, 2500 * gravity / 4e6, 1e-4 * 2500 * gravity / 4e6);
}

/// Block on a plane, gravity tilted by `slope` [rad]; settled by starting at the overlap of its weight.
Trial incline(double slope, double friction, Form form) {
    Trial run;
    run.settings.form = form;
    run.rock(1e9, {1e7, 1e7, false, friction});
    run.system.gravity = gravity * Vec3{std::sin(slope), 0, -std::cos(slope)};
    add_half_space(run.system, run.state.blocks, {0, 0, 1}, 0);
    const double overlap = 2500 * gravity * std::cos(slope) / 4e7;
    add_box(run.system, run.state.blocks, {1, 1, 1}, {.position = {0, 0, 0.5 - overlap}});
    run.dt = 1e-4;
    return run;
}

TEST(ExplicitDda, a_block_on_a_slope_slides_by_coulomb_or_stays) {
    const double slope = 30 * std::numbers::pi / 180;
    for (const double angle : {0.0, 10.0, 20.0}) {
        const double friction = std::tan(angle * std::numbers::pi / 180);
        Trial run = incline(slope, friction, Form::pseudo_rigid);
        // The friction springs load over the first tenth of a millimetre; the acceleration counts from there.
        run.step(1000);
        const double before = run.state.blocks.velocity[1].x;
        run.step(4000);
        const double a = gravity * (std::sin(slope) - std::cos(slope) * friction);
        EXPECT_NEAR((run.state.blocks.velocity[1].x - before) / 0.4, a, 1e-3 * a) << angle;
    }
    Trial stays = incline(slope, std::tan(slope) * 1.05, Form::pseudo_rigid);
    stays.settings.mass_damping = 50;
    stays.step(4000);
    stays.settings.mass_damping = 0;
    const double after = stays.state.blocks.position[1].x;
    stays.step(3000);
    EXPECT_NEAR(stays.state.blocks.position[1].x, after, 1e-6);
}

TEST(ExplicitDda, a_bond_holds_its_tensile_strength_and_is_gone_when_it_has_torn) {
    const double weight = 2500 * gravity;
    for (const double factor : {0.9, 1.1}) {
        Trial run;
        run.rock(1e9, {1e7, 1e7});
        run.system.gravity = {0, 0, -gravity};
        run.system.surfaces.pairs[0].tension = factor * weight;
        run.system.surfaces.pairs[0].cohesion = 1e9;
        add_box(run.system, run.state.blocks, {1, 1, 1}, {});
        add_box(run.system, run.state.blocks, {2, 2, 1}, {.position = {0, 0, 1}, .is_fixed = true});
        run.state.contacts.bonded = bonded_pairs(run.system, run.state.blocks);
        run.settings.mass_damping = 300;  // above the critical one: the load does not swing past the weight
        run.dt = 1e-4;
        run.step(4000);
        const bool holds = factor > 1;
        EXPECT_EQ(run.state.blocks.position[0].z > -0.005, holds) << run.state.blocks.position[0].z;
        EXPECT_EQ(run.state.contacts.bonded.size(), holds ? 1U : 0U);
        run.system.gravity = {0, 0, 20 * gravity};  // back to the roof, then hanging again
        run.step(10000);
        EXPECT_GT(run.state.blocks.position[0].z, -0.005);
        run.system.gravity = {0, 0, -gravity};
        run.step(4000);
        EXPECT_EQ(run.state.blocks.position[0].z > -0.005, holds);
    }
}

/// Two tilted boxes that hit each other off centre, free otherwise.
Trial collision(Form form, double friction) {
    Trial run;
    run.settings.form = form;
    run.rock(1e9, {1e7, 5e6, false, friction});
    const auto turned = [](const Vec3& w) { return to_matrix(from_rotation_vector(w)); };
    add_box(run.system, run.state.blocks, {1, 0.8, 0.6},
            {.deformation = turned({0.2, 0.3, 0.1}), .velocity = {1, 0, 0}});
    add_box(run.system, run.state.blocks, {0.7, 1, 0.9},
            {.position = {1.15, 0.3, 0.2}, .deformation = turned({-0.4, 0.1, 0.5}), .velocity = {-1, 0.1, 0}});
    run.dt = 2e-5;
    return run;
}

TEST(ExplicitDda, an_impact_keeps_momentum_and_angular_momentum) {
    for (const Form form : {Form::pseudo_rigid, Form::twelve_unknowns}) {
        Trial run = collision(form, 0.5);
        const affine::BlockSums before = measure(run.system, run.state.blocks);
        bool has_touched = false;
        for (int i = 0; i < 20000; ++i) {
            run.step();
            has_touched = has_touched || run.report.contact_count > 0;
        }
        const affine::BlockSums after = measure(run.system, run.state.blocks);
        EXPECT_TRUE(has_touched);
        EXPECT_EQ(run.report.contact_count, 0);
        EXPECT_LT(norm(after.momentum - before.momentum), 1e-9);
        EXPECT_LT(norm(after.angular_momentum - before.angular_momentum), 1e-8);  // of 1e3
    }
}

TEST(ExplicitDda, two_cubes_that_meet_face_to_face_fly_apart_as_fast) {
    // Stiff blocks on soft springs: hardly any energy stays behind as vibration of the blocks.
    Trial run;
    run.rock(1e11, {1e6, 1e6});
    add_box(run.system, run.state.blocks, {1, 1, 1}, {.velocity = {1, 0, 0}});
    add_box(run.system, run.state.blocks, {1, 1, 1}, {.position = {1.01, 0, 0}, .velocity = {-1, 0, 0}});
    run.dt = 2e-5;
    run.step(5000);
    EXPECT_EQ(run.report.contact_count, 0);
    EXPECT_NEAR(run.state.blocks.velocity[0].x, -1, 1e-4);
    EXPECT_NEAR(run.state.blocks.velocity[1].x, 1, 1e-4);
}

TEST(ExplicitDda, the_energy_ledger_closes_with_friction_and_dashpots) {
    Trial run = incline(0.6, 0.3, Form::pseudo_rigid);
    run.system.surfaces.pairs[0].damping_ratio = 0.2;
    double lost = 0;
    run.step();
    const double before = run.report.sums.kinetic + run.report.sums.potential + run.report.strain + run.report.contact;
    for (int i = 0; i < 5000; ++i) {
        run.step();
        lost += run.report.friction_loss + run.report.dashpot_loss + run.report.lost_energy;
    }
    const double after = run.report.sums.kinetic + run.report.sums.potential + run.report.strain + run.report.contact;
    EXPECT_NEAR((after + lost - before) / lost, 0, 2e-3);
}

TEST(ExplicitDda, the_same_bits_with_any_number_of_threads_and_from_a_fresh_scratch) {
    const auto hash_after = [](int threads, bool drop_scratch) {
        const int before = parallel::thread_count();
        parallel::set_thread_count(threads);
        Trial run;
        run.rock(1e7, {1e6, 1e6, false, 0.5});
        run.system.gravity = {0, 0, -gravity};
        add_half_space(run.system, run.state.blocks, {0, 0, 1}, 0);
        for (int i = 0; i < 27; ++i) {
            add_box(run.system, run.state.blocks, {1, 1, 1},
                    {.position = {1.01 * (i % 3) + 0.05 * (i / 9), 1.01 * (i / 3 % 3), 0.5 + 1.001 * (i / 9)}});
        }
        run.dt = 3e-4;
        run.step(60);
        if (drop_scratch) {
            run.scratch = {};
        }
        run.step(60);
        parallel::set_thread_count(before);
        return hash_fields(run.state);
    };
    const std::uint64_t one = hash_after(1, false);
    EXPECT_EQ(hash_after(2, false), one);
    EXPECT_EQ(hash_after(4, true), one);
}

TEST(ExplicitDda, the_stable_step_is_stable_and_four_times_of_it_is_not) {
    for (const bool is_stable : {true, false}) {
        Trial run;
        run.rock(1e9, {1e8, 1e8});
        run.system.gravity = {0, 0, -gravity};
        add_half_space(run.system, run.state.blocks, {0, 0, 1}, 0);
        add_box(run.system, run.state.blocks, {1, 1, 1}, {.position = {0, 0, 0.4999}});
        run.dt = stable_step(run.system, run.state.blocks) * (is_stable ? 0.9 : 6);
        Outcome outcome;
        for (int i = 0; i < 3000 && outcome.ok(); ++i) {
            outcome = advance(run.system, run.settings, run.dt, {}, run.state, run.scratch, run.report);
        }
        if (is_stable) {
            EXPECT_TRUE(outcome.ok());
            EXPECT_LT(run.report.sums.kinetic, 2500 * gravity * 1e-3);
        } else {
            EXPECT_FALSE(outcome.ok() && run.report.sums.kinetic < 2500 * gravity);
        }
    }
}

}  // namespace
}  // namespace riprap::solid::explicit_dda
