// SPDX-License-Identifier: Apache-2.0
// Water that starts with a flow of a name, or is carried by it, and sides of the domain that go with it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/core/error.hpp"
#include "riprap/run/figures/expects.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/column_group.hpp"
#include "riprap/sim/time_step.hpp"

namespace riprap::run {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A closed box of a metre without gravity; keys of [fluid] may follow.
constexpr const char* box = R"(
dimension = 2
gravity = [0.0, -1.0e-9]
end = 0.2
[fluid]
open_top = false
method = "grid"
density = 1000.0
domain = { low = [0.0, 0.0], high = [1.0, 1.0] }
)";
/// Water in all of it.
constexpr const char* full = "[[fluid.region]]\n";

Simulation start(const std::string& text) { return Simulation(scene::read_case_text(text, "case.toml", ".")); }

/// Runs to the end and judges every step.
std::vector<ExpectResult> results_of(const std::string& text) {
    Simulation simulation = start(text);
    ExpectWatch watch(simulation.model());
    watch.look(simulation.now());
    while (simulation.state().time < simulation.model().time.end * (1 - 1e-9)) {
        simulation.step(sim::Measure::energy);
        watch.look(simulation.now());
    }
    return watch.judge(true);
}

std::vector<std::string> problems_of(const std::string& text) {
    std::vector<std::string> found;
    try {
        scene::read_case_text(text, "case.toml", ".");
    } catch (const CaseError& error) {
        for (const Diagnostic& problem : error.problems()) {
            found.push_back(to_string(problem));
        }
    }
    return found;
}

std::string gauge(const std::string& kind, const std::string& low = "[0.0, 0.0]",
                  const std::string& high = "[1.0, 1.0]") {
    return fmt::format("[[output.gauge]]\nname = 'g'\nkind = '{}'\npoint = {}\nend = {}\n", kind, low, high);
}
std::string reported(const std::string& quantity) {
    return fmt::format("[[expect]]\nname = '{0}'\nquantity = '{0}'\nreported = true\ncitation = 'test'\n", quantity);
}

constexpr const char* vortices = "flow = { taylor_green = { wave_length = 2.0 } }\n";

TEST(FlowStart, EverySchemeOfParticlesStartsWithTheFlowAtEachPlace) {
    for (const char* const method : {"sph", "wcmps", "mps"}) {
        const Simulation simulation = start(fmt::format(R"(
dimension = 2
gravity = [0.0, 0.0]
end = 0.1
[fluid]
method = "{}"
spacing = 0.05
domain = {{ low = [0.0, 0.0], high = [2.0, 2.0], periodic = [true, true] }}
flow = {{ taylor_green = {{ speed = 0.5, wave_length = 2.0 }} }}
[[fluid.region]]
)",
                                                        method));
        const fluid::ParticleState& water = simulation.state().fluid;
        ASSERT_EQ(water.size(), 1600) << method;
        for (std::size_t i = 0; i < water.position.size(); i += 37) {
            const Vec3 x = M_PI * water.position[i];
            EXPECT_NEAR(water.velocity[i].x, 0.5 * std::sin(x.x) * std::cos(x.y), 1e-12) << method;
            EXPECT_NEAR(water.velocity[i].y, -0.5 * std::cos(x.x) * std::sin(x.y), 1e-12) << method;
        }
    }
}

TEST(FlowStart, VorticesOnCellsDieAsTheirFormulaSays) {
    const std::string text = std::string(box) + "spacing = 0.03125\nkinematic_viscosity = 0.02\n" + vortices + full +
                             gauge("flow_error") + reported("g.x") + reported("g.y") + reported("fluid.kinetic");
    const auto results = results_of(text);
    EXPECT_LT(results[0].value, 2e-3);
    EXPECT_LT(results[1].value, 2e-3);
    EXPECT_GT(results[0].value, 1e-6);
    EXPECT_NEAR(results[2].value, 1000 * 0.25 * 0.5 * std::exp(-4 * 0.02 * M_PI * M_PI * 0.2) * 2, 2)
        << "rho (u^2 + v^2)/2 over a square metre: U^2/4 of it";
}

// A square of water turns by 90 degrees: it comes to where another square was asked for.
TEST(FlowStart, CarriedWaterGoesAsFarAsTheFlowTakesIt) {
    const std::string text = R"(
dimension = 2
gravity = [0.0, -1.0e-9]
end = 0.25
time_step = 0.0025
[fluid]
method = "grid"
density = 1000.0
open_top = false
carried = true
spacing = 0.04
domain = { low = [0.0, 0.0], high = [1.0, 1.0] }
flow = { rotation = { center = [0.5, 0.5], rate = 6.283185307179586 } }
[[fluid.region]]
box = { low = [0.6, 0.4], high = [0.8, 0.6] }
)";
    const auto at_end = results_of(text + gauge("centre") + reported("g.x") + reported("g.y"));
    EXPECT_NEAR(at_end[0].value, 0.5, 5e-3);
    EXPECT_NEAR(at_end[1].value, 0.7, 5e-3);
    const auto speed = results_of(text + gauge("mean_velocity") + reported("g.x") + reported("g.y"));
    EXPECT_NEAR(speed[0].value, -2 * M_PI * 0.2, 2e-2);
    EXPECT_NEAR(speed[1].value, 0, 2e-2);
    const auto changed = results_of(text + gauge("changed") + reported("g") + reported("fluid.external"));
    EXPECT_NEAR(changed[0].value, 2 * 0.04, 4e-3) << "all of it has left, and is elsewhere";
    const auto volume = results_of(text + gauge("volume") + reported("g"));
    EXPECT_NEAR(volume[0].value, 0.04, 1e-14);
}

/// Hash of the State after six steps of carried water, and what the gauge reads then.
/// @param forget  a step before which Scratch is dropped
std::pair<std::uint64_t, double> carried_state(std::int64_t forget) {
    const std::string text = std::string(box) + "spacing = 0.0625\ncarried = true\n" +
                             "flow = { vortex = { length = 1.0, period = 1.0 } }\n" + gauge("changed") +
                             "[[fluid.region]]\nshape = { sphere = 0.2 }\nposition = [0.5, 0.7]\n";
    scene::LoadedCase loaded = scene::read_case_text(text, "case.toml", ".");
    sim::initialise(loaded.model, loaded.state);
    sim::Scratch scratch;
    const sim::State initial = loaded.state;
    sim::StepReport report;
    while (loaded.state.step < 6) {
        if (loaded.state.step == forget) {
            scratch.forget();
        }
        const double dt = choose_time_step(loaded.model, loaded.state, scratch).dt;
        report = advance(loaded.model, loaded.state, scratch, dt, sim::Measure::flow);
    }
    const auto changed = sim::find_columns(loaded.model, "g");
    return {state_hash(loaded.state), evaluate(*changed, {loaded.model, initial, loaded.state, &scratch, &report})};
}

TEST(FlowStart, DroppingScratchChangesNothingOfCarriedWaterNorOfWhatItIsComparedWith) {
    const auto whole = carried_state(-1);
    EXPECT_GT(whole.second, 1e-4);
    EXPECT_EQ(carried_state(3), whole);
}

/// Largest speed after 0.2 s of a force along plates without end, of a lid that slides, or of both sides still.
double speed_between_plates(const std::string& gravity, const std::string& sides) {
    std::string text = box;
    text.replace(text.find("[0.0, -1.0e-9]"), 14, gravity);
    return results_of(text + "spacing = 0.1\nkinematic_viscosity = 0.5\n" + full + sides +
                      "[[output.gauge]]\nname = 'g'\nkind = 'velocity'\npoint = [0.5, 0.85]\n" + reported("g.x"))[0]
        .value;
}

TEST(FlowStart, PlatesSlideAndHaveNoEnd) {
    const std::string endless =
        "[[fluid.side]]\nside = 'x'\nkind = 'endless'\n[[fluid.side]]\nside = '-x'\nkind = 'endless'\n";
    const std::string wall = "[[fluid.side]]\nside = 'y'\nkind = 'no_slip'\n";
    const std::string none = "[0.0, -1.0e-9]", along = "[0.1, 0.0]";
    EXPECT_NEAR(speed_between_plates(along, endless), 0.1 * 0.2, 1e-6) << "nothing holds the water";
    EXPECT_LT(speed_between_plates(along, endless + wall), 0.015) << "a plate does";
    EXPECT_NEAR(speed_between_plates(along, ""), 0, 1e-6) << "ends that are closed do";
    EXPECT_NEAR(speed_between_plates(none, endless + wall), 0, 1e-15);
    EXPECT_GT(speed_between_plates(none, endless + wall + "velocity = [1.0, 0.0]\n"), 0.3);
    EXPECT_LT(speed_between_plates(none, endless + wall + "velocity = [-1.0, 0.0]\n"), -0.3);
}

TEST(FlowStart, SidesAndFlowsThatContradictTheCaseAreRefusedWithTheirPlace) {
    const std::string keys = std::string(box) + "spacing = 0.1\n", text = keys + full;
    const auto side = [&](const std::string& more) {
        return problems_of(text + "[[fluid.side]]\nside = 'x'\n" + more);
    };
    EXPECT_THAT(side("kind = 'slip'\nvelocity = [0.0, 1.0]\n"),
                ElementsAre(HasSubstr("case.toml:12:1: a velocity of a side that nothing sticks to")));
    EXPECT_THAT(side("kind = 'no_slip'\nvelocity = [1.0, 0.0]\n"),
                ElementsAre(HasSubstr("case.toml:12:1: a wall that moves across itself")));
    EXPECT_THAT(side("kind = 'flow'\n"), ElementsAre(HasSubstr("case.toml:12:1: a side with the velocity of a flow")));
    EXPECT_THAT(side("kind = 'slip'\n[[fluid.side]]\nside = 'x'\nkind = 'no_slip'\n"),
                ElementsAre(HasSubstr("case.toml:15:1: a second rule for the same side")));
    EXPECT_THAT(
        side("kind = 'endless'\n[[fluid.outflow]]\nname = 'o'\nlow = [1.0, 0.0]\nhigh = [1.0, 1.0]\ntowards = 'x'\n"),
        ElementsAre(HasSubstr("an opening in a side that is open already")));
    EXPECT_THAT(problems_of(keys + "carried = true\n" + full),
                ElementsAre(HasSubstr("case.toml:11:11: water that no flow carries")));
    EXPECT_THAT(problems_of(keys + "flow = { spiral = { rate = 1.0 } }\n" + full),
                ::testing::Not(::testing::IsEmpty()));
    EXPECT_THAT(problems_of(text + gauge("flow_error")),
                ElementsAre(HasSubstr("compares the water with a flow that the case does not name")));
    EXPECT_THAT(problems_of(keys + "growth = 1.1\nfine_high = [0.5, 0.5]\nwall_narrowing = 0.3\n" + full),
                ElementsAre(HasSubstr("cells that grow away from a box and narrow towards the sides")));
}

TEST(FlowStart, CellsAreAsLongAndAsNarrowAsTheCaseSays) {
    const auto edges = [&](const std::string& more, std::size_t axis) {
        const Simulation simulation = start(std::string(box) + "spacing = 0.05\n" + more + full);
        return std::get<coupling::GridFluidSettings>(simulation.model().fluid).grid.mesh.edge[axis];
    };
    EXPECT_EQ(edges("stretch = [4.0, 1.0]\n", 0).size(), 6U);
    EXPECT_EQ(edges("stretch = [4.0, 1.0]\n", 1).size(), 21U);
    const auto narrow = edges("wall_narrowing = 0.5\n", 1);
    ASSERT_EQ(narrow.size(), 21U);
    EXPECT_NEAR(narrow[1], 0.05 - 0.5 / (2 * M_PI) * std::sin(2 * M_PI * 0.05), 1e-14);
    EXPECT_NEAR(narrow[10] - narrow[9], 0.05 * 1.5, 2e-3);
    EXPECT_NEAR(narrow[20] - narrow[19], narrow[1], 1e-14) << "the same at both ends";
}

}  // namespace
}  // namespace riprap::run
