// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "io/temporary_folder.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/view/validation_report.hpp"

namespace riprap::view {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* results = R"({"suite": "all", "results": [
 {"case": "zhao/incline", "quantity": "slip < rest", "unit": "m", "paper": "it slides", "exact": 0.9, "value": 0.91,
  "low": 0.8, "high": 1.0, "verdict": "reproduced", "note": "", "seconds": 1},
 {"case": "water/leak", "quantity": "volume", "unit": "-", "paper": null, "exact": null, "value": 1.5,
  "low": 0.9, "high": 1.1, "verdict": "not_reproduced", "note": "it leaks", "seconds": 2}]})";

TEST(ValidationReport, HasEveryResultRedsIncludedWithPlotsAndWordsOfItsSuite) {
    const TemporaryFolder folder;
    io::make_folder(folder / "report/water");
    io::make_folder(folder / "suites/water");
    std::ofstream(folder / "report/water/leak.svg") << "<?xml version=\"1.0\"?>\n<svg><text>level</text></svg>";
    std::ofstream(folder / "suites/water/README.md") << "Assumed: no <air>";
    const auto page = write_validation_report(folder / "report", results, folder / "suites");
    const std::string text = io::read_file(page, 1U << 20U);
    EXPECT_THAT(text, HasSubstr("1 reproduced, 1 not reproduced"));
    EXPECT_THAT(text, HasSubstr("slip &lt; rest"));
    EXPECT_THAT(text, HasSubstr("<b class=\"not_reproduced\">not reproduced</b></td><td>it leaks"));
    EXPECT_THAT(text, HasSubstr("<figure><svg><text>level</text></svg></figure>"));
    EXPECT_THAT(text, HasSubstr("Assumed: no &lt;air&gt;"));
    EXPECT_THAT(text, Not(HasSubstr("<?xml")));
    EXPECT_LT(text.find("<h2>zhao</h2>"), text.find("<h2>water</h2>"));
}

}  // namespace
}  // namespace riprap::view
