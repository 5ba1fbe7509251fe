// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "riprap/core/parallel.hpp"
#include "riprap/core/quat.hpp"
#include "riprap/solid/affine/bonds.hpp"
#include "riprap/solid/affine/step_update.hpp"
#include "riprap/solid/implicit_dda/advance.hpp"
#include "solid/block_scene.hpp"

namespace riprap::solid::implicit_dda {
namespace {

using affine::rows_at;

constexpr double gravity = 9.81, degree = std::numbers::pi / 180;

/// A scene under way.
struct Trial {
    affine::BlockScene system;
    Settings settings{};
    State state{};
    Scratch scratch;
    StepReport report{};
    affine::BlockLoads external{};
    double dt{1e-2};

    void step(int count = 1) {
        for (int i = 0; i < count; ++i) {
            StepReport all;
            const Outcome outcome = in_pieces(dt, [&](double piece) {
                const Outcome taken = advance(system, settings, piece, external, state, scratch, report);
                all.friction_loss += taken.ok() ? report.friction_loss : 0;
                all.numerical_loss += taken.ok() ? report.numerical_loss : 0;
                all.lost_energy += taken.ok() ? report.lost_energy : 0;
                return taken;
            });
            ASSERT_EQ(outcome.problem, "");
            report.friction_loss = all.friction_loss;
            report.numerical_loss = all.numerical_loss;
            report.lost_energy = all.lost_energy;
        }
    }
    void rock(double youngs_modulus, const affine::Surface& surface) {
        set_material(system, {2500, youngs_modulus, 0.25}, surface);
    }
    void ground() { add_half_space(system, state.blocks, {0, 0, 1}, 0); }
    double energy() const { return report.sums.kinetic + report.sums.potential + report.strain + report.contact; }
};

TEST(ImplicitDda, constant_forces_are_exact_at_any_step) {
    for (const double dt : {0.1, 0.01, 0.001}) {
        Trial run;
        run.rock(5e10, {});
        run.system.gravity = {0, 0, -gravity};
        run.settings.max_displacement = 10;
        add_box(run.system, run.state.blocks, {1, 2, 3}, {});
        run.dt = dt;
        run.step(static_cast<int>(std::lround(1 / dt)));
        EXPECT_NEAR(run.state.blocks.position[0].z, -0.5 * gravity, 1e-11);
        EXPECT_NEAR(run.state.blocks.velocity[0].z, -gravity, 1e-11);
    }
}

TEST(ImplicitDda, a_tumbling_block_keeps_volume_and_angular_momentum) {
    Trial run;
    run.rock(5e10, {});
    run.settings.max_displacement = 10;
    add_box(run.system, run.state.blocks, {1, 2, 3}, {.spin = {0.2, 2 * std::numbers::pi, 0.1}});
    run.dt = 1e-3;
    const Vec3 momentum = measure(run.system, run.state.blocks).angular_momentum;
    run.step(1000);
    EXPECT_NEAR(determinant(rows_at(run.state.blocks.deformation, 0)), 1, 1e-10);
    EXPECT_LT(norm(measure(run.system, run.state.blocks).angular_momentum - momentum) / norm(momentum), 1e-10);
}

/// Largest change of the kinetic energy of a slab that tumbles about its middle axis, over its first value [-].
double tumbling_error(double dt, double time) {
    Trial run;
    run.rock(5e10, {});
    run.settings.max_displacement = 10;
    const Mat3 askew = to_matrix(from_rotation_vector({0.3, 0.2, 0.6}));
    add_box(run.system, run.state.blocks, {4, 2, 1}, {.deformation = askew, .spin = askew * Vec3{0.1, 3, 0.05}});
    run.dt = dt;
    const double before = measure(run.system, run.state.blocks).kinetic;
    double worst = 0;
    for (double t = 0; t < time; t += dt) {
        run.step();
        worst = std::max(worst, std::abs(run.report.sums.kinetic / before - 1));
    }
    return worst;
}

TEST(ImplicitDda, a_tumbling_slab_keeps_its_energy_to_the_square_of_the_step) {
    // Turned about the axis of the start of each step, it won 5 % in ten seconds at steps of 5 ms.
    const double coarse = tumbling_error(0.02, 42), fine = tumbling_error(0.01, 42);  // twenty turns
    EXPECT_LT(coarse, 1e-3);
    EXPECT_NEAR(coarse / fine, 4, 0.5);
}

TEST(ImplicitDda, a_torque_gives_its_angular_momentum) {
    Trial run;
    run.rock(5e10, {});
    add_box(run.system, run.state.blocks, {1, 2, 3}, {});
    const std::vector<Vec3> torque{{300, -200, 500}};
    run.external.torque = torque;
    run.dt = 1e-3;
    run.step(50);
    const Vec3 gained = measure(run.system, run.state.blocks).angular_momentum;
    EXPECT_LT(norm(gained - 50 * run.dt * torque[0]), 1e-9 * norm(gained));
}

TEST(ImplicitDda, a_static_pull_gives_the_stress_and_strain_of_hookes_law_in_one_step) {
    Trial run;
    run.rock(1e9, {});
    run.settings.dynamic = 0;
    add_box(run.system, run.state.blocks, {1, 2, 3}, {});
    const Mat3 stress{{{1e5, 2e4, 0}, {2e4, -3e4, 1e4}, {0, 1e4, 5e4}}};
    const std::vector<Mat3> pull{6 * stress};
    run.external.pull = pull;
    run.dt = 1e3;  // inertia 2 J/dt^2 is nothing beside the stiffness
    run.step();
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            EXPECT_NEAR(rows_at(run.state.blocks.stress, 0)(i, j), stress(i, j), 1e-6);
        }
    }
}

TEST(ImplicitDda, a_block_whose_stiffness_is_singular_is_named) {
    // In so long a step inertia is lost, and the second block turns about the one point that holds it.
    for (const Solver solver : {Solver::pcg_jacobi, Solver::sor}) {
        Trial run;
        run.rock(1e9, {1e7, 1e7});
        run.ground();
        add_box(run.system, run.state.blocks, {1, 1, 1}, {.position = {0, 0, 0.499}});
        add_box(run.system, run.state.blocks, {1, 1, 1}, {.position = {9, 0, 9}});
        run.system.fixed_points = {{BodyId{2}, {0.5, 0.5, 0.5}, {9.5, 0.5, 9.5}, 1e9}};
        run.settings.solve.solver = solver;
        run.dt = 1e12;
        const State before = run.state;
        const Outcome outcome = advance(run.system, run.settings, run.dt, {}, run.state, run.scratch, run.report);
        EXPECT_EQ(outcome.problem, "the stiffness of block 2 is singular");
        EXPECT_EQ(run.report.singular, 2);
        EXPECT_TRUE(run.state == before);
    }
}

TEST(ImplicitDda, a_block_settles_to_the_overlap_of_its_weight) {
    Trial run;
    run.rock(1e9, {1e7, 1e7});
    run.system.gravity = {0, 0, -gravity};
    run.ground();
    add_box(run.system, run.state.blocks, {1, 1, 1}, {.position = {0, 0, 0.501}});
    run.settings.dynamic = 0;
    run.step(40);
    EXPECT_EQ(run.report.contact_count, 4);
    EXPECT_NEAR(run.report.deepest, 2500 * gravity / 4e7, 1e-9);
}

TEST(ImplicitDda, a_face_with_stiffness_per_area_sinks_in_by_its_pressure_over_that) {
    for (const double side : {1.0, 2.0}) {
        Trial run;
        run.rock(1e12, {1e7, 1e7, true});
        run.system.gravity = {0, 0, -gravity};
        run.ground();
        add_box(run.system, run.state.blocks, {side, side, 1}, {.position = {0, 0, 0.501}});
        run.settings.dynamic = 0;
        run.step(150);
        EXPECT_NEAR(run.report.deepest, 2500 * gravity / 1e7, 1e-8);
    }
}

TEST(ImplicitDda, a_corner_with_stiffness_per_area_counts_for_the_least_area) {
    Trial run;
    affine::Surface surface{1e9, 1e9, true};
    surface.least_area = 1e-2;
    run.rock(1e12, surface);
    run.system.gravity = {0, 0, -gravity};
    run.ground();
    // a box on one edge, its centre above it: balanced
    const double c = std::sqrt(0.5);
    const Mat3 turn{{{c, 0, c}, {0, 1, 0}, {-c, 0, c}}};
    add_box(run.system, run.state.blocks, {1, 1, 1}, {.position = {0, 0, std::sqrt(0.5)}, .deformation = turn});
    run.settings.dynamic = 0;
    run.step(100);
    EXPECT_EQ(run.report.contact_count, 2);
    EXPECT_NEAR(run.report.deepest, 2500 * gravity / (2 * 1e7), 1e-6);
}

/// Block on a plane with gravity tilted by `slope`, at the overlap of its weight.
Trial incline(double slope, double friction, double dt) {
    Trial run;
    run.rock(3e9, {1e8, 1e8, false, friction});
    run.system.gravity = gravity * Vec3{std::sin(slope), 0, -std::cos(slope)};
    run.ground();
    add_box(run.system, run.state.blocks, {1, 1, 1},
            {.position = {0, 0, 0.5 - 2500 * gravity * std::cos(slope) / 4e8}});
    run.settings.max_displacement = 10;
    run.dt = dt;
    return run;
}

TEST(ImplicitDda, a_block_on_a_slope_slides_by_coulomb) {
    for (const double angle : {0.0, 10.0, 20.0}) {
        const double friction = std::tan(angle * degree);
        Trial run = incline(30 * degree, friction, 0.01);
        run.step(20);
        const double before = run.state.blocks.velocity[1].x;
        run.step(80);
        const double a = gravity * (std::sin(30 * degree) - std::cos(30 * degree) * friction);
        EXPECT_NEAR((run.state.blocks.velocity[1].x - before) / 0.8, a, 1e-3 * a) << angle;
    }
}

TEST(ImplicitDda, contacts_whose_friction_has_not_settled_are_counted) {
    // The block bounces in its springs as it slides, so that the push, and friction with it, changes in every step.
    for (const int rounds : {1, 60}) {
        Trial run = incline(0.5, 0.3, 2e-3);
        run.settings.open_close = 60;
        run.step(5);
        EXPECT_EQ(run.report.sliding_count, 4);
        run.state.blocks.position[1].z -= 1e-5;
        run.settings.open_close = rounds;
        std::int64_t open = 0;
        for (int i = 0; i < 5; ++i) {
            run.step();
            open += run.report.open_frictions;
        }
        EXPECT_EQ(open > 0, rounds == 1) << open;
    }
}

TEST(ImplicitDda, a_block_steeper_than_its_slope_stays_and_does_not_creep) {
    Trial run = incline(30 * degree, std::tan(35 * degree), 0.01);
    run.step(50);
    const double before = run.state.blocks.position[1].x;
    run.step(200);
    EXPECT_NEAR(run.state.blocks.position[1].x, before, 1e-9);
}

TEST(ImplicitDda, cohesion_holds_a_block_without_friction_until_it_breaks) {
    const double driving = 2500 * gravity * std::sin(30 * degree);  // on 1 m^2
    for (const double factor : {0.9, 1.1}) {
        Trial run = incline(30 * degree, 0, 0.01);
        run.system.surfaces.pairs[0].cohesion = driving * factor;
        run.state.contacts.bonded = bonded_pairs(run.system, run.state.blocks);
        run.settings.dynamic = 0;
        run.step(30);
        run.settings.dynamic = 1;
        run.step(50);
        EXPECT_EQ(run.state.blocks.position[1].x > 0.1, factor < 1) << factor;
    }
}

TEST(ImplicitDda, a_block_that_comes_to_lie_on_a_slope_is_not_bonded_to_it) {
    Trial run = incline(30 * degree, 0, 0.01);
    run.system.surfaces.pairs[0].cohesion = 1e9;
    run.state.blocks.position[1].z += 0.1;
    run.state.contacts.bonded = bonded_pairs(run.system, run.state.blocks);
    run.step(100);
    EXPECT_GT(run.state.blocks.position[1].x, 2);
}

TEST(ImplicitDda, a_bond_that_was_torn_does_not_hold_when_the_faces_meet_again) {
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
        EXPECT_EQ(run.state.contacts.bonded.size(), 1U);
        run.settings.dynamic = 0;
        run.settings.max_displacement = 10;
        run.step(20);
        const bool holds = factor > 1;
        EXPECT_EQ(run.state.contacts.bonded.size(), holds ? 1U : 0U);
        EXPECT_EQ(run.state.blocks.position[0].z > -0.005, holds);
        run.system.gravity = {0, 0, gravity};  // back to the roof, then hanging again
        run.step(200);
        EXPECT_GT(run.state.blocks.position[0].z, -0.005);
        run.system.gravity = {0, 0, -gravity};
        run.step(20);
        EXPECT_EQ(run.state.blocks.position[0].z > -0.005, holds);
    }
}

TEST(ImplicitDda, a_fixed_point_holds_its_block) {
    Trial run;
    run.rock(1e9, {});
    run.system.gravity = {0, 0, -gravity};
    add_box(run.system, run.state.blocks, {1, 1, 1}, {});
    for (const Vec3& corner :
         {Vec3{0.5, 0.5, 0.5}, Vec3{-0.5, 0.5, 0.5}, Vec3{0.5, -0.5, 0.5}, Vec3{-0.5, -0.5, 0.5}}) {
        run.system.fixed_points.push_back({BodyId{0}, corner, corner, 1e10});
    }
    run.settings.dynamic = 0;
    run.step(30);
    // Hung from its top face, the single stress is the mean of weight below: half of rho g h.
    EXPECT_NEAR(run.state.blocks.stress[2].z, 0.5 * 2500 * gravity, 1);
    EXPECT_LT(std::abs(run.state.blocks.position[0].z), 1e-4);
}

/// A wall of blocks that lean on each other, started with random speeds.
Trial heap() {
    Trial run;
    run.rock(1e8, {1e7, 5e6, false, 0.4});
    run.system.gravity = {0, 0, -gravity};
    run.ground();
    for (int i = 0; i < 12; ++i) {
        add_box(run.system, run.state.blocks, {1, 0.9, 0.5},
                {.position = {1.01 * (i % 3) + 0.3 * (i / 3 % 2), 0, 0.251 + 0.502 * (i / 3)},
                 .velocity = {0.1 * std::sin(i), 0, 0}});
    }
    run.dt = 2e-3;
    return run;
}

TEST(ImplicitDda, all_solvers_agree) {
    std::vector<Vec3> first;
    for (const Solver solver : {Solver::pcg_jacobi, Solver::pcg_cholesky, Solver::sor}) {
        Trial run = heap();
        run.settings.solve = {solver, 1e-12, 20000};
        run.step(10);
        if (first.empty()) {
            first = run.state.blocks.position;
        }
        for (std::size_t b = 0; b < first.size(); ++b) {
            EXPECT_LT(norm(run.state.blocks.position[b] - first[b]), 1e-8);
        }
    }
}

TEST(ImplicitDda, the_energy_ledger_closes_with_the_loss_of_the_integrator) {
    Trial run = heap();
    run.step(1);
    const double before = run.energy();
    double lost = 0, turned_over = 0;
    for (int i = 0; i < 300; ++i) {
        run.step();
        lost += run.report.friction_loss + run.report.numerical_loss + run.report.lost_energy;
        turned_over = std::max(turned_over, std::abs(run.report.sums.potential));
    }
    // Turning blocks exactly after a linear step moves energy by the square of the angle.
    EXPECT_NEAR(run.energy() + lost - before, 0, 2e-4 * turned_over);
    EXPECT_GT(lost, 0);
}

TEST(ImplicitDda, momentum_of_an_impact_is_kept) {
    Trial run;
    run.rock(1e9, {1e7, 5e6, false, 0.5});
    const auto turned = [](const Vec3& w) { return to_matrix(from_rotation_vector(w)); };
    add_box(run.system, run.state.blocks, {1, 0.8, 0.6},
            {.deformation = turned({0.2, 0.3, 0.1}), .velocity = {1, 0, 0}});
    add_box(run.system, run.state.blocks, {0.7, 1, 0.9},
            {.position = {1.15, 0.3, 0.2}, .deformation = turned({-0.4, 0.1, 0.5}), .velocity = {-1, 0.1, 0}});
    run.dt = 1e-4;
    run.settings.solve.tolerance = 1e-12;
    const affine::BlockSums before = measure(run.system, run.state.blocks);
    bool has_touched = false;
    for (int i = 0; i < 1500; ++i) {
        run.step();
        has_touched = has_touched || run.report.contact_count > 0;
    }
    const affine::BlockSums after = measure(run.system, run.state.blocks);
    EXPECT_TRUE(has_touched);
    EXPECT_LT(norm(after.momentum - before.momentum), 1e-6);  // the solver's tolerance, of 1e3 kg m/s
    EXPECT_LT(norm(after.angular_momentum - before.angular_momentum), 1e-2 * norm(before.angular_momentum));
}

TEST(ImplicitDda, a_step_that_is_refused_changes_nothing_and_shorter_pieces_get_through) {
    Trial run;
    run.rock(1e9, {1e7, 1e7});
    run.system.gravity = {0, 0, -gravity};
    run.settings.max_displacement = 0.01;
    add_box(run.system, run.state.blocks, {1, 1, 1}, {.velocity = {0, 0, -1}});
    const State before = run.state;
    const Outcome refused = advance(run.system, run.settings, 0.1, {}, run.state, run.scratch, run.report);
    EXPECT_FALSE(refused.ok());
    EXPECT_GT(refused.shorten, 0);
    EXPECT_EQ(run.state, before);
    run.dt = 0.1;
    run.step();
    EXPECT_NEAR(run.state.blocks.position[0].z, -0.1 - 0.5 * gravity * 0.01, 1e-12);
}

TEST(ImplicitDda, the_same_bits_with_any_number_of_threads_and_from_a_fresh_scratch) {
    const auto hash_after = [](int threads, bool drop_scratch) {
        const int before = parallel::thread_count();
        parallel::set_thread_count(threads);
        Trial run = heap();
        run.step(10);
        if (drop_scratch) {
            run.scratch = Scratch();
        }
        run.step(10);
        parallel::set_thread_count(before);
        return hash_fields(run.state);
    };
    const std::uint64_t one = hash_after(1, false);
    EXPECT_EQ(hash_after(2, false), one);
    EXPECT_EQ(hash_after(4, true), one);
}

TEST(ImplicitDda, newmark_damps_an_oscillator_by_the_factor_of_its_step) {
    // A block on four fixed-point springs: amplitude per step (1 + (w dt)^2/2)^(-1/2).
    Trial run;
    run.rock(1e12, {});
    const double mass = 2500, k = 4e6, w = std::sqrt(k / mass);
    add_box(run.system, run.state.blocks, {1, 1, 1}, {.position = {0, 0, 0.01}});
    for (const Vec3& corner : {Vec3{0.5, 0.5, 0}, Vec3{-0.5, 0.5, 0}, Vec3{0.5, -0.5, 0}, Vec3{-0.5, -0.5, 0}}) {
        run.system.fixed_points.push_back({BodyId{0}, corner, corner, k / 4});
    }
    run.dt = 0.05 / w;
    const auto amplitude_squared = [&] {
        const double x = run.state.blocks.position[0].z, v = run.state.blocks.velocity[0].z;
        return x * x + v * v / (w * w);
    };
    run.step(1);
    const double before = amplitude_squared(), energy = run.energy();
    double lost = 0;
    for (int i = 0; i < 400; ++i) {
        run.step();
        lost += run.report.numerical_loss;
    }
    const double factor = std::pow(1 + 0.5 * 0.05 * 0.05, -400);
    EXPECT_NEAR(amplitude_squared() / before / factor, 1, 0.05);
    EXPECT_NEAR(run.energy() + lost, energy, 1e-9 * energy);  // and the books say what went
}

}  // namespace
}  // namespace riprap::solid::implicit_dda
