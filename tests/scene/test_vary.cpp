// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/scene/assemble/variations.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/scene/text/toml_reader.hpp"

namespace riprap::scene {
namespace {

constexpr const char* block = R"(dimension = 2
gravity = [0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[[body]]
name = "block"
shape = { box = [1.0, 1.0] }
material = "rock"
[[expect]]
name = "fall"
quantity = "block.displacement.y"
value = -4.905
tolerance = 0.01
citation = "g t^2/2"
)";

std::string problem_of(const std::string& more) {
    try {
        read_case_text(block + more, "case.toml", "/nonexistent");
    } catch (const CaseError& error) {
        return to_string(error.problems().front());
    }
    return "";
}

std::vector<Variation> runs_of(const std::string& more) {
    std::vector<Diagnostic> problems;
    return variations_of(
        parse_toml(read_case_text(block + more, "case.toml", "/nonexistent").resolved_toml, "case", problems));
}

TEST(Vary, gives_a_run_for_each_value_with_the_answer_expected_there) {
    const auto runs = runs_of(
        "[[vary]]\nkey = \"gravity.1\"\nvalues = [-1.0, -2.0]\n[[vary.expect]]\nname = \"fall\"\nvalues = [-0.5, "
        "-1.0]\n");
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[1].label, "gravity.1 = -2");
    EXPECT_THAT(runs[1].overrides, ::testing::ElementsAre("gravity.1=-2", "expect.0.value=-1.0"));
}

TEST(Vary, changes_several_keys_together_by_rows) {
    const auto runs =
        runs_of("[[vary]]\nname = \"elsewhere\"\nkey = [\"gravity.0\", \"gravity.1\"]\nrows = [[1.0, 2.0]]\n");
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_EQ(runs[0].label, "elsewhere");
    EXPECT_THAT(runs[0].overrides, ::testing::ElementsAre("gravity.0=1", "gravity.1=2"));
}

TEST(Vary, changes_a_word_and_a_count_and_a_tolerance) {
    const auto words = runs_of("[[vary]]\nkey = \"solid.method\"\nwords = [\"sphere_dem\", \"planar_dda\"]\n");
    ASSERT_EQ(words.size(), 2U);
    EXPECT_EQ(words[1].label, "solid.method = planar_dda");
    EXPECT_THAT(words[1].overrides, ::testing::ElementsAre("solid.method=\"planar_dda\""));
    const auto seeds = runs_of(
        "[[vary]]\nkey = \"seed\"\nvalues = [7, 8]\n[[vary.expect]]\nname = \"fall\"\nvalues = [-4.9, -4.9]\n"
        "tolerances = [0.1, 0.2]\n");
    EXPECT_THAT(seeds.at(1).overrides,
                ::testing::ElementsAre("seed=8", "expect.0.value=-4.9", "expect.0.tolerance=0.2"));
    EXPECT_THAT(problem_of("[[vary]]\nkey = \"solid.method\"\nwords = [\"plain_dda\"]\n"),
                ::testing::HasSubstr("case.toml:18:7: solid.method = plain_dda"));
    EXPECT_THAT(problem_of("[[vary]]\nkey = \"seed\"\nvalues = [7]\n[[vary.expect]]\nname = \"fall\"\nvalues = "
                           "[-4.9]\ntolerances = [0.1, 0.2]\n"),
                ::testing::HasSubstr("2 expected tolerances for 1 runs"));
}

TEST(Vary, refuses_ratios_and_orders_of_what_the_case_lacks) {
    const std::string vary = "[[vary]]\nkey = \"end\"\nvalues = [0.5, 0.25]\n";
    const std::string band = "low = 0.0\nhigh = 1.0\ncitation = \"none\"\n";
    EXPECT_EQ(problem_of(vary + "[[vary.ratio]]\nname = \"fall\"\n" + band), "");
    EXPECT_THAT(problem_of(vary + "[[vary.ratio]]\nname = \"fell\"\n" + band),
                ::testing::HasSubstr("case.toml:21:8: there is no [[expect]] 'fell'"));
    EXPECT_THAT(problem_of("[[vary]]\nkey = \"end\"\nvalues = [0.5]\n[[vary.order]]\nname = \"fall\"\n" + band),
                ::testing::HasSubstr("two numbers of the key or more"));
    EXPECT_THAT(problem_of("[[vary]]\nkey = \"solid.method\"\nwords = [\"sphere_dem\", \"planar_dda\"]\n"
                           "[[vary.order]]\nname = \"fall\"\n" +
                           band),
                ::testing::HasSubstr("two numbers of the key or more"));
    EXPECT_THAT(problem_of("[[expect]]\nname = \"time\"\nquantity = \"time\"\nreported = true\ncitation = \"none\"\n" +
                           vary + "[[vary.order]]\nname = \"time\"\n" + band),
                ::testing::HasSubstr("gives no 'value' that could be approached"));
}

TEST(Vary, marks_runs_of_the_long_version) {
    const auto runs =
        runs_of("[[vary]]\nkey = \"end\"\nvalues = [2.0]\n[[vary]]\nkey = \"end\"\nvalues = [60.0]\nfull = true\n");
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_FALSE(runs[0].is_full);
    EXPECT_TRUE(runs[1].is_full);
}

TEST(Vary, refuses_a_key_that_the_case_does_not_have_with_its_place) {
    EXPECT_THAT(problem_of("[[vary]]\nkey = \"body.block.colour\"\nvalues = [1.0]\n"),
                ::testing::StartsWith("case.toml:18:7: body.block.colour = 1: unknown key 'colour'"));
    EXPECT_THAT(problem_of("[[vary]]\nkey = \"body.stone.density\"\nvalues = [1.0]\n"),
                ::testing::HasSubstr("no entry 'stone'"));
    EXPECT_THAT(problem_of("[[vary]]\nkey = \"body.block.density\"\nvalues = [-1.0]\n"),
                ::testing::HasSubstr("density = -1"));
}

TEST(Vary, refuses_a_key_that_stands_twice) {
    EXPECT_THAT(problem_of("[[vary]]\nkey = [\"gravity.1\", \"gravity.1\"]\nrows = [[-1.0, -2.0]]\n"),
                ::testing::StartsWith("case.toml:18:7: a key stands twice"));
    for (const std::string keys : {"\"end\", \"end_ms\"", "\"body.0.position.1\", \"body.block.position.1\""}) {
        EXPECT_THAT(problem_of("[[vary]]\nkey = [" + keys + "]\nrows = [[1.0, 2.0]]\n"),
                    ::testing::StartsWith("case.toml:18:7: a key stands twice"))
            << keys;
    }
}

TEST(Vary, refuses_answers_that_are_none_of_the_case_or_not_as_many_as_the_values) {
    const std::string vary = "[[vary]]\nkey = \"gravity.1\"\nvalues = [-1.0, -2.0]\n[[vary.expect]]\n";
    EXPECT_THAT(problem_of(vary + "name = \"fal\"\nvalues = [1.0, 2.0]\n"),
                ::testing::HasSubstr("did you mean 'fall'?"));
    EXPECT_THAT(problem_of(vary + "name = \"fall\"\nvalues = [1.0]\n"),
                ::testing::HasSubstr("1 expected values for 2 runs"));
    EXPECT_THAT(problem_of("[[vary]]\nkey = [\"gravity.0\", \"gravity.1\"]\nrows = [[1.0]]\n"),
                ::testing::HasSubstr("a row of 1 values for 2 keys"));
}

// Answers at a shorter end that a [[vary]] gives were taken for those of a run that was cut, and not judged.
TEST(Vary, makes_answers_due_at_the_ends_that_it_lists) {
    const std::string text =
        std::string(block) +
        "[[vary]]\nkey = \"end\"\nvalues = [0.5]\n[[vary.expect]]\nname = \"fall\"\nvalues = [-1.22625]\n";
    const auto due = [&text](const std::string& end) {
        const std::vector<std::string> overrides{end};
        return read_case_text(text, "case.toml", "/nonexistent", overrides).model.expects.at(0).to;
    };
    EXPECT_TRUE(std::isinf(due("end=0.5")));
    EXPECT_EQ(due("end=0.4"), 1);
}

TEST(Needs, refuse_methods_without_the_physics_and_name_those_with_it) {
    const auto problem = [](const std::string& overrides) {
        try {
            const std::vector<std::string> words{overrides, "expect.0.needs=[\"bonds\"]"};
            read_case_text(block, "case.toml", "/nonexistent", words);
        } catch (const CaseError& error) {
            return to_string(error.problems().front());
        }
        return std::string();
    };
    EXPECT_THAT(problem("solid.method=\"sphere_dem\""), ::testing::HasSubstr("needs bonds"));
    EXPECT_THAT(problem("solid.method=\"sphere_dem\""), ::testing::HasSubstr("planar_dda"));
    EXPECT_EQ(problem("solid.method=\"planar_dda\""), "");
}

}  // namespace
}  // namespace riprap::scene
