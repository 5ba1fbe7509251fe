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

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double period = 1.5, depth = 0.7, incident_height = 0.2, reflected_height = 0.06;
const wave::LinearWave linear = wave::linear_wave(incident_height, period, depth, 9.81);

const std::string maker =
    "[[body]]\nname = \"paddle\"\nmotion = { wave_maker = { wave = \"regular\", direction = "
    "[-1.0, 0.0], height = 0.2, period = 1.5, depth = 0.7 } }\n";

std::string gauge(const std::string& name, double x, const std::string& kind = "level", double lean = 0) {
    return fmt::format(
        "[[output.gauge]]\nname = \"{}\"\nkind = \"{}\"\npoint = [{:.17g}, 0.0, 0.0]\nend = [{:.17g}, 2.0, 0.0]\n",
        name, kind, x, x + lean);
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
        run.resolved_text += k == 0 ? gauge("p", 3.1, "pressure") + gauge("slope", 5.0, "surface", 0.1) : "";
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
    EXPECT_NEAR(report.gauges[0].waves.mean_level, depth, 2e-3);
    // Waves of the second half, 6.35 s, and harmonics of the four whole periods in it.
    EXPECT_NEAR(report.from, 6.35, 1e-12);
    EXPECT_NEAR(report.to, 12.7, 1e-12);
    EXPECT_NEAR(report.whole_from, 12.7 - 4 * period, 1e-12);
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
    EXPECT_THAT(bare.why_no_reflection,
                HasSubstr("no wave maker of the case makes regular waves: give a period and a depth"));
    EXPECT_NEAR(bare.from, 6.35, 1e-12);
    EXPECT_NEAR(bare.gauges[0].waves.mean_period, period, 1e-3);
    const WaveReport asked = analyse_waves(run, {.period = period, .depth = depth});
    ASSERT_TRUE(asked.reflection);  // along +x now: what runs towards -x is the reflected one
    EXPECT_NEAR(2 * asked.reflection->parts.incident, reflected_height, 1e-12);
    EXPECT_FALSE(analyse_waves(run, {.period = period}).reflection);
}

TEST(WaveReport, gauges_that_cannot_tell_are_said_to_be_so) {
    const RecordedRun half = waves_of(maker, {1.0, 1.0 + 0.5 * linear.length()});
    EXPECT_THAT(analyse_waves(half, {}).why_no_reflection, HasSubstr("cannot tell the two ways apart"));
    const WaveReport one = analyse_waves(waves_of(maker), {.gauges = {"g2"}});
    EXPECT_EQ(one.gauges.size(), 1U);
    EXPECT_THAT(one.why_no_reflection, HasSubstr("two gauges"));
}

TEST(WaveReport, a_gauge_without_values_is_named_and_left_out) {
    RecordedRun run = waves_of(maker);
    for (double& level : run.probes.values[2]) {
        level = std::nan("");
    }
    run.probes.values[1][1000] = std::nan("");
    const WaveReport report = analyse_waves(run, {});
    ASSERT_TRUE(report.reflection) << report.why_no_reflection;
    EXPECT_THAT(report.reflection->gauges, ElementsAre("g1", "g3"));
    EXPECT_NEAR(report.reflection->parts.reflection, 0.3, 1e-10);
    EXPECT_THAT(report.notices, ElementsAre(HasSubstr("'g1' has no value in 1 of 636 rows"),
                                            HasSubstr("'g2' has no value in 636 of 636 rows"),
                                            HasSubstr("'g2' has too few values for the reflection")));
    EXPECT_EQ(report.gauges[0].waves.count, analyse_waves(waves_of(maker), {}).gauges[0].waves.count - 1);
    EXPECT_THAT(wave_text(report), HasSubstr("'g2' has no value"));
}

TEST(WaveReport, still_water_reflects_nothing) {
    RecordedRun run = waves_of(maker);
    for (std::size_t k = 1; k < run.probes.values.size(); ++k) {
        for (std::size_t i = 0; i < run.probes.row_count(); ++i) {
            run.probes.values[k][i] = depth + (i % 3 == k ? 1e-16 : 0);
        }
    }
    EXPECT_THAT(analyse_waves(run, {}).why_no_reflection, HasSubstr("there are no waves of 1.5 s"));
}

TEST(WaveReport, paddles_that_do_not_agree_give_no_period) {
    const std::string other = std::string(maker).replace(maker.find("period = 1.5"), 12, "period = 1.6");
    EXPECT_THAT(analyse_waves(waves_of(maker + other), {}).why_no_reflection, HasSubstr("do not make the same waves"));
    EXPECT_TRUE(analyse_waves(waves_of(maker + maker), {}).reflection);
    const std::string damaged = std::string(maker).replace(maker.find("1.5"), 3, "\"x\"");
    EXPECT_FALSE(analyse_waves(waves_of(damaged), {}).reflection);
}

TEST(WaveReport, what_cannot_be_answered_is_refused_with_the_reason) {
    const RecordedRun run = waves_of(maker);
    const auto refused = [&](const WaveRequest& request, const std::string& why) {
        EXPECT_THAT([&] { analyse_waves(run, request); }, ThrowsMessage<BadRequest>(HasSubstr(why)));
    };
    refused({.gauges = {"g4"}}, "no level or surface gauge 'g4'");
    refused({.gauges = {"p"}}, "it has g1, g2, g3");
    refused({.from = 20.0}, "the record goes from 0 to 12.7 s");
    refused({.period = std::nan("")}, "no time, period or depth");
    refused({.depth = -1.0}, "above 0");
    refused({.direction = Vec3{}}, "the waves go nowhere");
    EXPECT_THAT(analyse_waves(run, {.from = 12.0}).why_no_reflection, HasSubstr("less than one period of 1.5 s"));
    EXPECT_THAT(analyse_waves(run, {.period = 0.03}).why_no_reflection, HasSubstr("rows are 0.00998 s apart"));
    EXPECT_THAT([] { analyse_waves(waves_of(maker, {}), {}); },
                ThrowsMessage<BadRequest>(HasSubstr("the run has none")));
}

TEST(WaveReport, ASingleWaveIsFoundInTheFirstHalfOfTheRunToo) {
    RecordedRun run = waves_of(maker, {3.0});
    for (std::size_t i = 0; i < run.probes.values[0].size(); ++i) {
        run.probes.values[1][i] = depth + 0.1 / std::pow(std::cosh(2 * (run.probes.values[0][i] - 2.5)), 2);
    }
    const GaugeWaves first = analyse_waves(run, {}).gauges[0];
    EXPECT_NEAR(first.rise, 0.1, 1e-4);
    EXPECT_NEAR(first.rise_time, 2.5, 1e-9);
    WaveRequest late;
    late.from = 5.0;
    EXPECT_LT(analyse_waves(run, late).gauges[0].rise, 1e-5);
}

}  // namespace
}  // namespace riprap::view
