// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/simulate/step_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace riprap::run {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A watch with a few steps to judge.
struct Watched {
    StepWatch watch;
    sim::State state;
    StepCounts counts;
    std::vector<std::string> look(const sim::StepReport& report) {
        state.step += 1;
        counts.add(report, false);
        std::vector<std::string> texts;
        for (const Notice& notice : watch.look(report, state, counts)) {
            texts.push_back(notice.text);
        }
        return texts;
    }
};

sim::StepReport quiet() {
    sim::StepReport report;
    report.dt = 1e-3;
    report.dt_bound = 2e-3;
    return report;
}

TEST(StepWatch, warns_once_of_added_mass_that_does_not_converge_and_counts_the_steps) {
    Watched run;
    EXPECT_THAT(run.look(quiet()), IsEmpty());
    sim::StepReport open = quiet();
    open.is_fluid_settled = false;
    open.fluid_passes = 20;
    open.fluid_residual = 0.25;
    EXPECT_THAT(run.look(open), ElementsAre(HasSubstr("step 2, t = 0 s: the accelerations of light bodies in water "
                                                      "have not settled after 20 passes, 0.25 of them")));
    EXPECT_THAT(run.look(open), IsEmpty());
    EXPECT_EQ(run.counts.unsettled, 2);
    EXPECT_THAT(StepWatch::totals(run.counts, 3), ElementsAre(HasSubstr("did not settle in 2 of 3 steps")));
    Watched resumed{{}, {}, run.counts};  // it is once per run, not per process
    EXPECT_THAT(resumed.look(open), IsEmpty());
    EXPECT_EQ(resumed.counts.unsettled, 3);
}

TEST(StepWatch, the_step_that_meets_the_end_is_not_among_the_shortest) {
    StepCounts counts;
    sim::StepReport report = quiet();
    for (const double dt : {3e-3, 2e-3, 4e-3}) {
        report.dt = dt;
        counts.add(report, false);
    }
    report.dt = 1e-3;
    counts.add(report, true);
    EXPECT_EQ(counts.shortest, 2e-3);
    EXPECT_EQ(counts.longest, 4e-3);
}

TEST(StepWatch, warns_once_of_friction_that_does_not_settle_and_counts_contacts_and_steps) {
    Watched run;
    sim::StepReport report = quiet();
    report.open_frictions = 3;
    EXPECT_THAT(run.look(report), ElementsAre(HasSubstr("friction of 3 sliding contacts has not settled")));
    EXPECT_THAT(run.look(report), IsEmpty());
    EXPECT_EQ(run.counts.with_open_friction, 2);
    EXPECT_EQ(run.counts.open_frictions, 6);
    EXPECT_THAT(StepWatch::totals(run.counts, 4), ElementsAre(HasSubstr("in 2 of 4 steps, 6 contacts in all")));
}

TEST(StepWatch, warns_once_of_a_body_behind_an_opening_and_counts_the_steps) {
    Watched run;
    sim::StepReport report = quiet();
    report.particles.intruder = "'block' stands behind the opening 'out'";
    EXPECT_THAT(run.look(report), ElementsAre(HasSubstr("'block' stands behind the opening 'out'")));
    EXPECT_THAT(run.look(report), IsEmpty());
    EXPECT_EQ(run.counts.with_intruder, 2);
}

TEST(StepWatch, warns_again_of_a_step_above_its_bound_when_the_excess_has_doubled) {
    Watched run;
    const auto step_of = [&](double times) {
        sim::StepReport report = quiet();
        report.dt = times * report.dt_bound;
        return run.look(report).size();
    };
    EXPECT_EQ(step_of(0.9), 0U);
    EXPECT_EQ(step_of(1.5), 1U);
    EXPECT_EQ(step_of(2.9), 0U);
    EXPECT_EQ(step_of(3.1), 1U);
    EXPECT_EQ(run.counts.above_bound, 3);
    sim::StepReport forced = quiet();
    forced.fluid_dt_bound = 1e-4;
    EXPECT_THAT(run.look(forced), ElementsAre(HasSubstr("is 10 times what the water allows now (0.0001 s")));
}

}  // namespace
}  // namespace riprap::run
