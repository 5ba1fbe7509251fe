// SPDX-License-Identifier: Apache-2.0
// What a case may leave out, and what is told where one is run in another way than it was written for.
#include <sstream>

#include "case_fixture.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/time_step.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(WhatACaseMayLeaveOut, water_alone_needs_no_material) {
    const std::string water =
        "dimension = 2\ngravity = [0, -9.81]\nend = 0.1\n[fluid]\nmethod = \"grid\"\nspacing = 0.1\n"
        "[fluid.domain]\nlow = [0, 0]\nhigh = [1, 1]\n"
        "[[fluid.region]]\nshape = { box = [1, 0.5] }\nposition = [0.5, 0.25]\n";
    EXPECT_THAT(problems_of(water), IsEmpty());
    EXPECT_THAT(problems_of(with(minimal_case, "[material.rock]\ndensity = 2500.0\nnormal_stiffness = 1.0e7\n", "")),
                ElementsAre(HasSubstr("there is no material 'rock'; a table [material.rock] with a density")));
}

TEST(WhatACaseMayLeaveOut, a_value_for_another_method_is_warned_of_only_in_the_file_that_chooses_the_method) {
    const std::string text =
        minimal_case + "[solid]\nmethod = \"implicit_dda\"\nyoungs_modulus = 1e9\npoisson_ratio = 0.2\n";
    const auto warnings = [&](const std::string& of, const std::vector<std::string>& overrides) {
        return read(of, overrides).warnings;
    };
    EXPECT_THAT(warnings(text, {}), Contains(HasSubstr("'normal_stiffness' of material 'rock' does nothing here")));
    EXPECT_THAT(warnings(minimal_case,
                         {"solid.method=\"implicit_dda\"", "solid.youngs_modulus=1e9", "solid.poisson_ratio=0.2"}),
                Not(Contains(HasSubstr("normal_stiffness"))));
}

TEST(WhatACaseMayLeaveOut, a_list_of_one_quantity_is_that_quantity) {
    const auto names = [](const std::string& probe) {
        std::vector<std::string> found;
        for (const sim::Probe& p :
             read(minimal_case + "[[output.probe]]\nbody = \"block\"\n" + probe).model.output.probes) {
            found.push_back(p.name);
        }
        return found;
    };
    EXPECT_THAT(names("name = \"crest\"\nquantity = [\"speed\"]\n"), ElementsAre("crest"));
    EXPECT_THAT(names("name = \"crest\"\nquantity = \"speed\"\n"), ElementsAre("crest"));
    EXPECT_THAT(names("quantity = [\"speed\"]\n"), ElementsAre("block.speed"));
    EXPECT_THAT(names("name = \"crest\"\nquantity = [\"speed\", \"position\"]\n"),
                ElementsAre("crest.speed", "crest.position"));
}

TEST(ARunThatIsCut, does_not_judge_what_is_expected_at_its_last_step) {
    const std::string text = minimal_case + R"([[expect]]
name = "falls"
quantity = "block.displacement.z"
value = -4.905
tolerance = 0.01
citation = "g t^2/2"
)";
    EXPECT_THAT(read(text).warnings, IsEmpty());
    EXPECT_EQ(read(text).model.expects[0].to, std::numeric_limits<double>::infinity());
    const LoadedCase cut = read(text, {"end=0.5"});
    EXPECT_EQ(cut.model.expects[0].to, 1);  // later than the end: not judged
    EXPECT_THAT(cut.warnings, Contains(HasSubstr("[[expect]] 'falls' is not judged: the run ends at 0.5 s, before")));
    EXPECT_EQ(read(text, {"end=\"500 ms\""}).model.expects[0].to, 1);
    EXPECT_EQ(read(text, {"end=2"}).model.expects[0].to, std::numeric_limits<double>::infinity());
}

TEST(ARunThatIsCut, judges_no_window_that_goes_on_to_its_end) {
    const auto due = [](const std::string& reduce, const std::string& end) {
        return read(minimal_case + "[[expect]]\nname = \"falls\"\nquantity = \"block.displacement.z\"\n" + reduce +
                        "\nvalue = -4.905\ntolerance = 0.01\ncitation = \"g t^2/2\"\n",
                    {"end=" + end})
            .model.expects[0]
            .to;
    };
    for (const char* const reduce :
         {"reduce = \"min\"", "reduce = \"max\"", "reduce = \"mean\"", "reduce = \"extreme\"",
          "reduce = \"mean\"\nfrom = 0.2", "reduce = \"last\"\nfrom = 0.1",
          "reduce = \"when\"\nwhen = \"solid.kinetic\"\nreaches = 100.0"}) {
        EXPECT_EQ(due(reduce, "0.5"), 1) << reduce;
        EXPECT_EQ(due(reduce, "1"), std::numeric_limits<double>::infinity()) << reduce;
        EXPECT_EQ(due(reduce, "3"), std::numeric_limits<double>::infinity()) << reduce;
    }
    EXPECT_EQ(due("reduce = \"max\"\nto = 0.4", "0.5"), 0.4);  // over before the cut: judged
    EXPECT_EQ(due("reduce = \"when\"\nwhen = \"solid.kinetic\"\nreaches = 1.0\nto = 0.4", "1"), 0.4);
}

TEST(ARunOfNoStep, is_refused_where_the_step_is_fixed_and_takes_one_step_where_it_is_not) {
    EXPECT_THAT(problems_of(with(minimal_case, "end =", "time_step = 1e-3\nend ="), {"end=1e-14"}),
                ElementsAre(HasSubstr("a run to 1e-14 s takes no step of time_step = 0.001 s; an end of at least "
                                      "time_step")));
    EXPECT_THAT(problems_of(with(minimal_case, "end =", "time_step = 1e-3\nend ="), {"end=1e-3"}), IsEmpty());
    for (const char* const slow :
         {"end=1e-14", "end=1e-200", "material.rock.normal_stiffness=1e-40", "material.rock.density=1e60"}) {
        LoadedCase loaded = read(minimal_case, {slow});
        sim::Scratch scratch;
        const sim::TimeStep step = sim::choose_time_step(loaded.model, loaded.state, scratch);
        EXPECT_EQ(step.steps_left, 1) << slow;
        EXPECT_EQ(step.dt, loaded.model.time.end) << slow;
    }
}

TEST(RangesOfAngles, are_told_in_the_unit_that_is_asked_for) {
    const std::string text =
        with(minimal_case, "normal_stiffness = 1.0e7", "normal_stiffness = 1.0e7\nfriction_angle_deg = 95");
    EXPECT_THAT(problems_of(text),
                ElementsAre(HasSubstr("friction_angle of [material.NAME] = 95; an angle, 0 <= value < 89.99")));
    EXPECT_THAT(problems_of(text), ElementsAre(HasSubstr(" deg")));
    EXPECT_THAT(problems_of(text), ElementsAre(Not(HasSubstr("1.57"))));
    EXPECT_THAT(problems_of(with(text, "friction_angle_deg = 95", "friction_angle = \"95 deg\"")),
                ElementsAre(HasSubstr("0 <= value < 1.5707 (0 <= value < 89.99")));
}

TEST(GroundFarAway, is_told_of) {
    const std::string wall =
        "[[body]]\nname = \"wall\"\nmaterial = \"rock\"\nfixed = true\nshape = { box = [100, 100, 1] }\nposition = ";
    EXPECT_THAT(read(minimal_case + wall + "[5e6, 0, -1]\n").warnings,
                Contains(HasSubstr("'wall' lies 5e+06 m from all that moves")));
    EXPECT_THAT(read(minimal_case + wall + "[0, 0, -300]\n").warnings, Not(Contains(HasSubstr("from all that moves"))));
}

}  // namespace
}  // namespace riprap::scene
