// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"

namespace riprap {
namespace {

TEST(CaseError, CarriesEveryProblemWithItsPlace) {
    std::vector<Diagnostic> problems(2);
    problems[0].place = {"case.toml", 3, 8};
    problems[0].message = "unknown key 'gravty'";
    problems[0].allowed = "did you mean 'gravity'?";
    problems[1].place.file = "case.toml";
    problems[1].message = "no [[body]]";
    const CaseError error(problems);
    EXPECT_EQ(error.problems().size(), 2U);
    EXPECT_STREQ(error.what(), "case.toml:3:8: unknown key 'gravty'; did you mean 'gravity'?\ncase.toml: no [[body]]");
}

TEST(Diagnostic, PutsNoSemicolonAfterAQuestion) {
    const Diagnostic problem{{}, "'t/m3' is no unit; did you mean 't/m^3'?", "a density"};
    EXPECT_EQ(to_string(problem), "'t/m3' is no unit; did you mean 't/m^3'? a density");
}

TEST(Assertion, NamesExpressionAndValues) {
    try {
        assertion_failed("r > 0", "shape.cpp", 12, "r = -1");
    } catch (const InternalError& error) {
        EXPECT_STREQ(error.what(), "shape.cpp:12: assertion failed: r > 0 (r = -1)");
    }
}

TEST(Printable, ShowsWhatATerminalWouldObeyAndLeavesLettersAlone) {
    EXPECT_EQ(printable("a\x1b[2Jb\x07\r\x7f"), "a\\x1b[2Jb\\x07\\x0d\\x7f");
    EXPECT_EQ(printable("\xc2\x9b"
                        "1m"),
              "\\x9b1m");  // a C1 control character in UTF-8
    const std::string plain =
        "Gr\xc3\xb6\xc3\x9f"
        "e \xc2\xb5m\n\tand \xe2\x88\x9e";
    EXPECT_EQ(printable(plain), plain);
}

}  // namespace
}  // namespace riprap
