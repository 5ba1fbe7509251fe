// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/core/error.hpp"
#include "riprap/run/study/matrix.hpp"
#include "riprap/run/study/method_scales.hpp"
#include "riprap/run/study/missing_physics.hpp"
#include "riprap/scene/text/toml_reader.hpp"

namespace riprap::run {
namespace {

const MatrixEntry& entry_of(const MatrixResult& result, std::string_view solid, std::string_view variation = "") {
    for (const MatrixEntry& entry : result.entries) {
        if (entry.solid == solid && entry.variation == variation) {
            return entry;
        }
    }
    throw InternalError("there is no such entry");
}

MatrixResult matrix_of(const std::string& scene, std::vector<std::string> overrides) {
    MatrixOptions options;
    options.case_path = scene;
    options.overrides = std::move(overrides);
    return run_matrix(options);
}

// An answer that is due after the end left nothing to compare.
TEST(Matrix, shows_the_quantity_at_the_end_where_its_answer_is_not_due_yet) {
    const MatrixResult result =
        matrix_of("cases/hello_block/case.toml", {"end=0.1", "expect.0.reduce=\"at\"", "expect.0.at=0.5"});
    const MatrixEntry& first = result.entries.front();
    const double way = 0.5 * (4.905 - 8.496 * std::tan(20 * M_PI / 180)) * 0.1 * 0.1;  // [m]
    EXPECT_EQ(first.quantity, "block.displacement.x");
    EXPECT_EQ(first.finding, Finding::unjudged);
    EXPECT_EQ(first.why, "1 of 1 answers not judged: due after the end at 0.1 s");
    EXPECT_NEAR(first.value, way, 0.05 * way);
}

TEST(Matrix, finds_nothing_right_in_answers_that_are_only_told) {
    const MatrixResult result =
        matrix_of("cases/sliding_block/case.toml", {"end=0.1",
                                                    "expect=[{ name = \"it\", quantity = \"time\", reduce = \"max\", "
                                                    "to = 0.1, reported = true, citation = \"none\" }]"});
    EXPECT_EQ(result.entries.front().finding, Finding::unjudged);
    EXPECT_EQ(result.entries.front().why, "");
}

// Cells outside the band of the case were listed as "ran".
TEST(Matrix, judges_the_expected_answers_in_every_cell) {
    // With a window of its own: one that goes on to the end of the file would not be due yet.
    const std::vector<std::string> overrides{"end=0.1", "expect.0.reduce=\"max\"", "expect.0.to=0.1",
                                             "expect.0.value=0.0092", "expect.0.relative_tolerance=0.6"};
    const MatrixResult good = matrix_of("cases/sliding_block/case.toml", overrides);
    for (const MatrixEntry& entry : good.entries) {
        EXPECT_EQ(entry.finding, Finding::right) << entry.solid << ": " << entry.why;
    }
    const MatrixResult bad =
        matrix_of("cases/sliding_block/case.toml", {"end=0.1", "expect.0.reduce=\"max\"", "expect.0.to=0.1",
                                                    "expect.0.value=0.05", "expect.0.relative_tolerance=0.05"});
    for (const MatrixEntry& entry : bad.entries) {
        EXPECT_EQ(entry.finding, Finding::wrong);
        EXPECT_THAT(entry.why, ::testing::HasSubstr("slid down the plane: 0.0"));
    }
}

TEST(Matrix, runs_every_value_of_vary_with_the_answer_that_is_expected_there) {
    const MatrixResult result = matrix_of("cases/sliding_block/case.toml",
                                          {"end=0.1", "expect.0.reduce=\"max\"", "expect.0.to=0.1",
                                           "expect.0.value=0.0092", "expect.0.relative_tolerance=0.05",
                                           "vary=[{ key = \"gravity.0\", values = [9.81], expect = [{ name = \"slid "
                                           "down the plane\", values = [0.0337] }] }]"});
    ASSERT_EQ(result.entries.size(), 10U);
    for (const char* solid : {"distance_potential_dem", "planar_dda"}) {
        const MatrixEntry& entry = entry_of(result, solid, "gravity.0 = 9.81");
        EXPECT_EQ(entry.finding, Finding::right) << entry.why;
        EXPECT_NEAR(entry.value, 0.0337, 0.0337 * 0.05);  // (9.81 - 8.496 tan 20) 0.1^2/2
    }
}

TEST(Matrix, refuses_a_pair_for_physics_that_it_lacks_and_names_it) {
    const MatrixResult in_space = matrix_of("cases/hello_block/case.toml", {"end=0.01"});
    EXPECT_EQ(entry_of(in_space, "planar_dda").finding, Finding::refused);
    EXPECT_EQ(entry_of(in_space, "planar_dda").why, "plane only");
    EXPECT_NE(entry_of(in_space, "implicit_dda").finding, Finding::refused);
    const MatrixResult locked =
        matrix_of("cases/sliding_block/case.toml", {"end=0.01", "body.block.locked=[\"rotation\"]"});
    EXPECT_EQ(entry_of(locked, "planar_dda").why, "no locks");
    EXPECT_NE(entry_of(locked, "sphere_dem").finding, Finding::refused);
}

// Refusing is no cure: only a physics that is missing is a reason.
TEST(Matrix, calls_a_refusal_wrong_where_no_physics_is_missing) {
    const MatrixResult result = matrix_of("cases/sliding_block/case.toml",
                                          {"end=0.01", "solid.method=\"planar_dda\"", "solid.contact_stiffness=1e9"});
    EXPECT_NE(entry_of(result, "planar_dda").finding, Finding::refused);
    const MatrixEntry& entry = entry_of(result, "sphere_dem");  // has no such key
    EXPECT_EQ(entry.finding, Finding::wrong);
    EXPECT_THAT(entry.why, ::testing::StartsWith("refused: "));
}

TEST(MissingPhysics, is_found_by_trying_the_smallest_case_with_it) {
    std::vector<Diagnostic> problems;
    const scene::Value root = scene::parse_toml(
        "dimension = 2\n[[bolt]]\n[[expect]]\nneeds = [\"moving_water\", \"bonds\"]\n", "a case", problems);
    ASSERT_TRUE(problems.empty());
    EXPECT_THAT(missing_physics(root, "planar_dda", "hydrostatic"), ::testing::ElementsAre("water at rest"));
    EXPECT_THAT(missing_physics(root, "planar_dda", "grid"), ::testing::IsEmpty());
    EXPECT_THAT(missing_physics(root, "sphere_dem", "sph"), ::testing::ElementsAre("no bolts", "no bonds"));
    const scene::Value ring = scene::parse_toml(
        "dimension = 2\n[fluid]\ndomain = { periodic = [true, false] }\n[[body]]\nshape = { union = [] }\n", "a case",
        problems);
    EXPECT_THAT(missing_physics(ring, "planar_dda", "grid"), ::testing::ElementsAre("no periodic domain"));
    EXPECT_THAT(missing_physics(ring, "explicit_dda", "sph"), ::testing::ElementsAre("no bodies of several parts"));
}

// A flow was tried through a box and a wall_pressure away from every face, so all fluids seemed to lack both.
TEST(MissingPhysics, of_gauges_is_what_the_fluid_does_not_read) {
    std::vector<Diagnostic> problems;
    const scene::Value root = scene::parse_toml(
        "dimension = 2\n[[output.gauge]]\nkind = \"flow\"\n[[output.gauge]]\nkind = \"wall_pressure\"\n"
        "[[output.gauge]]\nkind = \"level\"\n",
        "a case", problems);
    for (const char* fluid : {"sph", "wcmps", "mps", "grid", "none"}) {
        EXPECT_THAT(missing_physics(root, "planar_dda", fluid), ::testing::IsEmpty()) << fluid;
    }
    EXPECT_THAT(missing_physics(root, "planar_dda", "hydrostatic"),
                ::testing::ElementsAre("no gauge 'flow'", "no gauge 'wall_pressure'"));
}

TEST(MethodScales, quarter_and_quadruple_the_step_and_the_stiffness_that_the_case_has) {
    const auto runs = method_scales("[solid]\nstep = 0.001\ncontact_stiffness = 1e8\n[material.rock]\ndensity = 1.0\n",
                                    "planar_dda", {});
    ASSERT_EQ(runs.size(), 4U);
    EXPECT_EQ(runs[0].label, "step x 1/4");
    EXPECT_THAT(runs[0].overrides, ::testing::ElementsAre("solid.step=0.00025"));
    EXPECT_THAT(runs[3].overrides, ::testing::ElementsAre("solid.contact_stiffness=400000000.0"));
    solid::ImplicitDdaSettings left;
    left.step = 2e-3;
    left.elasticity.contact_stiffness = 3e6;
    const auto left_runs =
        method_scales("[solid]\nstep = \"auto\"\ncontact_stiffness = \"auto\"\n[material.rock]\ndensity = 1.0\n",
                      "implicit_dda", left);
    ASSERT_EQ(left_runs.size(), 4U);
    EXPECT_THAT(left_runs[1].overrides, ::testing::ElementsAre("solid.step=0.008"));
    EXPECT_THAT(left_runs[2].overrides, ::testing::ElementsAre("solid.contact_stiffness=750000.0"));
    const auto explicit_runs = method_scales(
        "time_step_factor = 0.5\n[solid]\n[material.rock]\nnormal_stiffness = 1e6\n", "distance_potential_dem", {});
    ASSERT_EQ(explicit_runs.size(), 4U);
    EXPECT_THAT(explicit_runs[1].overrides, ::testing::ElementsAre("time_step_factor=1.0"));  // no share is above 1
    EXPECT_THAT(explicit_runs[2].overrides, ::testing::ElementsAre("material.rock.normal_stiffness=250000.0"));
}

}  // namespace
}  // namespace riprap::run
