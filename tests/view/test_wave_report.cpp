// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "riprap/view/bad_request.hpp"
#include "riprap/view/wave_report.hpp"
#include "riprap/wave/linear_wave.hpp"

namespace riprap::view {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double period = 1.5, depth = 0.7, incident_height = 0.2, reflected_height = 0.06;
const wave::LinearWave linear = wave::linear_wave(incident_height, period, depth, 9.81);

const std::string maker =
    "[[body]]\nname = \"paddle\"\nmotion = { wave_maker = { wave = \"regular\", direction = "
    "[-1.0, 0.0], height = 0.2, period = 1.5, depth = 0.7 } }\n";

std::string gauge(const std::string& name, double x, const std::string& kind = "level") {
    return fmt::format("[[output.gauge]]\nname = \"{}\"\nkind = \"{}\"\npoint = [{:.17g}, 0.0, 0.0]\n", name, kind, x);
}

/// Waves towards -x, and part of them back again, at gauges where x is 3.0, 3.4 and 4.1 m, for 12.7 s; a pressure
/// gauge between them.
RecordedRun waves_of(const std::string& case_text, const std::vector<double>& places = {3.0, 3.4, 4.1}) {
    RecordedRun run;
    run.gravity = {0, -9.81, 0};
    run.resolved_text = case_text;
    run.probes.columns = {{"time", "s"}};
    run.probes.values.resize(1);
    for (int i = 0; i <= 1270; ++i) {
        run.probes.values[0].push_back(0.01 * i);
    }
    for (std::size_t k = 0; k < places.size(); ++k) {
        const std::string name = fmt::format("g{}", k + 1);
        run.resolved_text += gauge(name, places[k], k == 1 ? "surface" : "level");
        run.resolved_text += k == 0 ? gauge("p", 3.1, "pressure") : "";
        run.probes.columns.push_back({name, "m"});
        std::vector<double> level;
        for (const double t : run.probes.values[0]) {
            const double kx = linear.wave_number * places[k], wt = linear.angular_frequency * t;
            level.push_back(depth + 0.5 * incident_height * std::cos(-kx - wt + 0.3) +
                            0.5 * reflected_height * std::cos(kx - wt + 1.1));
        }
        run.probes.values.push_back(std::move(level));
    }
    return run;
}

TEST(WaveReport, a_reflected_wave_is_found_with_what_the_case_says_of_its_paddle) {
    const WaveReport report = analyse_waves(waves_of(maker), {});
    ASSERT_TRUE(report.reflection) << report.why_no_reflection;
    EXPECT_NEAR(2 * report.reflection->parts.incident, incident_height, 1e-12);
    EXPECT_NEAR(2 * report.reflection->parts.reflected, reflected_height, 1e-12);
    EXPECT_NEAR(report.reflection->parts.misfit, 0, 1e-12);
    EXPECT_NEAR(report.reflection->length, linear.length(), 1e-12);
    EXPECT_EQ(report.gauges.size(), 3U);
    EXPECT_EQ(report.gauges[0].place, -3.0);  // along the waves
    EXPECT_NEAR(report.gauges[0].waves.mean_level, depth, 1e-6);
    // Of the second half, 6.35 s, four whole periods are looked at.
    EXPECT_NEAR(report.to, 12.7, 1e-12);
    EXPECT_NEAR(report.from, 12.7 - 4 * period, 1e-12);
    EXPECT_THAT(wave_text(report), HasSubstr("incident H 0.2 m, reflected H 0.06 m, K_r = 0.3"));
    const nlohmann::json json = nlohmann::json::parse(wave_json(report));
    EXPECT_NEAR(json.at("reflection").at("coefficient").get<double>(), 0.3, 1e-11);
    EXPECT_EQ(json.at("gauges").size(), 3U);
}

TEST(WaveReport, a_wave_of_another_period_is_left_over) {
    RecordedRun run = waves_of(maker);
    run.probes.values[2] = run.probes.values[1];  // the second gauge saw what the first saw
    EXPECT_GT(analyse_waves(run, {}).reflection->parts.misfit, 0.05);
}

TEST(WaveReport, without_a_wave_maker_period_and_depth_are_asked_for) {
    const RecordedRun run = waves_of("");
    const WaveReport bare = analyse_waves(run, {});
    EXPECT_FALSE(bare.reflection);
    EXPECT_THAT(bare.why_no_reflection, HasSubstr("give one, and a depth"));
    EXPECT_NEAR(bare.from, 6.35, 1e-12);
    EXPECT_NEAR(bare.gauges[0].waves.mean_period, period, 1e-3);
    const WaveReport asked = analyse_waves(run, {.period = period, .depth = depth});
    ASSERT_TRUE(asked.reflection);  // along +x now: what runs towards -x is the reflected one
    EXPECT_NEAR(2 * asked.reflection->parts.incident, reflected_height, 1e-12);
    EXPECT_FALSE(analyse_waves(run, {.period = period}).reflection);
}

TEST(WaveReport, gauges_that_cannot_tell_are_said_to_be_so) {
    const RecordedRun half = waves_of(maker, {1.0, 1.0 + 0.5 * linear.length()});
    EXPECT_THAT(analyse_waves(half, {}).why_no_reflection, HasSubstr("half a wavelength"));
    const WaveReport one = analyse_waves(waves_of(maker), {.gauges = {"g2"}});
    EXPECT_EQ(one.gauges.size(), 1U);
    EXPECT_THAT(one.why_no_reflection, HasSubstr("two gauges"));
}

TEST(WaveReport, what_cannot_be_answered_is_refused_with_the_reason) {
    const RecordedRun run = waves_of(maker);
    const auto refused = [&](const WaveRequest& request, const std::string& why) {
        EXPECT_THAT([&] { analyse_waves(run, request); }, ThrowsMessage<BadRequest>(HasSubstr(why)));
    };
    refused({.gauges = {"g4"}}, "no level or surface gauge 'g4'");
    refused({.gauges = {"p"}}, "it has g1, g2, g3");
    refused({.from = 20.0}, "the record goes from 0 to 12.7 s");
    refused({.from = 12.0}, "less than one period of 1.5 s");
    EXPECT_THAT([] { analyse_waves(waves_of(maker, {}), {}); }, ThrowsMessage<BadRequest>(HasSubstr("no gauge")));
}

}  // namespace
}  // namespace riprap::view
