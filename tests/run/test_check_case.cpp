// SPDX-License-Identifier: Apache-2.0
// Report of `riprap check` for cases with water.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/run/check/check_case.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/advance.hpp"

namespace riprap::run {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A tank half a metre wide with 0.205 m of water at a spacing of 1 cm: half a row stays empty.
const std::string tank = R"(dimension = 2
gravity = [0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e6
friction_coefficient = 0.3
[[body]]
name = "floor"
material = "rock"
shape = { half_space = { normal = [0.0, 1.0], offset = 0.0 } }
fixed = true
[fluid]
spacing = 0.01
domain = { low = [0.0, -0.1], high = [0.5, 0.5], periodic = [true, false] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [0.5, 0.205] }
)";

CaseCheck check_of(const std::string& text) {
    return check_case(scene::read_case_text(text, "case.toml", "/nonexistent", {}));
}

TEST(CheckCase, volume_that_stays_empty_has_a_unit) {
    EXPECT_NEAR(check_of(tank).trimmed_volume, 0, 1e-12);  // the last layer is filled to the level
    const std::string wide = "high = [0.5, 0.205]";
    std::string narrow = tank;
    narrow.replace(narrow.find(wide), wide.size(), "high = [0.495, 0.2]");
    const CaseCheck check = check_of(narrow);
    EXPECT_NEAR(check.trimmed_volume, 0.005 * 0.2, 1e-12);
    EXPECT_NEAR(check.narrow_volume, 0.005 * 0.2, 1e-12);
    EXPECT_THAT(check_text(check), HasSubstr("98 kg/m, "));
    EXPECT_THAT(check_text(check),
                HasSubstr("0.001 m^2 (1 %) of the room outside of solids is too narrow for particles"));
}

TEST(CheckCase, contacts_that_were_not_tried_have_no_number) {
    CaseCheck check = check_of(tank);
    EXPECT_THAT(check_json(check), HasSubstr("\"contacts\": 0,"));
    check.is_tried = false;
    for (const char* key : {"contacts", "max_overlap", "max_potential"}) {
        EXPECT_THAT(check_json(check), HasSubstr(fmt::format("\"{}\": null", key)));
    }
}

TEST(CheckCase, the_face_of_a_gauge_is_reported) {
    const CaseCheck check = check_of(tank +
                                     "[[output.gauge]]\nname = \"transducer\"\nkind = \"wall_pressure\"\n"
                                     "point = [0.25, 0.001]\n[[output.gauge]]\nname = \"level\"\nkind = \"level\"\n"
                                     "point = [0.25, 0.0]\n");
    EXPECT_THAT(check_text(check), HasSubstr("  gauge         transducer in the face of floor towards (0, 1, 0)\n"));
    EXPECT_THAT(check_json(check), HasSubstr("\"gauge\": \"transducer\""));
}

/// Two blocks on the floor, the left one held, with a gap between them and under the right one [spacings].
std::string blocks(double beside, double under) {
    const auto block = [](const char* name, double x, double y, const char* more) {
        return fmt::format(
            "[[body]]\nname = \"{}\"\nmaterial = \"rock\"\nshape = {{ box = [0.1, 0.1] }}\nposition = [{}, {}]\n{}",
            name, x, y, more);
    };
    return tank + block("left", 0.15, 0.05, "fixed = true\n") +
           block("right", 0.25 + 0.01 * beside, 0.05 + 0.01 * under, "");
}

TEST(CheckCase, gaps_that_are_neither_joints_nor_hold_particles_are_counted) {
    const CaseCheck check = check_of(blocks(0.5, 1.5));
    EXPECT_EQ(check.gaps.pairs, 2);
    EXPECT_THAT(check_text(check), HasSubstr("  gaps          'floor' and 'right' and 1 more pair are 0.5 to 1.5"));
    EXPECT_EQ(check_of(blocks(0, 0)).gaps.pairs, 0);
    EXPECT_EQ(check_of(blocks(0.25, 2)).gaps.pairs, 0);
    EXPECT_EQ(check_of(blocks(0, 1)).gaps.pairs, 1);
    EXPECT_EQ(check_of(blocks(0.5, 0) + "wet = false\n").gaps.pairs, 0);
}

TEST(CheckCase, steps_of_bodies_within_one_of_the_water_are_told_and_too_many_warned_of) {
    const auto with_block = [](const std::string& stiffness) {
        std::string text = tank + "[[body]]\nname = \"block\"\nmaterial = \"rock\"\nshape = { box = [0.1, 0.1] }\n" +
                           "position = [0.25, 0.05]\n";
        const std::string given = "1.0e6";
        return text.replace(text.find(given), given.size(), stiffness);
    };
    const CaseCheck stiff = check_of(with_block("1.0e9"));
    EXPECT_GT(stiff.substeps, 1);
    EXPECT_LE(stiff.substep * static_cast<double>(stiff.substeps - 1), stiff.time_step);
    EXPECT_THAT(check_text(stiff), HasSubstr(fmt::format("  of bodies     {} steps within one", stiff.substeps)));
    EXPECT_THAT(check_text(stiff), Not(HasSubstr("cost most of the time")));
    const CaseCheck absurd = check_of(with_block("1.0e16"));
    EXPECT_NEAR(static_cast<double>(absurd.substeps) / static_cast<double>(stiff.substeps), std::sqrt(1e7), 600);
    EXPECT_THAT(check_text(absurd), HasSubstr("steps within one of the water (contact stiffness of block"));
    EXPECT_THAT(check_text(absurd), HasSubstr("cost most of the time"));
}

// The step of a driven plate was that of one at rest: an impact of spheres is shorter the faster it is.
TEST(CheckCase, a_driven_body_moves_from_the_start) {
    const auto step_of = [](double speed) {
        return check_of(fmt::format(R"(gravity = [0.0, 0.0, -9.81]
end = 1.0
[solid]
method = "sphere_dem"
[material.rock]
density = 2000.0
youngs_modulus = 1.0e7
poisson_ratio = 0.2
restitution = 0.5
[[body]]
name = "ball"
material = "rock"
shape = {{ sphere = 0.1 }}
[[body]]
name = "plate"
material = "rock"
shape = {{ box = [1.0, 1.0, 0.2] }}
position = [0.0, 0.0, -5.0]
motion = {{ linear = {{ velocity = [0.0, 0.0, {}] }} }}
)",
                                    speed))
            .time_step;
    };
    EXPECT_NEAR(step_of(160) / step_of(5), 0.5, 0.1);  // the duration falls with the fifth root of the speed
}

TEST(CheckCase, numbers_that_differ_between_members_of_an_ensemble_are_told) {
    const CaseCheck check = check_of(tank + "[[spread]]\nkey = \"material.rock.density\"\nlow = 2400\nhigh = 2600\n" +
                                     "[[spread]]\nkey = \"fluid.density\"\nmean = 1000\ndeviation = 5\n");
    EXPECT_THAT(check_text(check), HasSubstr("  ensemble      material.rock.density from 2400 to 2600\n"));
    EXPECT_THAT(check_text(check), HasSubstr("  ensemble      fluid.density 1000 with a deviation of 5\n"));
}

TEST(CheckCase, the_memory_it_reports_is_that_of_a_run_within_a_fifth) {
    const scene::LoadedCase loaded = scene::read_case_text(tank, "case.toml", "/nonexistent", {});
    sim::State state = loaded.state;
    sim::initialise(loaded.model, state);
    sim::Scratch scratch;
    for (int k = 0; k < 50; ++k) {
        ASSERT_TRUE(
            advance(loaded.model, state, scratch, choose_time_step(loaded.model, state, scratch).dt).status.ok());
    }
    const auto run = static_cast<double>(sim::memory_bytes(loaded.model, state, scratch));
    const auto told = static_cast<double>(check_case(loaded).memory_bytes);
    EXPECT_NEAR(told, run, 0.2 * run);
    EXPECT_GT(told / static_cast<double>(loaded.state.fluid.size()), 200);  // bytes per particle: State and lists
}

}  // namespace
}  // namespace riprap::run
