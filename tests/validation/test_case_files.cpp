// SPDX-License-Identifier: Apache-2.0
// Published cases that are case files: they run as everybody's do, and what they expect is judged.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/validation/case_files.hpp"

namespace riprap::validation {
namespace {

/// A driven block that swings with a period of 0.5 s, and a block that slides on ice at 2 m/s beside it.
const std::string two_blocks = R"(
dimension = 2
gravity = [0.0, -9.81]
settle = 0.1
end = 1.4
[material.ice]
density = 2500.0
normal_stiffness = 1.0e6
damping_ratio = 0.5
[[body]]
name = "ground"
shape = { half_space = { normal = [0.0, 1.0] } }
material = "ice"
fixed = true
[[body]]
name = "swing"
shape = { box = [0.2, 0.2] }
position = [0.0, 5.0]
material = "ice"
motion = { sinusoidal = { amplitude = [0.1, 0.0], period = 0.5 } }
[[body]]
name = "slider"
shape = { box = [1.0, 0.2] }
position = [1.0, 0.1]
velocity = [2.0, 0.0]
material = "ice"
load = [{ force = [1.0e4, 0.0], start = 1.4 }]
[[expect]]
name = "period"
quantity = "swing.displacement.x"
reduce = "period"
value = 0.5
relative_tolerance = 1.0e-3
citation = "its motion"
[[expect]]
name = "place"
quantity = "slider.position.x"
value = 3.8
tolerance = 1.0e-3
bookkeeping = true
citation = "x + v t"
)";

std::vector<Result> results_of(const std::string& text) {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();  // others run beside it
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("two_blocks_" + test);
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "case.toml") << text;
    CaseReport report("two_blocks");
    run_case_file({.folder = folder, .results = {}}, report);
    return report.results();
}

TEST(CaseFiles, APeriodIsTheTimeBetweenPassagesInOneDirection) {
    const std::vector<Result> results = results_of(two_blocks);
    ASSERT_EQ(results.size(), 2U);
    EXPECT_NEAR(results[0].value, 0.5, 1e-4);
    EXPECT_EQ(results[0].unit, "s");
    EXPECT_EQ(results[0].verdict, Verdict::reproduced);
    EXPECT_EQ(results[0].kind, Kind::physics);
}

TEST(CaseFiles, BodiesSettleFromRestAndTheirVelocityBeginsAtTime0) {
    const std::vector<Result> results = results_of(two_blocks);
    EXPECT_NEAR(results.at(1).value, 3.8, 1e-3);  // 4.0 where it slid while it settled, more where its load acted
    EXPECT_EQ(results.at(1).kind, Kind::bookkeeping);
}

TEST(CaseFiles, AnAnswerDueAfterTheEndIsJudgedInTheLongerRunAlone) {
    const std::vector<Result> results =
        results_of(two_blocks +
                   "[[expect]]\nname = \"late place\"\nquantity = \"slider.position.x\"\nreduce = \"at\"\nat = 1.5\n"
                   "value = 4.1\ntolerance = 1.0e-3\ncitation = \"x + v t + F (t - 1.4)^2/(2 m)\"\n"
                   "[[vary]]\nkey = \"end\"\nvalues = [1.5]\n");
    ASSERT_EQ(results.size(), 5U);  // two of the case as it stands, three of the longer run
    EXPECT_EQ(results.back().quantity, "late place; end = 1.5");
    EXPECT_EQ(results.back().verdict, Verdict::reproduced);
}

TEST(CaseFiles, EveryRunOfAVaryIsJudgedByItsOwnValueAndAWrongOneIsRed) {
    const std::vector<Result> results =
        results_of(two_blocks +
                   "[[vary]]\nkey = \"body.swing.motion.sinusoidal.period\"\nvalues = [0.25, 0.3]\n"
                   "[[vary.expect]]\nname = \"period\"\nvalues = [0.25, 0.25]\n");
    ASSERT_EQ(results.size(), 6U);
    EXPECT_EQ(results[2].verdict, Verdict::reproduced);
    EXPECT_EQ(results[4].verdict, Verdict::not_reproduced);
    EXPECT_NEAR(results[4].value, 0.3, 1e-4);
}

TEST(CaseFiles, ARatioIsThatOfARunOverTheCaseAsItStands) {
    const std::string ratio =
        "[[vary]]\nkey = \"body.swing.motion.sinusoidal.period\"\nvalues = [0.25, 0.3]\n"
        "[[vary.expect]]\nname = \"period\"\nvalues = [0.25, 0.3]\n[[vary.ratio]]\nname = "
        "\"period\"\nvalue = 0.5\ntolerance = 0.01\ncitation = \"its key\"\n";
    const std::vector<Result> results = results_of(two_blocks + ratio);
    ASSERT_EQ(results.size(), 8U);
    EXPECT_NEAR(results[6].value, 0.5, 1e-3);
    EXPECT_EQ(results[6].verdict, Verdict::reproduced);
    EXPECT_NEAR(results[7].value, 0.6, 1e-3);
    EXPECT_EQ(results[7].verdict, Verdict::not_reproduced);
}

TEST(CaseFiles, AnOrderIsTheSlopeOfTheErrorOverTheKeyAndAWrongOneIsRed) {
    // The period is expected to be twice the key: its error is the key, to the first order.
    const std::string order =
        "[[vary]]\nkey = \"body.swing.motion.sinusoidal.period\"\nvalues = [0.2, 0.4]\n"
        "[[vary.expect]]\nname = \"period\"\nvalues = [0.4, 0.8]\n";
    const auto expected = [](const std::string& value) {
        return "[[vary.order]]\nname = \"period\"\nvalue = " + value + "\ntolerance = 0.05\ncitation = \"its key\"\n";
    };
    const std::vector<Result> results = results_of(two_blocks + order + expected("1.0") + expected("2.0"));
    ASSERT_EQ(results.size(), 8U);
    EXPECT_NEAR(results[6].value, 1, 0.01);
    EXPECT_EQ(results[6].verdict, Verdict::reproduced);
    EXPECT_EQ(results[7].verdict, Verdict::not_reproduced);
}

TEST(CaseFiles, WhatIsOnlyToldIsUnderSpecified) {
    const std::vector<Result> results = results_of(
        two_blocks + "[[expect]]\nname = \"end\"\nquantity = \"time\"\nreported = true\ncitation = \"no source\"\n");
    ASSERT_EQ(results.size(), 3U);
    EXPECT_EQ(results[2].verdict, Verdict::under_specified);
    EXPECT_EQ(results[2].value, 1.4);
    EXPECT_EQ(results[2].note, "no source");
}

TEST(CaseFiles, WhatIsOnlyToldAndNeverComesIsRed) {
    const std::vector<Result> results =
        results_of(two_blocks +
                   "[[expect]]\nname = \"never\"\nquantity = \"time\"\nreduce = \"when\"\nwhen = \"time\"\n"
                   "reaches = -1.0\nreported = true\ncitation = \"no source\"\n");
    ASSERT_EQ(results.size(), 3U);
    EXPECT_EQ(results[2].verdict, Verdict::not_reproduced);
}

TEST(CaseFiles, ALongRunIsLeftOutAndAVaryOfAKeyThatDoesNotExistIsRefused) {
    const std::vector<Result> results =
        results_of(two_blocks + "[[vary]]\nkey = \"end\"\nvalues = [1.0]\nfull = true\n");
    EXPECT_EQ(results.size(), 2U);  // only in the long version
    EXPECT_THROW(results_of(two_blocks + "[[vary]]\nkey = \"ends\"\nvalues = [1.0]\n"), CaseError);
}

// The seed moves the slider at random by up to a decimetre along each axis: means differ from each of the three.
TEST(CaseFiles, MeansOverSeedsAreJudged) {
    const std::string jitter =
        "repeat = { counts = [1, 1], jitter = 0.1 }\nmotion = { linear = { velocity = [0.0, 0.0] } }\n";
    std::string text = two_blocks;
    text.erase(text.find("load = "), text.find("[[expect]]") - text.find("load = "));
    text.insert(text.find("[[expect]]"), jitter);
    text.erase(text.find("velocity = [2.0, 0.0]"), sizeof("velocity = [2.0, 0.0]") - 1);
    text.replace(text.find("slider.position.x"), sizeof("slider.position.x") - 1, "slider[0].position.x");
    const auto place = [&text](const std::string& top) { return results_of(top + text).at(1).value; };
    const double one = place("seed = 4\n"), two = place("seed = 5\n"), three = place("seed = 6\n");
    EXPECT_NE(one, two);
    EXPECT_NEAR(place("seed = 4\nseeds = 3\n"), (one + two + three) / 3, 1e-12);
    EXPECT_EQ(place("seed = 4\nseeds = 1\n"), one);
}

TEST(CaseFiles, OneWordStandsForSeveralKeys) {
    const std::vector<Result> results =
        results_of(two_blocks +
                   "[material.snow]\ndensity = 2500.0\nnormal_stiffness = 1.0e6\ndamping_ratio = 0.5\n"
                   "[[vary]]\nkey = [\"body.ground.material\", \"body.slider.material\"]\nwords = [\"snow\"]\n");
    ASSERT_EQ(results.size(), 4U);
    EXPECT_NEAR(results[3].value, 3.8, 1e-3);
}

TEST(CaseFiles, EachPublishedCaseFileCanBeReadAndTakesFiveSteps) {
    const std::vector<ValidationCase> cases = file_cases();
    EXPECT_GT(cases.size(), 15U);
    const std::vector<std::string> soon{"settle=1e-4"}, as_it_stands;
    for (const ValidationCase& one : cases) {
        SCOPED_TRACE(std::string(one.suite) + "/" + std::string(one.name));
        const std::filesystem::path file =
            std::filesystem::path(RIPRAP_SOURCE_DIR "/validation") / one.suite / one.name / "case.toml";
        std::stringstream text;
        text << std::ifstream(file).rdbuf();
        const bool settles = text.str().find("\nsettle ") != std::string::npos;
        run::Simulation simulation(scene::read_case(file.string(), settles ? soon : as_it_stands));
        for (int i = 0; i < 5 && simulation.steps_left() > 0; ++i) {
            EXPECT_TRUE(simulation.step(sim::Measure::flow).is_accepted());
        }
    }
}

}  // namespace
}  // namespace riprap::validation
