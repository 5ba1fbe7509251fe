// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/run_fixture.hpp"

namespace riprap {
namespace {

using ::testing::HasSubstr;

class Frames : public RunFixture {};

TEST_F(Frames, EveryFrameOfARunOpensInVtksOwnReader) {
    ASSERT_EQ(run({"run", case_file(), "--out", out("a"), "--set", "end=0.035"}).code, 0);
    const std::string command =
        "/usr/bin/python3 tests/cli/open_with_vtk.py '" + out("a") + "' >'" + out("said") + "' 2>&1";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == 77 || WEXITSTATUS(status) == 127) {
        GTEST_SKIP() << "VTK's Python modules are not installed (Debian: python3-vtk9)";
    }
    EXPECT_EQ(WEXITSTATUS(status), 0) << text_of(out("said"));
    // Frames at 0, 0.01, 0.02, 0.03 and the end: one half-space as a square, three boxes.
    EXPECT_THAT(text_of(out("said")), HasSubstr("out.pvd: 5 frames, 95 cells"));
    EXPECT_THAT(text_of(out("said")), HasSubstr("contacts.pvd: 5 frames"));
}

}  // namespace
}  // namespace riprap
