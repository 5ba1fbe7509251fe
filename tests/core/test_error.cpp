// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "riprap/core/error.hpp"

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

TEST(Assertion, NamesExpressionAndValues) {
    try {
        assertion_failed("r > 0", "shape.cpp", 12, "r = -1");
    } catch (const InternalError& error) {
        EXPECT_STREQ(error.what(), "shape.cpp:12: assertion failed: r > 0 (r = -1)");
    }
}

}  // namespace
}  // namespace riprap
