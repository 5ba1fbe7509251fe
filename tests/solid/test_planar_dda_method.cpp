// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

#include "riprap/core/parallel.hpp"
#include "riprap/solid/planar_dda/outline.hpp"
#include "riprap/solid/planar_dda/planar_dda.hpp"
#include "solid/body_scene.hpp"

namespace riprap::solid {
namespace {

using geometry::Point2;

/// A floor and three squares that fall on it.
struct Scene : MovedScene<PlanarDda> {
    Scene() : MovedScene(0.1) {
        bodies.is_planar = true;
        gravity = {{0.5, -9.81, 0}};
        const ShapeId square = add_prism(std::array<Point2, 4>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
        add({}, shapes.add_half_space({0, 1, 0}, 0), body::Drive::fixed);
        for (int i = 0; i < 3; ++i) {
            add({{0.1 * i, 0.501 + 1.001 * i, 0}, {}}, square);
        }
    }
    /// Adds a body of parts that follow each other along x.
    void add_row(const Vec3& place, const std::vector<ShapeId>& shapes_in_row, double apart) {
        std::vector<body::Part> parts;
        for (std::size_t p = 0; p < shapes_in_row.size(); ++p) {
            parts.push_back({BodyId{}, shapes_in_row[p], Pose{{apart * static_cast<double>(p), 0, 0}, {}}});
        }
        add({place, {}}, parts);
    }
};

TEST(PlanarDdaMethod, momentum_follows_the_impulses_it_reports) {
    Scene scene;
    SolidReport last = scene.step(1e-3);
    for (int i = 0; i < 100; ++i) {
        const SolidReport report = scene.step(1e-3);
        const Vec3 gained = report.kick.momentum - last.kick.momentum;
        ASSERT_LT(norm(gained - report.kick.impulse), 1e-8 * norm(report.kick.impulse)) << i;
        last = report;
    }
    EXPECT_GT(last.contact_count, 0);
}

TEST(PlanarDdaMethod, energy_goes_where_the_report_says_numerical_damping_included) {
    Scene scene;
    const auto stored = [](const SolidReport& r) { return r.kick.kinetic + r.kick.potential + r.elastic + r.own[0]; };
    const SolidReport first = scene.step(1e-3);
    double lost = 0, done = 0, damped = 0;
    SolidReport last;
    for (int i = 0; i < 200; ++i) {
        last = scene.step(1e-3);
        lost += last.friction_loss + last.damping_loss + std::accumulate(last.own.begin() + 1, last.own.end(), 0.0);
        damped += last.own[2];
        done += last.kick.external_work + last.kick.work_driven;
    }
    EXPECT_GT(damped, 0.1);
    EXPECT_LT(std::abs(stored(last) + lost - done - stored(first)), 1e-7 * lost);
}

TEST(PlanarDdaMethod, bodies_are_written_as_turned_and_stretched_images_of_their_shapes) {
    Scene scene;
    for (int i = 0; i < 60; ++i) {
        scene.step(1e-3);
    }
    ASSERT_TRUE(scene.state.deforms());
    for (std::int32_t b = 1; b < 4; ++b) {
        const auto i = static_cast<std::size_t>(b);
        const Vec3 here =
            scene.state.position[i] + rotate(scene.state.orientation[i], scene.state.stretch[i] * Vec3{0.5, 0.5, 0});
        const geometry::Vec2 there = place_of(scene.fields.blocks, b, {0.5, 0.5});
        EXPECT_LT(std::abs(here.x - there.x) + std::abs(here.y - there.y), 1e-12);
        EXPECT_NE(scene.state.stretch[i].yy, 1);
        EXPECT_LT(std::abs(scene.state.stretch[i].yy - 1), 1e-2);
    }
}

TEST(PlanarDdaMethod, pull_strains_a_body) {
    Scene scene;
    scene.gravity.value = {};
    const std::vector<Vec3> none(4);
    std::vector<Sym3> pull(4);
    pull[3].xx = 1e5;
    for (int i = 0; i < 20; ++i) {
        scene.step(1e-3, {none, none, pull});
    }
    EXPECT_GT(scene.state.stretch[3].xx, 1 + 1e-4);
    EXPECT_EQ(scene.state.stretch[2].xx, 1);
}

TEST(PlanarDdaMethod, a_plane_carries_a_block_far_from_where_the_scene_began) {
    Scene scene;
    scene.state.position[3].x = 80;
    scene.state.position[3].y = 0.5;
    for (int i = 0; i < 400; ++i) {
        scene.step(2e-3);
    }
    EXPECT_NEAR(scene.state.position[3].y, 0.5, 0.01);
    EXPECT_NEAR(scene.scratch.loads.force[3].y, 2000 * 9.81, 2000);
}

TEST(PlanarDdaMethod, parts_that_share_whole_edges_are_one_concave_block) {
    Scene scene;
    const ShapeId square = scene.add_prism(std::array<Point2, 4>{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
    const ShapeId slope = scene.add_prism(std::array<Point2, 3>{{{0, 0}, {1, 0}, {0, 1}}});
    scene.add_row({0, 9, 0}, {square, square, square}, 1);
    scene.add_row({0, 20, 0}, {square, slope}, 3);
    EXPECT_EQ(planar_dda::outline_of(scene.scene(), BodyId{4}).size(), 8U);  // straight corners stay
    const auto problems = PlanarDda::problems_of(scene.scene(), scene.settings, scene.state);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].body, BodyId{5});
    EXPECT_THAT(problems[0].message, testing::HasSubstr("its parts do not make one polygon"));
}

TEST(PlanarDdaMethod, a_scene_in_space_is_refused) {
    Scene scene;
    scene.bodies.is_planar = false;
    const auto problems = PlanarDda::problems_of(scene.scene(), scene.settings, scene.state);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].allowed, "dimension = 2");
}

TEST(PlanarDdaMethod, a_step_that_does_not_settle_names_the_pair_and_changes_nothing) {
    Scene scene;
    scene.materials.pairs[0].damping_ratio = 0;  // an impact is not refused for itself
    scene.settings.engine.max_iterations = 1;
    scene.settings.engine.friction_tolerance = 0;
    for (int i = 0; i < 3; ++i) {
        scene.state.velocity[static_cast<std::size_t>(i) + 1] = {0, i == 1 ? 8.0 : -8.0, 0};
        scene.state.angular_momentum[static_cast<std::size_t>(i) + 1] = {0, 0, i == 1 ? 3000.0 : -2000.0};
    }
    Outcome outcome;
    for (int i = 0; i < 300 && outcome.ok(); ++i) {
        const std::uint64_t before = hash_fields(scene.state) ^ hash_fields(scene.fields);
        SolidReport report;
        outcome = scene.advance(1e-2, report);
        scene.time += 1e-2;
        if (!outcome.ok()) {
            EXPECT_EQ(hash_fields(scene.state) ^ hash_fields(scene.fields), before);
        }
    }
    ASSERT_FALSE(outcome.ok());
    EXPECT_GT(outcome.shorten, 0);
    EXPECT_LT(outcome.shorten, 1);
    EXPECT_THAT(outcome.problem, testing::HasSubstr("block["));
}

TEST(PlanarDdaMethod, an_impact_is_refused_with_its_pair_and_changes_nothing) {
    Scene scene;
    scene.state.velocity[1] = {0, -2, 0};
    scene.step(1e-9);
    const std::uint64_t before = hash_fields(scene.state) ^ hash_fields(scene.fields);
    SolidReport report;
    const Outcome outcome = scene.advance(1e-2, report);
    EXPECT_THAT(outcome.problem, testing::HasSubstr("meet too fast"));
    EXPECT_THAT(outcome.problem, testing::HasSubstr("block[1]"));
    EXPECT_EQ(outcome.shorten, 0.5);
    EXPECT_EQ(hash_fields(scene.state) ^ hash_fields(scene.fields), before);
}

TEST(PlanarDdaMethod, a_contact_too_stiff_for_the_finest_pieces_is_taken_as_it_is) {
    Scene scene;
    scene.settings.elasticity.contact_stiffness = 1e13;
    scene.state.position[1].y = 0.5 + 1e-6;
    scene.state.velocity[1] = {0, -2, 0};
    SolidReport report;
    EXPECT_GT(scene.advance(1e-3 / 32, report).shorten, 0);
    EXPECT_EQ(scene.advance(1e-3 / 64, report).problem, "");
}

TEST(PlanarDdaMethod, a_released_block_brings_its_energy_along) {
    Scene scene;
    scene.bodies.drive[3] = body::Drive::fixed;
    scene.bodies.release_time[3] = 0.01;
    const double held = 2000 * 9.81 * scene.state.position[3].y - 2000 * 0.5 * scene.state.position[3].x;
    double brought = 0, mass = 0;
    for (int i = 0; i < 20; ++i) {
        const SolidReport report = scene.step(1e-3);
        brought += report.kick.released_energy;
        mass = report.kick.mass;
    }
    EXPECT_NEAR(brought, held, 1e-6 * held);
    EXPECT_NEAR(mass, 6000, 1e-6);
}

TEST(PlanarDdaMethod, the_same_bits_at_any_thread_count_and_from_a_fresh_scratch) {
    const auto hash_after = [](int threads, bool drop) {
        const int before = parallel::thread_count();
        parallel::set_thread_count(threads);
        Scene scene;
        for (int i = 0; i < 60; ++i) {
            scene.step(1e-3);
            if (drop && i == 40) {
                scene.scratch = PlanarDda::Scratch();
            }
        }
        parallel::set_thread_count(before);
        return hash_fields(scene.state) ^ hash_fields(scene.fields);
    };
    const std::uint64_t one = hash_after(1, false);
    EXPECT_EQ(hash_after(2, false), one);
    EXPECT_EQ(hash_after(4, false), one);
    EXPECT_EQ(hash_after(1, true), one);
}

}  // namespace
}  // namespace riprap::solid
