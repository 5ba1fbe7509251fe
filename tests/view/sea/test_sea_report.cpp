// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/sea/sea_report.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/temporary_folder.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/view/bad_request.hpp"
#include "riprap/wave/analysis/sea_statistics.hpp"
#include "riprap/wave/irregular_wave.hpp"

namespace riprap::view {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

constexpr double depth = 0.7, height = 0.12, peak = 1.6, reflection = 0.35;

/// A sea at three gauges with its echo, run-up of 1.5 times the surface on a slope of 1 : 2 as a gauge along it reads
/// it, and water over a crest where that is above 0.1 m; in the plane.
RecordedRun sea_run(std::uint64_t seed, double duration = 400) {
    const wave::IrregularWave sea = wave::jonswap_sea(height, peak, 3.3, depth, 9.81, 120, seed);
    RecordedRun run;
    run.is_planar = true;
    run.gravity = {0, -9.81, 0};
    run.resolved_text =
        "[[body]]\nname = \"paddle\"\nmotion = { wave_maker = { wave = \"irregular\", direction = [1.0, 0.0], depth = "
        "0.7 } "
        "}\n";
    run.probes.columns = {{"time", "s"},          {"g1", "m"}, {"g2", "m"}, {"g3", "m"}, {"up", "m"}, {"over", "m^2/s"},
                          {"wall.force.x", "N/m"}};
    run.probes.values.resize(run.probes.columns.size());
    const std::vector<double> places{2.0, 2.45, 3.25};
    for (std::size_t m = 0; m < 3; ++m) {
        run.resolved_text +=
            fmt::format("[[output.gauge]]\nname = \"g{}\"\nkind = \"level\"\npoint = [{}, 0.0]\n", m + 1, places[m]);
    }
    run.gauges = {{"up", "run_up", {10, 0.5, 0}, Vec3{12, 1.5, 0}}, {"over", "flow", {11, 1, 0}, Vec3{11, 2, 0}}};
    for (double t = 0; t < duration; t += 0.08) {
        std::vector<double>* column = run.probes.values.data();
        (column++)->push_back(t);
        for (const double x : places) {
            (column++)->push_back(depth + sea.elevation(x, t) + reflection * sea.elevation(22 - x, t));
        }
        const double up = t == 0 ? 0 : 1.5 * sea.elevation(11, t);  // above still water
        (column++)->push_back(0.4 + up * std::sqrt(5.0));           // along the slope
        (column++)->push_back(std::max(0.0, up - 0.1));
        (column++)->push_back(1000 * sea.elevation(12, t));
    }
    return run;
}

double value_of(const SeaReport& report, const std::string& name) {
    for (const SeaNumber& one : report.numbers) {
        if (one.name == name) {
            return one.value;
        }
    }
    ADD_FAILURE() << name;
    return 0;
}

TEST(SeaReport, HasTheNumbersOfASeaWithItsEcho) {
    SeaRequest request;
    request.waves.from = 20;
    request.forces = {"wall.force.x"};
    const SeaReport report = sea_report({sea_run(3)}, request);
    EXPECT_NEAR(value_of(report, "K_r"), reflection, 0.02);
    EXPECT_NEAR(value_of(report, "H_m0 incident"), height, 0.03 * height);
    EXPECT_NEAR(value_of(report, "T_m-1,0 incident"), peak / 1.1, 0.04 * peak);
    // As the sea has them without its echo; its run-up is 1.5 times crests of about H/2.
    const wave::IrregularWave sea = wave::jonswap_sea(height, peak, 3.3, depth, 9.81, 120, 3);
    std::vector<double> time, level, heights;
    for (double t = 20; t < 400; t += 0.08) {
        time.push_back(t);
        level.push_back(sea.elevation(2.0, t));
    }
    for (const wave::ZeroCrossingWave& one : wave::zero_crossing_waves(time, level)) {
        heights.push_back(one.height);
    }
    const double high = wave::exceeded_by(heights, 0.02, static_cast<double>(heights.size()));
    EXPECT_NEAR(value_of(report, "H_2% incident") / high, 1, 0.05);
    EXPECT_NEAR(value_of(report, "R_u2% up") / height, 1.5 * 0.7, 0.12);
    EXPECT_GT(value_of(report, "max 1/250 wall.force.x"), 1000 * 0.75 * height);
    EXPECT_LT(value_of(report, "min 1/250 wall.force.x"), -1000 * 0.75 * height);
    ASSERT_EQ(report.volumes.size(), 1U);
    const wave::OvertoppingVolumes& over = report.volumes[0].volumes;
    double sum = over.rest;
    for (const wave::OvertoppingWave& wave : over.waves) {
        sum += wave.volume;
    }
    EXPECT_NEAR(sum, over.total, 1e-9 * over.total);
    EXPECT_NEAR(value_of(report, "q over"), 1e3 * over.total / over.duration, 1e-9);
    EXPECT_NEAR(value_of(report, "V_max over"), 1e3 * over.largest(), 1e-9);
    EXPECT_THAT(report.notices, Not(Contains(HasSubstr("left out"))));
}

TEST(SeaReport, MoreSeedsMakeNarrowerBandsThatHoldTheSea) {
    SeaRequest request;
    request.waves.from = 20;
    const SeaReport one = sea_report({sea_run(3)}, request);
    const SeaReport three = sea_report({sea_run(3), sea_run(4), sea_run(5)}, request);
    const auto band_of = [](const SeaReport& report, const std::string& name) {
        for (const SeaNumber& number : report.numbers) {
            if (number.name == name) {
                return std::pair(number.low, number.high);
            }
        }
        return std::pair(0.0, 0.0);
    };
    for (const char* name : {"K_r", "H_m0 incident", "H_m0 g1"}) {
        const auto [a, b] = band_of(one, name);
        const auto [c, d] = band_of(three, name);
        EXPECT_LT(d - c, b - a) << name;
    }
    const auto [low, high] = band_of(three, "H_m0 incident");
    EXPECT_LT(low, height);
    EXPECT_GT(high, height);
    EXPECT_EQ(three.volumes.size(), 3U);
}

TEST(SeaReport, TooFewWavesAreToldAndHaveNoNumbersOfTwoPercent) {
    const SeaReport report = sea_report({sea_run(3, 120)}, {});
    EXPECT_TRUE(std::isnan(value_of(report, "H_2% g1")));
    EXPECT_TRUE(std::isnan(value_of(report, "R_u2% up")));
    EXPECT_THAT(report.notices, Contains(HasSubstr("numbers of 2 % take 200")));
    EXPECT_THAT(sea_text(report), HasSubstr("waves: R_u2% takes 200"));
}

TEST(SeaReport, GaugesHalfAWaveApartAreTold) {
    RecordedRun run = sea_run(3);
    SeaRequest request;
    request.waves.gauges = {"g1", "g3"};  // 1.25 m: half of waves of 1.28 s
    const SeaReport report = sea_report({run}, request);
    EXPECT_THAT(report.notices, Contains(AllOf(HasSubstr("are left out"), HasSubstr("half a wave length apart"))));
    EXPECT_THAT(report.notices, Contains(HasSubstr("two gauges cannot tell noise")));
    EXPECT_NEAR(value_of(report, "K_r"), reflection, 0.03);
}

TEST(SeaReport, FormulasStandBesideTheRunWithTheirSources) {
    SeaRequest request;
    request.given = {{"cot_slope", 2}, {"freeboard", 0.1}, {"roughness", 1}};
    const SeaReport report = sea_report({sea_run(3)}, request);
    const std::string text = sea_text(report);
    EXPECT_THAT(text, AllOf(HasSubstr("run-up that 2 % exceed: R_u2% = "), HasSubstr("; the run "),
                            HasSubstr("[EurOtop2018, eqs. 5.10, 5.11]"), Not(HasSubstr("Goda"))));
    request.given["cot_slope"] = 1;
    EXPECT_THAT(sea_text(sea_report({sea_run(3)}, request)), HasSubstr("OUTSIDE OF ITS RANGE"));
    request.given = {{"cot_slop", 2}};
    EXPECT_THAT([&] { sea_report({sea_run(3, 120)}, request); },
                ThrowsMessage<BadRequest>(HasSubstr("did you mean 'cot_slope'?")));
    SeaRequest other;
    other.forces = {"wall.force"};
    EXPECT_THAT([&] { sea_report({sea_run(3, 120)}, other); }, ThrowsMessage<BadRequest>(HasSubstr("wall.force.x")));
}

TEST(SeaReport, IsWrittenAsTablesAndAFigure) {
    const TemporaryFolder place;
    const SeaReport report = sea_report({sea_run(3, 200)}, {});
    const std::vector<std::filesystem::path> files = write_sea(place.path() / "sea", report);
    ASSERT_EQ(files.size(), 4U);
    EXPECT_THAT(io::read_file(files[0], 1U << 20U), HasSubstr("\"K_r\",-,"));
    EXPECT_THAT(io::read_file(files[1], 1U << 20U), HasSubstr("frequency [1/s],incident [m^2 s]"));
    EXPECT_THAT(io::read_file(files[2], 1U << 20U), HasSubstr("Incident and reflected sea"));
    const nlohmann::json json = nlohmann::json::parse(sea_json(report));
    EXPECT_EQ(json.at("volumes").at(0).at("gauge"), "over");
    EXPECT_EQ(json.at("spectrum").at("incident").size(), report.reflection.frequency.size());
}

}  // namespace
}  // namespace riprap::view
