// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "cli/run_fixture.hpp"

namespace riprap {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

/// plot, view and the report of validate: what needs no browser.
class Looking : public RunFixture {
 protected:
    void have_run() const { ASSERT_EQ(run({"run", case_file(), "--out", out("run"), "--set", "end=0.01"}).code, 0); }
    Ending plot(const std::vector<std::string>& options) const {
        std::vector<std::string> words{"plot", out("run"), "--out", out("plot.svg")};
        words.insert(words.end(), options.begin(), options.end());
        return run(words);
    }
};

TEST_F(Looking, AReportIsWrittenBesideTheTableAndNotInsteadOfIt) {
    const Ending ending = run({"validate", "rigid/free_fall", "--report", out("report")});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_THAT(ending.out, HasSubstr("way after sqrt(2 h/g) [m]"));
    EXPECT_THAT(
        ending.out,
        ContainsRegex("rigid, physics: [0-9]+ reproduced, 0 close, 0 not reproduced.*\n.*report/index.html\n$"));
    EXPECT_TRUE(std::filesystem::exists(out("report") + "/index.html"));
}

TEST_F(Looking, APlotIsNotWrittenUnderTheNameOfAnotherFormat) {
    have_run();
    const Ending ending = run({"plot", out("run"), "--out", out("plot.jpg")});
    EXPECT_EQ(ending.code, 2);
    EXPECT_THAT(ending.err, HasSubstr("must end in .svg"));
    EXPECT_FALSE(std::filesystem::exists(out("plot.jpg")));
}

TEST_F(Looking, APlotHasTheSizeAndTheWordsThatAreAskedFor) {
    have_run();
    ASSERT_EQ(plot({"--column", "max_speed", "--size", "127x76.2", "--title", "T", "--x-label", "t / s", "--y-label",
                    "x / m"})
                  .code,
              0);
    const std::string svg = text_of(out("plot.svg"));
    EXPECT_THAT(svg, HasSubstr("width='480' height='288'"));  // 127 mm are five inches of 96 px
    for (const char* word : {">T<", ">t / s<", ">x / m<"}) {
        EXPECT_THAT(svg, HasSubstr(word));
    }
    for (const char* size : {"", "100", "100x", "x100", "49x90", "100x1001", "100x90mm", "nanx90", "1e2x90x"}) {
        EXPECT_EQ(plot({"--size", size}).code, 2) << size;
    }
    EXPECT_EQ(plot({"--dpi", "1"}).code, 2);
}

TEST_F(Looking, APageIsNotWrittenOverACase) {
    have_run();
    write_file("mine.toml", "title = \"mine\"");
    const Ending ending = run({"view", out("run"), "--out", out("mine.toml")});
    EXPECT_EQ(ending.code, 2);
    EXPECT_THAT(ending.err, HasSubstr("must end in .html"));
    EXPECT_EQ(text_of(out("mine.toml")), "title = \"mine\"");
}

TEST_F(Looking, APlotWithoutAColumnDrawsGaugesAndWithoutGaugesEnergies) {
    have_run();
    EXPECT_EQ(plot({}).code, 0);
    EXPECT_THAT(text_of(out("plot.svg")), Not(HasSubstr("_energy")));
    write_file("run/probes.csv", "time [s]\n0\n");
    EXPECT_EQ(plot({}).code, 0);
    EXPECT_THAT(text_of(out("plot.svg")), HasSubstr("solid.kinetic"));
    EXPECT_THAT(text_of(out("plot.svg")), HasSubstr("change since the start [J]"));
    EXPECT_THAT(text_of(out("plot.svg")), Not(HasSubstr("contact_count")));
}

TEST_F(Looking, AMisspeltColumnIsAnsweredWithTheNearestOne) {
    have_run();
    const Ending ending = plot({"--column", "solid.kinetik"});
    EXPECT_EQ(ending.code, 2);
    EXPECT_THAT(ending.err, HasSubstr("did you mean 'solid.kinetic'?"));
    EXPECT_THAT(ending.err, Not(HasSubstr("contact_count")));
}

TEST_F(Looking, WavesOfARunWithoutLevelGaugesAreABadCommandLine) {
    have_run();
    const Ending ending = run({"waves", out("run")});
    EXPECT_EQ(ending.code, 2);
    EXPECT_THAT(ending.err,
                HasSubstr("gauges of kind 'level', or of kind 'surface' along an upright line; the run has none"));
    EXPECT_EQ(run({"waves", out("run"), "--period", "-1"}).code, 2);
    EXPECT_EQ(run({"waves", out("nothing")}).code, 5);
}

TEST_F(Looking, ColumnsOfUnlikeUnitsAreDrawnBelowEachOther) {
    have_run();
    const Ending ending = plot({"--column", "solid.kinetic", "--column", "max_speed"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    const std::string svg = text_of(out("plot.svg"));
    EXPECT_THAT(svg, HasSubstr("solid.kinetic [J]"));
    EXPECT_THAT(svg, HasSubstr("max_speed [m/s]"));
}

TEST_F(Looking, ATableThatCannotBeReadIsTold) {
    have_run();
    write_file("run/ledger.csv", "garbage\n");
    EXPECT_THAT(plot({}).err, HasSubstr("ledger.csv': it is no table of a run"));
    write_file("run/probes.csv", "garbage\n");
    const Ending ending = plot({});
    EXPECT_EQ(ending.code, 5);
    EXPECT_THAT(ending.err, HasSubstr("neither probes.csv nor ledger.csv has a row that can be read"));
}

}  // namespace
}  // namespace riprap
