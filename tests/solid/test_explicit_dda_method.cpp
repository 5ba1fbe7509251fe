// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/solid/explicit_dda/explicit_dda.hpp"
#include "solid/body_scene.hpp"

namespace riprap::solid {
namespace {

using Scene = FallingCubes<ExplicitDda>;

TEST(ExplicitDdaMethod, momentum_follows_the_impulses_it_reports) {
    Scene scene;
    SolidReport last = scene.step(1e-4);
    for (int i = 0; i < 800; ++i) {
        const SolidReport report = scene.step(1e-4);
        // Momenta are those of mid-step: half of either impulse lies between two of them.
        const Vec3 gained = report.kick.momentum - last.kick.momentum;
        const Vec3 given = 0.5 * (report.kick.impulse + last.kick.impulse);
        ASSERT_LT(norm(gained - given), 1e-8) << i;
        last = report;
    }
    EXPECT_GT(last.contact_count, 0);
}

TEST(ExplicitDdaMethod, bodies_are_written_as_turned_and_stretched_images_of_their_shapes) {
    Scene scene;
    for (int i = 0; i < 400; ++i) {
        scene.step(1e-4);
    }
    ASSERT_TRUE(scene.state.deforms());
    for (std::size_t b = 1; b < 4; ++b) {
        const Vec3 corner{0.5, 0.5, 0.5};
        const Vec3 here = scene.state.position[b] + rotate(scene.state.orientation[b], scene.state.stretch[b] * corner);
        const Vec3 there =
            scene.fields.blocks.position[b] + affine::rows_at(scene.fields.blocks.deformation, b) * corner;
        EXPECT_LT(norm(here - there), 1e-12);
        EXPECT_LT(std::abs(scene.state.stretch[b].zz - 1), 1e-2);
    }
}

TEST(ExplicitDdaMethod, pull_strains_a_body) {
    Scene scene;
    scene.gravity.value = {};
    const std::vector<Vec3> none(4);
    std::vector<Sym3> pull(4);
    pull[3].xx = 1e5;
    for (int i = 0; i < 20; ++i) {
        scene.step(1e-4, {none, none, pull});
    }
    EXPECT_GT(scene.state.stretch[3].xx, 1 + 1e-4);
    EXPECT_EQ(scene.state.stretch[2].xx, 1);
}

TEST(ExplicitDdaMethod, a_block_that_is_torn_apart_is_named) {
    Scene scene;
    const std::vector<Vec3> none(4);
    std::vector<Sym3> pull(4);
    pull[3].xx = 1e12;
    Outcome outcome;
    for (int i = 0; i < 100 && outcome.ok(); ++i) {
        SolidReport report;
        outcome = scene.advance(1e-4, report, {none, none, pull});
    }
    EXPECT_EQ(outcome.problem.rfind("'block[3]' is strained to ", 0), 0U) << outcome.problem;
    EXPECT_GT(outcome.shorten, 0);
}

TEST(ExplicitDdaMethod, the_same_bits_with_two_threads_and_from_a_fresh_scratch) {
    const auto hash_after = [](int threads, bool drop) {
        const int before = parallel::thread_count();
        parallel::set_thread_count(threads);
        Scene scene;
        for (int i = 0; i < 300; ++i) {
            scene.step(1e-4);
            if (drop && i == 150) {
                scene.scratch = ExplicitDda::Scratch();
            }
        }
        parallel::set_thread_count(before);
        return hash_fields(scene.state) ^ hash_fields(scene.fields);
    };
    const std::uint64_t one = hash_after(1, false);
    EXPECT_EQ(hash_after(2, false), one);
    EXPECT_EQ(hash_after(1, true), one);
}

}  // namespace
}  // namespace riprap::solid
