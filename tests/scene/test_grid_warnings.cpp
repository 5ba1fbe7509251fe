// SPDX-License-Identifier: Apache-2.0
// Warnings about water on cells, as for particles.
#include <fmt/format.h>

#include "case_fixture.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A planar flume with cells of 5 cm, a paddle whose face is at x = `face`, and water of a depth.
std::string flume(double depth, double face, double depth_of_maker, const std::string& more = "") {
    return fmt::format(R"(dimension = 2
gravity = [0.0, -9.81]
end = 0.02
[material.rock]
density = 2500.0
normal_stiffness = 1.0e8
[fluid]
method = "grid"
spacing = 0.05
domain = {{ low = [-0.5, -0.5], high = [2.5, 1.5] }}
[[fluid.region]]
box = {{ low = [0.0, 0.0], high = [2.0, {}] }}
[[body]]
name = "floor"
shape = {{ box = [2.4, 0.2] }}
position = [1, -0.1]
material = "rock"
fixed = true
[[body]]
name = "paddle"
shape = {{ box = [0.2, 1.4] }}
position = [{}, 0.6]
material = "rock"
motion = {{ wave_maker = {{ wave = "regular", height = 0.02, period = 1, depth = {} }} }}
[[body]]
name = "end"
shape = {{ box = [0.2, 1.4] }}
position = [2.1, 0.6]
material = "rock"
fixed = true
)",
                       depth, face - 0.1, depth_of_maker) +
           more;
}

TEST(GridWarnings, water_of_three_cells_is_shallow_and_water_of_four_is_not) {
    for (const double depth : {0.1, 0.15, 0.19}) {
        EXPECT_THAT(read(flume(depth, 0, depth)).warnings, Contains(HasSubstr("cells deep"))) << depth;
    }
    EXPECT_THAT(read(flume(0.15, 0, 0.15)).warnings,
                Contains(AllOf(HasSubstr("case.toml:11:1: the water is 3 cells deep"),
                               HasSubstr("fluid.spacing of 0.015 m makes it ten cells"))));
    EXPECT_THAT(read(flume(0.15, 0, 0.15), {"fluid.spacing=0.015"}).warnings, Not(Contains(HasSubstr("cells deep"))));
    for (const double depth : {0.2, 0.3, 0.5}) {
        EXPECT_THAT(read(flume(depth, 0, depth)).warnings, IsEmpty()) << depth;
    }
}

TEST(GridWarnings, a_wet_floor_beside_deep_water_is_not_shallow_and_one_apart_from_it_is) {
    const auto floor = [](double begin) {
        return fmt::format("[[fluid.region]]\nbox = {{ low = [{}, 0.0], high = [1.6, 0.1] }}\n", begin);
    };
    const auto with_floor = [&](const std::string& more) {
        std::string text = flume(0.5, 0, 0.5, more);
        const std::size_t box = text.find("[[fluid.region]]"), end = text.find(']', text.find("high = [", box));
        const std::size_t begin = text.find("high = [", box);
        text.replace(begin, end - begin, "high = [1.0, 0.5");
        return text;
    };
    EXPECT_THAT(read(with_floor("")).warnings, Not(Contains(HasSubstr("cells deep"))));
    EXPECT_THAT(read(with_floor(floor(1.0))).warnings, Not(Contains(HasSubstr("cells deep"))));
    EXPECT_THAT(
        read(with_floor(floor(1.0) + "[[fluid.region]]\nbox = { low = [1.6, 0.0], high = [1.9, 0.1] }\n")).warnings,
        Not(Contains(HasSubstr("cells deep"))));  // which meets the column by the floor
    EXPECT_THAT(read(with_floor(floor(1.2))).warnings, Contains(HasSubstr("the water is 2 cells deep")));
}

TEST(GridWarnings, a_paddle_off_the_water_or_for_another_depth_is_told) {
    EXPECT_THAT(read(flume(0.5, -0.04, 0.5)).warnings, IsEmpty());
    for (const double face : {-0.1, -0.2, -0.3}) {
        EXPECT_THAT(read(flume(0.5, face, 0.5)).warnings,
                    ElementsAre(AllOf(HasSubstr("case.toml:24:"), HasSubstr("no water touches the face"))))
            << face;
    }
    for (const double depth : {0.3, 0.42, 0.7}) {
        EXPECT_THAT(read(flume(0.5, 0, depth)).warnings,
                    ElementsAre(HasSubstr(fmt::format("has depth = {} m, but water stands 0.5 m deep", depth))));
    }
}

TEST(WavesOutOfRange, are_called_short_or_long_as_they_are) {
    for (const char* period : {"1e-300", "1e-9", "0.01"}) {
        EXPECT_THAT(problems_of(with(flume(0.5, 0, 0.5), "period = 1,", std::string("period = ") + period + ",")),
                    Contains(HasSubstr("too short for a paddle")))
            << period;
    }
    for (const char* period : {"1e300", "1e9"}) {
        EXPECT_THAT(problems_of(with(flume(0.5, 0, 0.5), "period = 1,", std::string("period = ") + period + ",")),
                    Contains(HasSubstr("too long for a paddle")))
            << period;
    }
}

TEST(GridWarnings, gauges_along_lines_that_begin_in_a_body_are_told) {
    const auto gauge = [](const std::string& kind, const std::string& point, const std::string& end) {
        return "[[output.gauge]]\nname = \"g\"\nkind = \"" + kind + "\"\npoint = " + point + "\nend = " + end + "\n";
    };
    const auto warnings = [&](const std::string& kind, const std::string& point, const std::string& end) {
        return read(flume(0.5, 0, 0.5, gauge(kind, point, end))).warnings;
    };
    EXPECT_THAT(warnings("surface", "[1, -0.15]", "[1, 1]"),
                ElementsAre(HasSubstr("the line of the surface gauge 'g' begins inside 'floor' at the start")));
    EXPECT_THAT(warnings("surface", "[2.1, 0.2]", "[0.5, 0.2]"), ElementsAre(HasSubstr("begins inside 'end'")));
    EXPECT_THAT(warnings("surface", "[1, 0]", "[1, 1]"), IsEmpty());
    EXPECT_THAT(
        warnings("run_up", "[1, 0.2]", "[2.2, 0.2]"),
        ElementsAre(HasSubstr("the run_up gauge 'g' meets 'end' at the start, and reads no farther than there")));
    EXPECT_THAT(warnings("run_up", "[1, 0.2]", "[1.9, 0.8]"), IsEmpty());
}

}  // namespace
}  // namespace riprap::scene
