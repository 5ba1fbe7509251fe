// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "io/temporary_folder.hpp"
#include "riprap/core/error.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/drive/run_case.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/advance.hpp"

namespace riprap::run {
namespace {

using ::testing::HasSubstr;

/// A block hits a wall with the longest step that the bound allows. Where it stands when it touches is such that the
/// kicks of the contact come late: it gets deeper than with short steps.
constexpr const char* impact = R"(
end = 0.2
gravity = [0, 0, 0]
time_step_factor = 1.0
[material.rock]
density = 2500.0
normal_stiffness = "20 MPa"
damping_ratio = 0.1
[solid]
sides = "contactor"
[[body]]
name = "wall"
shape = { box = [1.0, 1.0, 1.0] }
material = "rock"
fixed = true
[[body]]
name = "block"
shape = { box = [1.0, 1.0, 1.0] }
position = [0, 0, 1.25]
velocity = [0, 0, -15]
material = "rock"
[output]
vtk = false
[[output.probe]]
body = "block"
quantity = "position"
)";

/// Deepest normalised overlap of the impact where every step is divided by `parts`.
double deepest(int parts) {
    scene::LoadedCase loaded = scene::read_case_text(impact, "case.toml", ".");
    sim::initialise(loaded.model, loaded.state);
    sim::Scratch scratch;
    double worst = 0;
    while (choose_time_step(loaded.model, loaded.state, scratch).steps_left > 0) {
        const double dt = choose_time_step(loaded.model, loaded.state, scratch).dt;
        const sim::StepReport report = advance(loaded.model, loaded.state, scratch, dt / parts, sim::Measure::flow);
        EXPECT_TRUE(report.status.ok()) << report.status.text;
        worst = std::max(worst, report.max_potential);
    }
    return worst;
}

class Retries : public ::testing::Test {
 protected:
    Retries() { std::ofstream(place / "case.toml") << impact; }
    int run(const std::string& name, std::vector<std::string> overrides, int threads = 1) const {
        overrides.push_back("output.ledger_tolerance=1");  // not what is looked at here
        return run_case({.case_path = place / "case.toml",
                         .overrides = std::move(overrides),
                         .out = place / name,
                         .threads = threads,
                         .quiet = true});
    }
    nlohmann::json summary_of(const std::string& name) const {
        return nlohmann::json::parse(text_of(name, "summary.json"));
    }
    std::string text_of(const std::string& name, const std::string& file) const {
        return io::read_file(place.path() / name / file, 1U << 24U);
    }
    const TemporaryFolder place;
};

std::string limit(double potential) { return "solid.max_potential=" + std::to_string(potential); }

TEST_F(Retries, AStepRefusedIsTakenAgainWithHalfItsLengthAndTheRunGoesOn) {
    const double coarse = deepest(1), fine = deepest(16);
    ASSERT_LT(fine, 0.95 * coarse);
    // Only the last approach is taken again, so only part of the difference can be won back.
    const std::string between = limit(coarse - 0.1 * (coarse - fine));
    ASSERT_EQ(run("automatic", {between}), 0);
    const nlohmann::json summary = summary_of("automatic");
    EXPECT_EQ(summary.at("status"), "finished");
    EXPECT_EQ(summary.at("time"), 0.2);
    EXPECT_GE(summary.at("retries").get<int>(), 1);
    EXPECT_THAT(text_of("automatic", "run.log"), HasSubstr("was refused and is taken again"));
    EXPECT_THAT(text_of("automatic", "run.log"), HasSubstr("overlap of wall and block"));

    ASSERT_EQ(run("first", {between, "max_steps=1"}), 0);
    const std::string step = summary_of("first").at("time_step").dump();
    EXPECT_EQ(run("fixed", {between, "time_step=" + step}), static_cast<int>(ExitCode::numerical));
    EXPECT_EQ(summary_of("fixed").at("retries"), 0);
}

TEST_F(Retries, ARunWithRetriesHasTheSameBitsWhereverItIsStoppedAndOnAnyThreads) {
    const double coarse = deepest(1), fine = deepest(16);
    const std::string between = limit(coarse - 0.1 * (coarse - fine));
    ASSERT_EQ(run("whole", {between}), 0);
    const nlohmann::json whole = summary_of("whole");
    for (const int stop : {3, 8, 11, 41}) {  // before, between and after the retries
        const std::string name = "stopped_" + std::to_string(stop);
        ASSERT_EQ(run(name, {between, "max_steps=" + std::to_string(stop)}, 2), 0);
        ASSERT_EQ(resume_run({place.path() / name, 3, {}, -1, true}), 0);
        EXPECT_EQ(summary_of(name).at("state_hash"), whole.at("state_hash")) << stop;
        EXPECT_EQ(summary_of(name).at("retries"), whole.at("retries")) << stop;
        EXPECT_EQ(text_of(name, "probes.csv"), text_of("whole", "probes.csv")) << stop;
    }
}

TEST_F(Retries, GivesUpAfterTheStatedNumberOfRetriesAndKeepsTheLastGoodState) {
    const std::string shallow = limit(0.25 * deepest(16));
    EXPECT_EQ(run("deep", {shallow}), static_cast<int>(ExitCode::numerical));
    const nlohmann::json summary = summary_of("deep");
    EXPECT_EQ(summary.at("status"), "failed");
    EXPECT_EQ(summary.at("retries"), sim::max_halvings);
}

// A reviewer's find: steps taken before a new end were chosen by the old one, and going back worked them out by the
// new.
TEST_F(Retries, AStepRefusedAfterANewEndLeavesTheStateBeforeIt) {
    const std::vector<std::string> overrides{limit(0.25 * deepest(16)), "output.ledger_tolerance=1"};
    Simulation simulation(scene::read_case_text(impact, "case.toml", ".", overrides));
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(simulation.step(sim::Measure::flow).is_accepted());
    }
    simulation.set_end(0.17, -1);
    double time = 0;
    Vec3 position;
    StepOutcome outcome;
    do {
        time = simulation.state().time;
        position = simulation.state().bodies.position[1];
        outcome = simulation.step(sim::Measure::flow);
    } while (outcome.is_accepted() && simulation.steps_left() > 0);
    ASSERT_FALSE(outcome.is_accepted());
    EXPECT_EQ(simulation.state().time, time);
    EXPECT_EQ(simulation.state().bodies.position[1], position);
}

}  // namespace
}  // namespace riprap::run
