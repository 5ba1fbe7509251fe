// SPDX-License-Identifier: Apache-2.0
// Every cause for which a run ends has a case that ends by it, and that runs to its end with the remedy which it is
// told.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

#include "riprap/run/remedy/end_causes.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

sim::StepStatus end_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
    Simulation simulation(scene::read_case_text(text, "case.toml", ".", overrides));
    while (simulation.steps_left() > 0) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        if (outcome.kind == StepOutcome::Kind::refused) {
            return outcome.why;
        }
    }
    return {};
}

/// The assignments that a remedy names, as `--set` takes them: those joined by "and", of the first way out it tells.
std::vector<std::string> assignments_in(const std::string& remedy) {
    static const std::regex form(R"(([a-z_]+(?:\.[A-Za-z0-9_]+)*) = (\[[^\]]*\]|"[^"]*"|[0-9.e+-]*[0-9]|true|false))");
    std::vector<std::string> found;
    for (std::sregex_iterator at(remedy.begin(), remedy.end(), form), end; at != end; ++at) {
        found.push_back((*at)[1].str() + "=" + (*at)[2].str());
    }
    return found;
}

/// A case that ends by a cause.
struct Ending {
    std::string_view cause;  ///< EndCause::name
    std::string what;        ///< of the scene
    std::string text;
    std::string says;        ///< part of its remedy
    std::string followed{};  ///< the case as one changes it who follows a remedy without values; empty: assignments
};
void PrintTo(const Ending& ending, std::ostream* out) { *out << ending.cause << ": " << ending.what; }

const std::string gravity = "gravity = [0, 0, -9.81]\n", weightless = "gravity = [0, 0, 0]\n";
const std::string plane = "dimension = 2\ngravity = [0, -9.81]\n";

std::string rock(const std::string& stiffness) {
    return "[material.rock]\ndensity = 2500\nfriction_coefficient = 0.5\nnormal_stiffness = " + stiffness + "\n";
}
std::string body(const std::string& name, const std::string& shape, const std::string& more) {
    return "[[body]]\nname = '" + name + "'\nmaterial = 'rock'\nshape = { " + shape + " }\n" + more + "\n";
}
std::string solids(const std::string& method, const std::string& more) {
    return "[solid]\nmethod = '" + method + "'\n" + more + "\n";
}
const std::string ground = body("ground", "half_space = { normal = [0, 0, 1] }", "fixed = true");
std::string falling_cube(const std::string& more = "position = [0, 0, 0.6]") { return body("block", "cube = 1", more); }
std::string bullet(double speed) {
    return body("plate", "box = [1, 1, 0.2]", "fixed = true") +
           body("cube", "cube = 0.1", fmt::format("position = [0, 0, 0.3]\nvelocity = [0, 0, -{}]", speed));
}
std::string planar_bullet(double speed) {
    return body("plate", "box = [1, 0.2]", "fixed = true") +
           body("cube", "box = [0.1, 0.1]", fmt::format("position = [0, 0.3]\nvelocity = [0, -{}]", speed));
}

/// Two blocks with a slot of nine tenths of a disc between them, and the disc that comes down on it.
std::string slot(const std::string& more) {
    return body("left", "box = [2, 1.3]", "position = [-1.054, -0.65]\n" + more) +
           body("right", "box = [2, 1.3]", "position = [1.054, -0.65]\n" + more);
}
std::string disc(double speed) {
    return body("disc", "sphere = 0.06", fmt::format("position = [0, 0.07]\nvelocity = [0, -{}]", speed));
}

/// Water of a planar tank.
std::string water(const std::string& method, const std::string& box, const std::string& more = {},
                  const std::string& domain = "{ low = [-0.2, -0.2], high = [1.2, 1.2] }", double spacing = 0.05) {
    return "[fluid]\nmethod = '" + method + fmt::format("'\nspacing = {}\ndomain = ", spacing) + domain + "\n" + more +
           "\n[[fluid.region]]\nbox = " + box + "\n";
}
std::string tank(double thickness = 0.2, double right = 1) {
    const auto wall = [&](const std::string& name, double x) {
        return body(name, fmt::format("box = [{}, 2]", thickness),
                    fmt::format("position = [{}, 0.8]\nfixed = true", x));
    };
    return body("bottom", fmt::format("box = [3.4, {}]", thickness),
                fmt::format("position = [0.5, {}]\nfixed = true", -thickness / 2)) +
           wall("left", -thickness / 2) + wall("right", right + thickness / 2);
}
std::string lid(const std::string& more, const std::string& box = "box = [1, 0.2]") {
    return body("lid", box, "position = [0.5, 0.65]\nmotion = { linear = { velocity = [0, -1] }" + more + " }");
}
std::string ram(double speed, double thickness) {
    return body("ram", fmt::format("box = [0.9, {}]", thickness),
                fmt::format("position = [0.5, {}]\nmotion = {{ linear = {{ velocity = [0, -{}] }} }}",
                            0.6 + thickness / 2, speed));
}
const std::string half_full = "{ low = [0, 0], high = [1, 0.5] }", column = "{ low = [0, 0], high = [0.4, 0.8] }";
const std::string wide = "{ low = [-3, -3], high = [4, 14] }";

/// A piston that goes up slowly in the water of a tank.
std::string drawn(const std::string& box) {
    return plane + "end = 0.3\n" + rock("1e7") +
           water("grid", "{ low = [0, 0], high = [1, 0.9] }", "", "{ low = [-0.2, -0.2], high = [1.2, 1.6] }") +
           tank() + body("piston", box, "position = [0.5, 0.5]\nmotion = { linear = { velocity = [0, 0.3] } }");
}

std::vector<Ending> endings() {
    return {
        {"deep_contact", "a block on a floor that is too soft",
         gravity + "end = 1\n" + rock("1000") + ground + falling_cube("position = [0, 0, 0.5]"), "normal_stiffness = "},
        {"deep_contact", "a stack of three on such a floor",
         gravity + "end = 0.5\n" + rock("2e4") + ground + falling_cube("position = [0, 0, 0.5]") +
             body("second", "cube = 1", "position = [0, 0, 1.5]") + body("third", "cube = 1", "position = [0, 0, 2.5]"),
         "normal_stiffness = "},
        {"deep_contact", "a slab that comes down on a stack",
         gravity + "end = 1\n" + rock("1e5") + ground + falling_cube("position = [0, 0, 0.5]") +
             body("second", "cube = 1", "position = [0, 0, 1.5]") +
             body("slab", "box = [2, 2, 0.5]", "position = [0, 0, 4.5]"),
         "normal_stiffness = "},
        {"deep_contact", "a cube that comes down on its edge",
         gravity + "end = 1\n" + rock("2e4") + ground +
             falling_cube(
                 "position = [0, 0, 2.5]\norientation = { axis_angle = { axis = [1, 0, 0], angle = 0.785398 } }"),
         "normal_stiffness = "},
        {"squeezed", "a disc in a slot", plane + "end = 0.1\n" + rock("1e6") + slot("fixed = true") + disc(6),
         "normal_stiffness = "},
        {"squeezed", "a disc in a slot, by implicit DDA",
         plane + "end = 0.1\n" + solids("implicit_dda", "contact_stiffness = 1e5") + rock("1e6") +
             slot("fixed = true") + disc(3),
         "solid.contact_stiffness = "},
        {"gone_through", "a cylinder in a slot",
         gravity + "end = 0.1\n" + rock("2e7") +
             body("left", "box = [0.4, 1, 0.1]", "position = [-0.27, 0, 0]\nfixed = true") +
             body("right", "box = [0.4, 1, 0.1]", "position = [0.27, 0, 0]\nfixed = true") +
             body("roller", "cylinder = { radius = 0.09, height = 0.3 }",
                  "position = [0, 0, 0.25]\nvelocity = [0, 0, -12]"),
         "normal_stiffness = "},
        {"deep_contact", "a bullet of implicit DDA",
         weightless + "end = 0.01\n" + solids("implicit_dda", "contact_stiffness = 1e3\nyoungs_modulus = 1e9") +
             rock("1e7") + bullet(30),
         "solid.contact_stiffness = "},
        {"deep_contact", "a bullet of implicit DDA with stiffness per area",
         weightless + "end = 0.01\n" +
             solids("implicit_dda", "contact_stiffness_per_area = 1e6\nyoungs_modulus = 1e9") + rock("1e7") +
             bullet(30),
         "solid.contact_stiffness_per_area = "},
        {"deep_contact", "a bullet of explicit DDA",
         weightless + "end = 0.01\n" + solids("explicit_dda", "contact_stiffness = 1e3\nyoungs_modulus = 1e9") +
             rock("1e7") + bullet(30),
         "solid.contact_stiffness = "},
        {"deep_contact", "a bullet of planar DDA",
         "dimension = 2\ngravity = [0, 0]\nend = 0.01\n" +
             solids("planar_dda", "contact_stiffness = 1e4\nyoungs_modulus = 1e9") + rock("1e7") + planar_bullet(30),
         "solid.contact_stiffness = "},
        {"deep_contact", "a driven lid that leaves no room",
         gravity + "end = 0.15\n" + rock("1e7") + ground + falling_cube("position = [0, 0, 0.5]") +
             body("lid", "half_space = { normal = [0, 0, -1] }",
                  "position = [0, 0, 1.05]\nmotion = { linear = { velocity = [0, 0, -10] } }"),
         "body.lid.motion.stop = "},
        {"deep_potential", "a drop on a floor",
         gravity + "end = 0.3\n[solid]\nmax_potential = 0.01\n" + rock("1e6") + ground + falling_cube(),
         "material.rock.normal_stiffness = "},
        {"deep_spheres", "a ball by Hertz' law",
         gravity + "end = 1\n" + solids("sphere_dem", "youngs_modulus = 1e3") + rock("1e7") + ground +
             body("ball", "sphere = 0.1", "position = [0, 0, 0.5]"),
         "solid.youngs_modulus = "},
        {"deep_spheres", "a plate that jumps by its table",
         plane + "end = 0.12\n" + solids("sphere_dem", "") + rock("1e7") +
             body("floor", "box = [6, 0.5]", "position = [0, -0.25]\nfixed = true") +
             body("plate", "box = [0.2, 0.4]",
                  "position = [-0.5, 0.21]\n"
                  "motion = { table = { time = [0, 0.1, 0.1001], displacement = [[0, 0], [0, 0], [0.3, 0]] } }") +
             body("cube", "box = [0.3, 0.4]", "position = [0, 0.2]"),
         "body.plate.motion.stop = "},
        {"deep_spheres", "a ball on a linear spring",
         gravity + "end = 1\n" + solids("sphere_dem", "normal_law = 'linear'\nspring_stiffness = 100") + rock("1e7") +
             ground + body("ball", "sphere = 0.1", "position = [0, 0, 0.5]"),
         "solid.spring_stiffness = "},
        {"deep_spheres", "a cube of spheres that comes down on its corner",
         gravity + "end = 1\n" + solids("sphere_dem", "youngs_modulus = 2e4") + rock("1e7") + ground +
             falling_cube(
                 "position = [0, 0, 2.5]\norientation = { axis_angle = { axis = [1, -1, 0], angle = 0.9553 } }"),
         "solid.youngs_modulus = "},
        {"unseen", "a bullet that could pass a plate",
         weightless + "end = 0.02\ntime_step = 2e-4\nforce_time_step = true\n" + rock("1e10") +
             body("plate", "box = [1, 1, 0.02]", "fixed = true") +
             body("cube", "cube = 0.1", "position = [0, 0, 1.0]\nvelocity = [0, 0, -300]"),
         "time_step = "},
        {"fast_body", "a speed of the case above max_speed",
         gravity + "end = 0.01\n[solid]\nmax_speed = 5\n" + rock("1e8") + ground +
             falling_cube("position = [0, 0, 3]\nvelocity = [6, 0, 0]"),
         "solid.max_speed = "},
        {"fast_body", "a force that no body has",
         weightless + "end = 0.02\n" + rock("1e8") + falling_cube("load = [{ force = [1e308, 0, 0] }]"), "N or less",
         weightless + "end = 0.02\n" + rock("1e8") + falling_cube("load = [{ force = [1e10, 0, 0] }]")},
        {"fast_body", "a step far above the bound that throws a sphere away",
         gravity + "end = 0.5\ntime_step = 0.01\nforce_time_step = true\n" +
             solids("sphere_dem", "youngs_modulus = 1e9\nmax_speed = 4") + rock("1e7") + ground +
             body("ball", "sphere = 0.1", "position = [0, 0, 0.0999]"),
         "time_step = \"auto\""},
        {"open_and_close", "a block of implicit DDA that comes down turning, with one round",
         gravity + "end = 0.5\n" + solids("implicit_dda", "open_close = 1") + rock("1e8") + ground +
             falling_cube("position = [0, 0, 0.6]\nangular_velocity = [1, 2, 0]"),
         "solid.open_close = "},
        {"strained", "a block of explicit DDA as soft as rubber",
         gravity + "end = 0.1\n" + solids("explicit_dda", "youngs_modulus = 1e5") + rock("1e8") + ground +
             falling_cube("position = [0, 0, 0.6]\nvelocity = [0, 0, -20]"),
         "solid.youngs_modulus = "},
        {"fast_water", "a dam break of wcmps with sound as slow as it",
         plane + "end = 0.3\n" + rock("1e7") +
             water("wcmps", "{ low = [0, 0], high = [0.3, 0.9] }", "sound_speed = 3.0") + tank(),
         "fluid.sound_speed = "},
        {"long_way", "a block of planar DDA that flies a metre in the shortest piece of a step",
         "dimension = 2\ngravity = [0, 0]\nend = 0.01\ntime_step = 0.1\n" + solids("planar_dda", "") + rock("1e8") +
             body("block", "box = [0.1, 0.1]", "velocity = [2000, 0]"),
         "time_step = \"auto\""},
        {"long_way", "the same by implicit DDA",
         weightless + "end = 0.01\ntime_step = 0.1\n" + solids("implicit_dda", "") + rock("1e8") +
             body("block", "cube = 0.1", "velocity = [2000, 0, 0]"),
         "time_step = \"auto\""},
        {"water_above_limit", "a step of the case for the grid that suits still water",
         plane + "end = 0.3\ntime_step = 0.01\n" + rock("1e7") + water("grid", column) + tank(),
         "time_step = \"auto\""},
        {"lost_water", "a tank without a wall",
         plane + "end = 0.42\n" + rock("1e7") + water("sph", column) + tank(0.2, 2), "a wall there",
         plane + "end = 0.42\n" + rock("1e7") + water("sph", column) + tank()},
        {"splash", "a dam break under a low top of sph",
         plane + "end = 0.8\n" + rock("1e7") +
             water("sph", "{ low = [0, 0], high = [0.4, 0.55] }", "", "{ low = [-0.2, -0.2], high = [1.2, 0.6] }") +
             tank(),
         "fluid.domain.high = "},
        {"unsolved_pressure", "two iterations of mps where a column collapses",
         plane + "end = 0.05\n" + rock("1e7") + water("mps", column, "max_iterations = 2\nsmoothing_ratio = 1.05") +
             tank(),
         "fluid.max_iterations = "},
        {"crowded_pocket", "a lid that presses water of sph",
         plane + "end = 0.45\n" + rock("1e7") + water("sph", half_full, "", wide) + tank() + lid(""), "before",
         plane + "end = 0.45\n" + rock("1e7") + water("sph", half_full, "", wide) + tank() + lid(", stop = 0.03")},
        {"pressed_pocket", "a lid that presses water of the grid",
         plane + "end = 0.8\n" + rock("1e7") +
             water("grid", half_full, "", "{ low = [-0.2, -0.2], high = [1.2, 1.6] }") + tank() + lid(""),
         "gap",
         plane + "end = 0.8\n" + rock("1e7") +
             water("grid", half_full, "", "{ low = [-0.2, -0.2], high = [1.2, 1.6] }") + tank() +
             lid("", "box = [0.7, 0.2]")},
        {"drawn_pocket", "a piston that is drawn up in the water of a grid", drawn("box = [1, 0.2]"), "gap",
         drawn("box = [0.7, 0.2]")},
        {"left_water", "a block that sinks in a domain of the grid without a floor",
         plane + "end = 1\n" + rock("1e7") + water("grid", half_full, "", "{ low = [0, 0], high = [1, 0.9] }") +
             body("block", "box = [0.2, 0.15]", "position = [0.5, 0.2]\ndensity = 2500"),
         "fixed = true",
         plane + "end = 1\n" + rock("1e7") + water("grid", half_full, "", "{ low = [0, 0], high = [1, 0.9] }") +
             body("block", "box = [0.2, 0.15]", "position = [0.5, 0.2]\ndensity = 2500") +
             body("floor", "box = [1, 0.2]", "position = [0.5, -0.1]\nfixed = true")},
        {"through_walls", "a plate that is driven into water of sph between plates",
         plane + "end = 0.1\n" + rock("1e7") + water("sph", half_full, "", wide) + tank(0.02) + ram(6, 0.02),
         "thicker walls",
         plane + "end = 0.1\n" + rock("1e7") + water("sph", half_full, "", wide) + tank(0.2) + ram(1, 0.2)},
        {"through_walls", "the same of mps",
         plane + "end = 0.1\n" + rock("1e7") + water("mps", half_full, "", wide) + tank(0.02) + ram(6, 0.02),
         "thicker walls",
         plane + "end = 0.1\n" + rock("1e7") + water("mps", half_full, "", wide) + tank(0.2) + ram(1, 0.2)},
        {"made_energy", "a dam break of sph with sound as slow as it",
         plane + "end = 0.3\n" + rock("1e7") +
             water("sph", "{ low = [0, 0], high = [0.3, 0.9] }", "sound_speed = 3.0") + tank(),
         "fluid.sound_speed = "},
        {"made_energy", "a lid of wcmps that leaves a gap of a spacing to the walls: no step helps",
         plane + "end = 0.28\n" + rock("1e7") + water("wcmps", "{ low = [0, 0], high = [1, 0.5] }", "", wide) +
             tank(0.3) + body("lid", "box = [0.9, 0.2]", "position = [0.5, 0.600001]\ndensity = 300"),
         "fluid.spacing = "},
        {"ledger", "a step far above its bound",
         gravity + "end = 0.3\ntime_step = 0.147\nforce_time_step = true\n" + rock("1e7") + ground + falling_cube(),
         "time_step = \"auto\""},
        {"ledger", "a plate of implicit DDA that comes down faster than its linear elasticity follows",
         weightless + "end = 0.001\n" + solids("implicit_dda", "") + rock("1e7") +
             body("floor", "box = [2, 2, 0.2]", "fixed = true") +
             body("plate", "box = [1, 1, 0.05]", "position = [0, 0, 0.3]\nvelocity = [0, 0, -400]"),
         "solid.youngs_modulus = "},
        {"ledger", "the same in a plane",
         "dimension = 2\ngravity = [0, 0]\nend = 0.001\n" + solids("implicit_dda", "") + rock("1e7") +
             body("floor", "box = [2, 0.2]", "fixed = true") +
             body("plate", "box = [1, 0.05]", "position = [0, 0.3]\nvelocity = [0, -400]"),
         "solid.youngs_modulus = "},
        {"ledger", "a tolerance below what the step gives",
         gravity + "end = 0.3\ntime_step_factor = 1\n[output]\nledger_tolerance = 1e-6\n" + rock("1e7") + ground +
             falling_cube("position = [0, 0, 0.6]\nangular_velocity = [1, 2, 0]"),
         "output.ledger_tolerance = "},
    };
}

class EndCauses : public ::testing::TestWithParam<Ending> {};

TEST_P(EndCauses, TheRemedyThatIsNamedMakesTheRunPass) {
    const Ending& ending = GetParam();
    const sim::StepStatus why = end_of(ending.text);
    const EndCause* const cause = cause_of(why.text);
    ASSERT_NE(cause, nullptr) << why.text;
    EXPECT_EQ(cause->name, ending.cause) << why.text;
    ASSERT_THAT(why.remedy, HasSubstr(ending.says)) << why.text;
    const std::vector<std::string> assignments = assignments_in(why.remedy);
    const sim::StepStatus after = ending.followed.empty() ? end_of(ending.text, assignments) : end_of(ending.followed);
    EXPECT_THAT(after.text, IsEmpty()) << why.remedy;
}

INSTANTIATE_TEST_SUITE_P(OfTheList, EndCauses, ::testing::ValuesIn(endings()),
                         [](const auto& made) { return fmt::format("{}_{}", made.param.cause, made.index); });

TEST(EndCauseList, NamesAStiffnessWithAReserveOfFour) {
    // 2 m g/K, K = A k/r, is 0.75 r: k = 8/3 m g/A.
    const double just = 8.0 / 3 * 2500 * 9.81;
    const auto block = [](double stiffness) {
        return gravity + "end = 1\n[solid]\nsides = 'contactor'\n" + rock(fmt::format("{}", stiffness)) + ground +
               falling_cube("position = [0, 0, 0.5]");
    };
    EXPECT_THAT(end_of(block(0.9 * just)).text, HasSubstr("deep in each other"));
    const std::string named = assignments_in(end_of(block(0.05 * just)).remedy).front();
    const double stiffness = std::stod(named.substr(named.find('=') + 1));
    // Four times, and as much again as the field that was met falls off towards the edges of the foot.
    EXPECT_GT(stiffness, 7 * just);
    EXPECT_LT(stiffness, 13 * just);
}

TEST(EndCauseList, HasACaseForEachRow) {
    const std::vector<Ending> tried = endings();
    for (const EndCause& cause : end_causes()) {
        EXPECT_TRUE(std::ranges::any_of(tried, [&](const Ending& e) { return e.cause == cause.name; })) << cause.name;
    }
}

TEST(EndCauseList, IsThePageInTheRepository) {
    const std::string path = "docs/reference/messages.md";  // tests run in the root of the tree
    if (std::getenv("RIPRAP_WRITE_REFERENCE") != nullptr) {
        std::ofstream(path) << messages_page();
    }
    std::stringstream page;
    page << std::ifstream(path).rdbuf();
    EXPECT_TRUE(page.str() == messages_page()) << "run test_run with RIPRAP_WRITE_REFERENCE=1 and commit " << path;
}

}  // namespace
}  // namespace riprap::run
