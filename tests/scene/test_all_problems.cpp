// SPDX-License-Identifier: Apache-2.0
// Problems of unlike kinds come in one go, and none that is only the shadow of another.
#include "scene/case_fixture.hpp"

namespace riprap::scene {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::UnorderedElementsAre;

/// A flume with a piston at its left end and two blocks on its floor.
const std::string flume = R"(dimension = 2
gravity = [0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e6
friction_coefficient = 0.3
[[body]]
name = "floor"
material = "rock"
shape = { half_space = { normal = [0.0, 1.0] } }
fixed = true
[[body]]
name = "paddle"
material = "rock"
shape = { box = [0.2, 1.0] }
position = [-0.1, 0.5]
motion = { wave_maker = { wave = "regular", height = 0.05, period = 1.5, depth = 0.5 } }
[[body]]
name = "low"
material = "rock"
shape = { box = [0.4, 0.4] }
position = [1.5, 0.2]
[[body]]
name = "high"
material = "rock"
shape = { box = [0.4, 0.4] }
position = [1.5, 0.61]
[fluid]
spacing = 0.05
domain = { low = [-0.2, -0.2], high = [2.5, 1.5] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [2.0, 0.5] }
[[output.gauge]]
name = "level"
kind = "level"
point = [0.5, 0.0]
[[output.gauge]]
name = "pressure"
kind = "pressure"
point = [0.5, 0.1]
[[expect]]
name = "the paddle moves"
quantity = "paddle.position.x"
low = -1.0
high = 1.0
citation = "a test"
[[expect]]
name = "the blocks stay"
quantity = "high.position.y"
low = 0.0
high = 1.0
citation = "a test"
)";

TEST(AllProblems, the_case_they_are_made_of_has_none) { EXPECT_THAT(test::problems_of(flume), ElementsAre()); }

TEST(AllProblems, a_breaking_wave_a_second_gauge_an_overlap_and_an_unknown_quantity_come_in_one_go) {
    std::string text = test::with(flume, "height = 0.05", "height = 0.45");
    text = test::with(text, "name = \"pressure\"", "name = \"level\"");
    text = test::with(text, "0.61", "0.55");
    text = test::with(text, "high.position.y", "high.positon.y");
    EXPECT_THAT(
        test::problems_of(text),
        UnorderedElementsAre(HasSubstr("a wave 0.45 m high and 2.826 m long in 0.5 m of water breaks"),
                             HasSubstr("a second record 'level'"), HasSubstr("'high' starts 0.05 m deep in 'low'"),
                             AllOf(HasSubstr("there is no quantity 'high.positon.y'"), HasSubstr("positi"))));
}

TEST(AllProblems, errors_that_follow_from_a_missing_body_or_record_are_not_reported) {
    // 'paddle' and its position exist but for the wave; a probe of a body with a problem has its column in no table
    // yet.
    std::string text = test::with(flume, "height = 0.05", "height = 0.45") +
                       "[[output.probe]]\nname = \"stroke\"\nbody = \"paddle\"\nquantity = \"displacement\"\n";
    text = test::with(text, "high.position.y", "stroke.x");
    EXPECT_THAT(test::problems_of(text), ElementsAre(HasSubstr("breaks")));
}

TEST(AllProblems, water_without_room_does_not_hide_a_gauge_that_is_wrong) {
    std::string text = test::with(flume, "high = [2.0, 0.5]", "high = [2.0, 0.01]");
    text = test::with(text, "point = [0.5, 0.1]", "point = [9.0, 0.1]");
    EXPECT_THAT(test::problems_of(text), UnorderedElementsAre(HasSubstr("no particle of water fits into this region"),
                                                              HasSubstr("(9, 0.1, 0) m is outside the domain")));
}

TEST(AllProblems, the_error_says_what_could_not_be_looked_at) {
    const auto unseen = [](const std::string& text) {
        try {
            test::read(text);
        } catch (const PartlySeenCaseError& error) {
            return error.unseen();
        }
        return std::string("nothing is wrong");
    };
    EXPECT_THAT(unseen("end = "), HasSubstr("keys"));
    EXPECT_THAT(unseen(test::with(flume, "end = 1.0", "end = \"1 kg\"")),
                AllOf(HasSubstr("bodies"), Not(HasSubstr("keys"))));
    EXPECT_THAT(unseen(test::with(flume, "0.61", "0.55")), testing::StrEq("the time step"));
    EXPECT_THAT(unseen(test::with(flume, "height = 0.05", "height = 0.45")), HasSubstr("bodies of these problems"));
}

}  // namespace
}  // namespace riprap::scene
