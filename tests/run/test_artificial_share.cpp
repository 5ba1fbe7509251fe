// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "riprap/run/simulate/ledger_verdict.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string tank =
    "dimension = 2\ngravity = [0, -9.81]\nend = 0.2\n[material.rock]\ndensity = 2500\n"
    "friction_coefficient = 0.5\nnormal_stiffness = 1e7\n[fluid]\nspacing = 0.05\n"
    "domain = { low = [-0.5, -0.5], high = [3, 2] }\n[[fluid.region]]\nbox = { low = [0, 0], high = [0.5, 1] }\n"
    "[[body]]\nname = 'ground'\nmaterial = 'rock'\nshape = { half_space = { normal = [0, 1] } }\nfixed = true\n"
    "[[body]]\nname = 'left'\nmaterial = 'rock'\nshape = { half_space = { normal = [1, 0] } }\nfixed = true\n";

Simulation dam_break() { return Simulation(scene::read_case_text(tank, "case.toml", ".")); }

TEST(ArtificialShare, IsToldWhereItIsMoreThanATenthOfTheTurnoverWithItsLargestAccountFirst) {
    Simulation simulation = dam_break();
    while (simulation.steps_left() > 0) {
        ASSERT_EQ(simulation.step(sim::Measure::energy).kind, StepOutcome::Kind::accepted);
    }
    sim::Ledger ledger = simulation.report().ledger;
    ASSERT_GT(ledger.fluid.artificial, 0);
    ledger.fluid.mass = 0;  // so that turnover alone counts
    ledger.turnover = 11 * ledger.fluid.artificial;
    EXPECT_EQ(artificial_text(ledger, simulation.model()), "");
    ledger.turnover = 4 * ledger.fluid.artificial;
    EXPECT_THAT(artificial_text(ledger, simulation.model()), AllOf(HasSubstr("took 25 %"), HasSubstr("fluid.")));
}

TEST(ArtificialShare, OfADamBreakThatIsResolvedIsNotToldAtItsEnd) {
    Simulation simulation = dam_break();
    while (simulation.steps_left() > 0) {
        ASSERT_EQ(simulation.step(sim::Measure::energy).kind, StepOutcome::Kind::accepted);
    }
    EXPECT_THAT(simulation.summary().warnings, Not(Contains(HasSubstr("artificial"))));
}

}  // namespace
}  // namespace riprap::run
