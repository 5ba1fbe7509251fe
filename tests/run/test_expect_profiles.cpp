// SPDX-License-Identifier: Apache-2.0
// Expected answers along the gauges of a profile.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "riprap/core/error.hpp"
#include "riprap/run/figures/expects.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

using ::testing::HasSubstr;

/// Still water 1 m deep, and five gauges of pressure from 0.1 to 0.5 m above the bed.
constexpr const char* tank = R"(
dimension = 2
gravity = [0.0, -10.0]
end = 0.1
[fluid]
method = "grid"
spacing = 0.1
domain = { low = [0.0, 0.0], high = [1.0, 1.3] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [1.0, 1.0] }
[[output.gauge]]
name = "p"
kind = "pressure"
point = [0.5, 0.1]
end = [0.5, 0.5]
count = 5
)";

constexpr const char* band = "low = 0.0\nhigh = 1.0e9\n";

std::string expect(const std::string& more) { return "[[expect]]\nname = 'a'\ncitation = 'test'\n" + more; }

/// Returns the answer of a run; with `stop` the watch is saved and read again after that step.
ExpectResult result_of(const std::string& more, int stop = -1) {
    Simulation simulation(scene::read_case_text(tank + expect(more), "case.toml", "."));
    std::optional<ExpectWatch> watch(simulation.model());
    watch->look(simulation.now());
    for (int step = 0; simulation.state().time < 0.1 * (1 - 1e-9); ++step) {
        simulation.step(sim::Measure::energy);
        watch->look(simulation.now());
        if (step == stop) {
            const std::vector<double> saved = watch->save();
            watch.emplace(simulation.model());
            watch->load(saved);
        }
    }
    return watch->judge(true).front();
}

std::string problem_of(const std::string& more) {
    try {
        scene::read_case_text(tank + expect(more), "case.toml", ".");
    } catch (const CaseError& error) {
        return to_string(error.problems().front());
    }
    return "";
}

// Pressure falls by 1000 Pa from gauge to gauge; that of the air, 1.2 kg/m^3 over 0.3 m, is on top of it.
TEST(ExpectProfiles, ProfilesAreHeldBesideTheirPointsAtOneTime) {
    const std::string points = "curve = { points = [[0.0, 9003.6], [0.15, 7503.6], [0.4, 5103.6]], along = 'place' }\n";
    for (const int stop : {-1, 0, 2}) {
        const ExpectResult worst = result_of("quantity = 'p'\nreduce = 'worst'\nat = 0.05\n" + points + band, stop);
        EXPECT_NEAR(worst.value, 100, 1) << "the last point is off by that";
        EXPECT_EQ(worst.unit, "Pa");
        const ExpectResult rms = result_of("quantity = 'p'\nreduce = 'rms'\nat = 0.1\n" + points + band, stop);
        EXPECT_NEAR(rms.value, 100 / std::sqrt(3.0), 1);
    }
}

TEST(ExpectProfiles, ACaseWithAProfileCanBeCutShort) {
    const std::string text = tank + expect(
                                        "quantity = 'p'\nreduce = 'worst'\nat = 0.05\n"
                                        "curve = { points = [[0.0, 9003.6]], along = 'place' }\n" +
                                        std::string(band));
    EXPECT_NO_THROW(scene::read_case_text(text, "case.toml", ".", std::vector<std::string>{"end=0.06"}));
}

TEST(ExpectProfiles, AProfileIsNotTakenRelativeToAnotherQuantity) {
    EXPECT_THAT(problem_of("quantity = 'p'\nreduce = 'worst'\nat = 0.05\nrelative_to = 'fluid.kinetic'\n"
                           "curve = { points = [[0.0, 9003.6]], along = 'place' }\n" +
                           std::string(band)),
                HasSubstr("leave it out"));
}

TEST(ExpectProfiles, GaugesOfAProfileAreTakenTogether) {
    EXPECT_NEAR(result_of("quantity = 'p[mean]'\nreported = true\n").value, 7003.6, 1);
    EXPECT_NEAR(result_of("quantity = 'p[max]'\nreduce = 'mean'\nfrom = 0.05\nreported = true\n").value, 9003.6, 1);
}

// Numbers of twelve gauges have two digits.
TEST(ExpectProfiles, ProfilesMayBeLong) {
    std::string text = tank;
    text.replace(text.find("count = 5"), 9, "count = 12");
    Simulation simulation(
        scene::read_case_text(text + expect("quantity = 'p[mean]'\nreported = true\n"), "case.toml", "."));
    simulation.step(sim::Measure::energy);
    const auto profile = sim::find_profile(simulation.model(), "p");
    ASSERT_TRUE(profile.has_value());
    EXPECT_EQ(profile->columns.size(), 12U);
    EXPECT_NEAR(profile->place.back(), 0.4, 1e-12);
    EXPECT_NEAR(sim::evaluate(*profile, 0.2, simulation.now()), 7003.6, 1);
    EXPECT_TRUE(std::isnan(sim::evaluate(*profile, 0.41, simulation.now())));
}

TEST(ExpectProfiles, WhatDoesNotGoTogetherIsToldWithItsPlace) {
    const auto along = [](const std::string& quantity, const std::string& point, const std::string& more) {
        return "quantity = '" + quantity + "'\nreduce = 'rms'\ncurve = { points = [[" + point +
               ", 0.0]], along = 'place' }\n" + band + more;
    };
    EXPECT_THAT(problem_of(along("p", "0.1", "")), HasSubstr("case.toml:17:1: 'at' goes with"));
    EXPECT_THAT(problem_of(along("p", "0.5", "at = 0.1\n")),
                HasSubstr("case.toml:20:12: a point of the curve at 0.5 m of the profile 'p'; 0 to 0.4 m"));
    EXPECT_THAT(problem_of(along("p", "-0.1", "at = 0.1\n")), HasSubstr("a point of the curve at -0.1 m"));
    EXPECT_THAT(problem_of(along("p.x", "0.1", "at = 0.1\n")), HasSubstr("case.toml:20:12: there is no profile 'p.x'"));
    EXPECT_THAT(problem_of(along("time", "0.1", "at = 0.1\n")), HasSubstr("there is no profile 'time'"));
    EXPECT_THAT(problem_of(along("p", "0.1", "at = 0.1\nfrom = 0.05\n")), HasSubstr("say nothing beside 'at'"));
}

}  // namespace
}  // namespace riprap::run
