// SPDX-License-Identifier: Apache-2.0
// Water of the grid that leaves through the open top of its domain.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/temporary_folder.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "riprap/run/simulate/passage_verdict.hpp"
#include "riprap/run/simulate/restart.hpp"
#include "riprap/run/simulate/simulation.hpp"

namespace riprap::run {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// A dam break under a top so low that the water that climbs the far wall reaches it.
std::string dam_break_under_a_low_top(const std::string& more = "") {
    return R"(
dimension = 2
gravity = [0.0, -9.81]
end = 0.6
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[fluid]
method = "grid"
spacing = 0.04
domain = { low = [0.0, 0.0], high = [0.8, 0.4] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [0.3, 0.36] }
)" + more;
}

/// Walks to a time, or until a step is refused for good.
StepOutcome walk_to(Simulation& simulation, double time) {
    StepOutcome outcome;
    while (outcome.kind != StepOutcome::Kind::refused && simulation.state().time < time) {
        outcome = simulation.step(sim::Measure::energy);
    }
    return outcome;
}

const fluid::grid::WaterBooks& books_of(const sim::State& state) {
    return std::get<coupling::GridFluidFields>(state.fluid_fields).water.water;
}

Simulation simulation_of(const std::string& text) { return Simulation(scene::read_case_text(text, "case.toml", ".")); }

// Story: a tenth of the water of this case left through the top without a word, and the run ended well.
TEST(GridLetGo, more_than_a_thousandth_through_the_open_top_ends_the_run) {
    Simulation simulation = simulation_of(dam_break_under_a_low_top());
    const StepOutcome outcome = walk_to(simulation, 0.6);
    EXPECT_EQ(outcome.kind, StepOutcome::Kind::refused);
    EXPECT_THAT(outcome.why.text,
                HasSubstr("kg/m of water have left through the top of the domain, the high side of y, by t = 0."));
    EXPECT_THAT(outcome.why.text, HasSubstr("allowed: 0.108 kg/m, 0.1 % of all"));
    EXPECT_THAT(outcome.why.remedy, HasSubstr("fluid.domain.high = "));
    EXPECT_LE(books_of(simulation.state()).let_go, 1e-3 * 0.108);
}

TEST(GridLetGo, more_than_a_thousandth_leaves_freely_where_an_outflow_lies_on_the_top) {
    Simulation simulation = simulation_of(
        dam_break_under_a_low_top("[[fluid.outflow]]\nname = \"over\"\ntowards = \"y\"\nlow = [0.0, 0.4]\n"
                                  "high = [0.8, 0.4]\n"));
    EXPECT_TRUE(walk_to(simulation, 0.5).is_accepted());
    const fluid::grid::WaterBooks& books = books_of(simulation.state());
    EXPECT_LT(books.held, 0.99 * 0.108);
    EXPECT_EQ(books.let_go, 0);
    EXPECT_THAT(splash_text(simulation.model(), simulation.state()), IsEmpty());
}

TEST(GridLetGo, none_stays_unsaid_under_a_top_that_is_closed) {
    Simulation simulation = simulation_of(
        dam_break_under_a_low_top().replace(dam_break_under_a_low_top().find("spacing"), 0, "open_top = false\n"));
    EXPECT_TRUE(walk_to(simulation, 0.5).is_accepted());
    EXPECT_NEAR(books_of(simulation.state()).held, 0.108, 1e-12);
    EXPECT_EQ(books_of(simulation.state()).let_go, 0);
}

/// A tank 4 m long, and one cell of water that is thrown up beneath its top: a thousandth of all, less a tenth.
std::string splash() {
    return R"(
dimension = 2
gravity = [0.0, -9.81]
end = 10.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[fluid]
method = "grid"
spacing = 0.05
domain = { low = [0.0, 0.0], high = [4.0, 1.0] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [4.0, 0.7] }
[[fluid.region]]
box = { low = [2.0, 0.9], high = [2.05, 0.95] }
velocity = [0.0, 10.0]
)";
}

TEST(GridLetGo, a_splash_is_counted_and_said_and_the_count_outlives_a_restart) {
    Simulation straight = simulation_of(splash());
    EXPECT_THAT(splash_text(straight.model(), straight.state()), IsEmpty());
    while (books_of(straight.state()).let_go < 1e-4) {
        ASSERT_TRUE(straight.step(sim::Measure::energy).is_accepted());
        ASSERT_LT(straight.state().time, 0.1);
    }
    const TemporaryFolder place;
    const RunFolder folder{place.path()};
    io::make_folder(folder.checkpoint_latest().parent_path());
    RunRecord record;
    straight.note(record);
    record.frame_interval = record.row_interval = 1;
    record.csv_bytes = {0, 0};
    save_checkpoint(folder, straight.model(), straight.state(), record);
    Simulation resumed = simulation_of(splash());
    Restart restart = load_checkpoint(folder, resumed.model(), resumed.initial());
    resumed.restore(std::move(restart.state), record);
    for (Simulation* simulation : {&straight, &resumed}) {
        EXPECT_TRUE(walk_to(*simulation, 0.05).is_accepted());
    }
    EXPECT_EQ(sim::state_hash(straight.state()), sim::state_hash(resumed.state()));
    const fluid::grid::WaterBooks& books = books_of(resumed.state());
    EXPECT_NEAR(books.ever, 4 * 0.7 + 0.05 * 0.05, 1e-12);
    EXPECT_NEAR(books.held + books.let_go, books.ever, 1e-12);
    EXPECT_THAT(resumed.totals(),
                testing::Contains(HasSubstr(fmt::format("{:.3g} kg/m of water, {:.3g} % of it, left through the top "
                                                        "of the domain, the high side of y, and was let go",
                                                        1000 * books.let_go, 100 * books.let_go / books.ever))));
}

/// A block in water whose domain has no floor and no walls but its sides, map coordinates added.
std::string block_in_a_domain(const std::string& block, double x = 0, double y = 0) {
    return fmt::format(R"(
dimension = 2
gravity = [0.0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[fluid]
method = "grid"
spacing = 0.05
domain = {{ low = [{0}, {1}], high = [{2}, {3}] }}
[[fluid.region]]
box = {{ low = [{0}, {1}], high = [{2}, {4}] }}
[[body]]
name = "block"
material = "rock"
shape = {{ box = [0.2, 0.15] }}
position = [{5}, {6}]
{7}
)",
                       x, y, x + 1, y + 1, y + 0.583, x + 0.513, y + 0.307, block);
}

// A block sank through the bottom of its domain, to 5.7 m below it, and the run ended well.
TEST(GridLetGo, ABodyThatLeavesTheWaterThroughASideThatIsAWallForItAloneEndsTheRun) {
    const auto end_of = [](const std::string& text) {
        Simulation simulation = simulation_of(text);
        return walk_to(simulation, 0.9);
    };
    const StepOutcome down = end_of(block_in_a_domain("density = 2500.0"));
    EXPECT_EQ(down.kind, StepOutcome::Kind::refused);
    EXPECT_THAT(down.why.text, HasSubstr("'block' leaves the water through the low side of y of the domain at t = 0."));
    EXPECT_THAT(down.why.remedy, HasSubstr("fixed = true"));
    const StepOutcome aside = end_of(block_in_a_domain("density = 1000.0\nvelocity = [3.0, 0.0]"));
    EXPECT_THAT(aside.why.text, HasSubstr("'block' leaves the water through the high side of x"));
    EXPECT_TRUE(end_of(block_in_a_domain("density = 2500.0\nwet = false")).is_accepted());
    const std::string floor =
        "[[body]]\nname = \"floor\"\nmaterial = \"rock\"\nfixed = true\n"
        "shape = { box = [1.0, 0.2] }\nposition = [0.5, -0.1]\n";  // what the remedy asks for
    EXPECT_TRUE(end_of(block_in_a_domain("density = 2500.0\n" + floor)).is_accepted());
}

// Nothing here lies on a side of a cell, where the last digit of a place decides in which of two cells it is.
// At map coordinates rho g.x is 1e8 times the pressure, and its round-off was energy from nothing: the run ended.
TEST(GridLetGo, ABlockInWaterMovesAtMapCoordinatesAsAtTheOrigin) {
    const auto moved = [](double x, double y) {
        Simulation simulation = simulation_of(block_in_a_domain("density = 1500.0", x, y));
        EXPECT_TRUE(walk_to(simulation, 0.2).is_accepted());
        return simulation.state().bodies.position[0].y - (y + 0.307);
    };
    const double here = moved(0, 0);
    EXPECT_LT(here, -0.02);
    EXPECT_NEAR(moved(432150, 5103420), here, 1e-6 * std::abs(here) + 2e-9);
    EXPECT_NEAR(moved(-432150, -5103420), here, 1e-6 * std::abs(here) + 2e-9);
}

}  // namespace
}  // namespace riprap::run
