// SPDX-License-Identifier: Apache-2.0
// Instruments with a sensing area and a time of response, in water whose pressure is known.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "io/temporary_folder.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/drive/run_case.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::run {
namespace {

constexpr double depth = 0.2, grown = 0.1, full = 9.81, theta = 0.02;

/// A column of water 0.2 m deep between walls, for 0.1 s, in gravity that grows evenly from nothing over a time: the
/// pressure at each depth grows likewise.
std::string column(const std::string& method, double ramp, const std::string& gauges) {
    const auto wall = [](const std::string& name, const std::string& normal, double offset) {
        return fmt::format(
            "[[body]]\nname = '{}'\nmaterial = 'rock'\nshape = {{ half_space = {{ normal = {}, offset = {} }} }}\n"
            "fixed = true\n",
            name, normal, offset);
    };
    return fmt::format(
               "dimension = 2\nend = {}\ntime_step = {}\n[gravity]\nvalue = [0, -{}]\nramp = "
               "{}\n[material.rock]\ndensity = 2500\n"
               "normal_stiffness = 1e6\nfriction_coefficient = 0.4\n[fluid]\nmethod = '{}'\nspacing = 0.01\n"
               "domain = {{ low = [-0.05, -0.05], high = [0.15, 0.3] }}\n[[fluid.region]]\n"
               "box = {{ low = [0, 0], high = [0.1, {}] }}\n",
               grown, method == "grid" ? "0.0005" : "'auto'", full, ramp, method, depth) +
           wall("floor", "[0, 1]", 0) + wall("left", "[1, 0]", 0) + wall("right", "[-1, 0]", -0.1) + gauges;
}

std::string gauge(const std::string& name, const std::string& rest, double y = 0.1) {
    return fmt::format("[[output.gauge]]\nname = '{}'\nkind = 'wall_pressure'\npoint = [0, {}]\n{}\n", name, y, rest);
}

/// Runs a case and shows each accepted step to `look`.
template <class Look>
void run(const std::string& text, const Look& look) {
    Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    while (simulation.steps_left() > 0) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        ASSERT_NE(outcome.kind, StepOutcome::Kind::refused) << outcome.why.text;
        look(simulation);
    }
}

// Of p = k t, a first-order instrument that begins with the water shows k (t - theta (1 - exp(-t/theta))).
TEST(SlowGauge, LagsBehindAPressureThatGrowsByItsResponseInEveryFluid) {
    for (const char* method : {"grid", "sph"}) {
        double last = 0, quick = 0, slow = 0;
        run(column(method, grown, gauge("quick", "") + gauge("slow", fmt::format("response = {}", theta))),
            [&](const Simulation& simulation) {
                const auto columns = sim::record_columns(simulation.model());
                last = simulation.state().time;
                quick = sim::evaluate(columns[0], simulation.now());
                slow = sim::evaluate(columns[1], simulation.now());
            });
        const double rate = 1000 * full * (depth - 0.1) / grown;
        EXPECT_NEAR(last, grown, 1e-9) << method;
        EXPECT_NEAR(quick, rate * grown, 0.05 * rate * grown) << method;
        const double lag = theta * (1 - std::exp(-grown / theta));
        EXPECT_NEAR(slow, rate * (grown - lag), 0.05 * rate * grown) << method;
    }
}

// In still water the mean over a square is the pressure in its middle; over water that covers half of it, an eighth of
// what is on its whole side: rho g s/2 over half of the side.
TEST(SlowGauge, TakesTheMeanOverItsSquareAtTheSurfaceToo) {
    constexpr double side = 0.08;
    for (const char* method : {"grid", "sph"}) {
        double deep = 0, point = 0, at_surface = 0;
        const std::string area = fmt::format("area = {}", side * side);
        run(column(method, 0, gauge("deep", area) + gauge("point", "") + gauge("surface", area, depth)),
            [&](const Simulation& simulation) {
                const auto columns = sim::record_columns(simulation.model());
                deep = sim::evaluate(columns[0], simulation.now());
                point = sim::evaluate(columns[1], simulation.now());
                at_surface = sim::evaluate(columns[2], simulation.now());
            });
        const double head = 1000 * full * (depth - 0.1), half = 1000 * full * side / 8;
        EXPECT_NEAR(deep, head, 0.03 * head) << method;
        EXPECT_NEAR(point, head, 0.05 * head) << method;
        EXPECT_NEAR(at_surface, half, 0.1 * half) << method;
    }
}

// What an instrument shows is part of the State.
TEST(SlowGauge, ShowsTheSameAfterAStopInAnyStep) {
    const TemporaryFolder place;
    io::write_file(place / "case.toml", column("sph", grown, gauge("slow", "response = 0.02\narea = 4e-4")));
    const auto run_in = [&](const std::string& folder, std::vector<std::string> overrides) {
        RunOptions options;
        options.case_path = (place / "case.toml").string();
        options.overrides = std::move(overrides);
        options.overrides.emplace_back("output.vtk=false");
        options.overrides.emplace_back("end=0.02");
        options.overrides.emplace_back("output.probe_interval=0.001");
        options.out = place / folder;
        options.quiet = options.silent = true;
        return options;
    };
    ASSERT_EQ(run_case(run_in("whole", {})), 0);
    ASSERT_EQ(run_case(run_in("parts", {"max_steps=13"})), 0);
    ASSERT_EQ(resume_run({place / "parts", 1, {}, -1, true}), 0);
    const auto probes = [&](const std::string& folder) {
        return io::read_file(place / folder / "probes.csv", 1U << 20U);
    };
    EXPECT_EQ(probes("parts"), probes("whole"));
}

}  // namespace
}  // namespace riprap::run
