// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "io/temporary_folder.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/folder/provenance.hpp"
#include "riprap/view/validation_report.hpp"

namespace riprap::view {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* results = R"({"suite": "all", "results": [
 {"case": "zhao/incline", "quantity": "slip < rest", "unit": "m", "paper": "it slides", "exact": 0.9, "value": 0.91,
  "low": 0.8, "high": 1.0, "verdict": "reproduced", "note": "", "seconds": 1},
 {"case": "water/leak", "quantity": "volume", "unit": "-", "paper": null, "exact": null, "value": 1.5,
  "low": 0.9, "high": 1.1, "verdict": "not_reproduced", "note": "it leaks", "seconds": 2},
 {"case": "water/leak", "kind": "bookkeeping", "quantity": "mass", "unit": "-", "paper": null, "exact": 1, "value": 1,
  "low": 0.9, "high": 1.1, "verdict": "reproduced", "note": "", "seconds": 2}]})";

class AReport : public ::testing::Test {
 protected:
    AReport() {
        write("suites/water/README.md", "Assumed: no <air>");
        write("suites/zhao/incline/README.md", "Choices: 30 degrees");
        text_ = io::read_file(write_validation_report(folder_ / "report", results, folder_ / "suites"), 1U << 20U);
    }
    /// Where the first of these words stands.
    std::size_t at(const std::string& words) const {
        EXPECT_NE(text_.find(words), std::string::npos) << words;
        return text_.find(words);
    }
    std::string text_;

 private:
    void write(const std::string& name, const std::string& content) const {
        io::make_folder((folder_ / name).parent_path());
        std::ofstream(folder_ / name) << content;
    }
    TemporaryFolder folder_;
};

TEST_F(AReport, HasEveryResultRedsIncluded) {
    EXPECT_LT(at("physics: <b class=reproduced"), at(">1 reproduced</b>, <b class=not_reproduced"));
    EXPECT_LT(at(">1 reproduced</b>, <b class=not_reproduced"), at(">1 not reproduced</b>; bookkeeping: <b"));
    EXPECT_LT(at("it leaks"), at("<th colspan=8>bookkeeping</th></tr>\n<tr><td>mass"));
    EXPECT_THAT(text_, HasSubstr("slip &lt; rest"));
    EXPECT_THAT(text_, HasSubstr("<b class=\"not_reproduced\">not reproduced</b></td><td>it leaks"));
}

TEST_F(AReport, SaysWhenWithWhatAndOnWhatItWasMadeAndWhatItsVerdictsMean) {
    const nlohmann::json build = nlohmann::json::parse(run::build_json()),
                         machine = nlohmann::json::parse(run::machine_json());
    EXPECT_THAT(text_, ContainsRegex("<p>20[0-9][0-9]-[01][0-9]-[0-3][0-9] [0-9:]+ UTC"));
    EXPECT_THAT(text_, HasSubstr("Riprap " + build["version"].get<std::string>()));
    EXPECT_THAT(text_, HasSubstr(fmt::format("{} threads", machine["hardware_threads"].get<int>())));
    EXPECT_LT(at("UTC"), at("<dt><b class=close>close</b></dt><dd>outside it, inside a wider band"));
    EXPECT_LT(at("<dt><b class=under_specified>under-specified</b></dt>"), at("<table"));
}

TEST_F(AReport, ShowsEveryCaseWithItsOwnWords) {
    EXPECT_LT(at("<h2>zhao</h2>"), at("<h3 id=\"zhao/incline\">"));
    EXPECT_LT(at("<h3 id=\"zhao/incline\">"), at("Choices: 30 degrees"));
    EXPECT_LT(at("Choices: 30 degrees"), at("<h2>water</h2>"));
    EXPECT_LT(at("Assumed: no &lt;air&gt;"), at("<h3 id=\"water/leak\">"));
}

TEST_F(AReport, SaysWhereMoreCasesAreToCome) {
    const TemporaryFolder folder;
    const auto text_of = [&](bool is_whole) {
        return io::read_file(write_validation_report(folder.path(), results, folder / "suites", is_whole), 1U << 20U);
    };
    EXPECT_THAT(text_of(false), HasSubstr("the cases so far"));
    EXPECT_THAT(text_of(true), Not(HasSubstr("the cases so far")));
}

TEST_F(AReport, BeginsWithTheVerdictOfEveryCase) {
    const std::size_t red = at("<a href=\"#water/leak\">water/leak</a></td><td>physics: <b class=not_reproduced");
    EXPECT_LT(red, at("<h2>"));
}

TEST(AReportOfAllMethods, has_one_table_with_methods_across_and_the_causes_of_wrong_cells) {
    const TemporaryFolder folder;
    const std::string text = io::read_file(write_validation_report(folder.path(), R"({"suite": "cross", "results": [
 {"case": "seam", "quantity": "speed: planar_dda", "unit": "m/s", "paper": null, "exact": 3, "value": 1.54,
  "low": 2.97, "high": 3.03, "verdict": "close", "note": "", "seconds": 1}], "cells": [
 {"scene": "seam", "solid": "planar_dda", "fluid": "none", "variation": "", "is_energy": false, "finding": "wrong",
  "value": 1.54, "why": "speed: 1.54 for 2.97 to 3.03", "cause": "sees two blocks only", "seconds": 0.1},
 {"scene": "seam", "solid": "sphere_dem", "fluid": "none", "variation": "", "is_energy": false, "finding": "right",
  "value": 3.0, "why": "", "cause": "", "seconds": 0.1}]})",
                                                                   folder / "suites", true),
                                           1U << 20U);
    EXPECT_THAT(text, HasSubstr("<tr><th>scene</th><th></th><th>planar_dda</th><th>sphere_dem</th></tr>"));
    EXPECT_THAT(
        text, HasSubstr("<td class=\"cell wrong\" title=\"as it is: wrong 1.54; speed: 1.54 for 2.97 to 3.03; sees two "
                        "blocks only\n\">1.54</td><td class=\"cell right\""));
}

}  // namespace
}  // namespace riprap::view
