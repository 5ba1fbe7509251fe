// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/run_fixture.hpp"

namespace riprap {
namespace {

using ::testing::HasSubstr;

/// A box afloat in a planar tank, over a floor that it does not touch.
constexpr const char* tank = R"(
dimension = 2
gravity = [0.0, -9.81, 0.0]
end = 0.02
[material.wood]
density = 500.0
normal_stiffness = "1 MPa"
[fluid]
spacing = 0.05
domain = { low = [-0.2, -0.2, 0.0], high = [1.2, 1.5, 0.0] }
[[fluid.region]]
box = { low = [0.0, 0.0, 0.0], high = [1.0, 0.5, 0.0] }
[[body]]
name = "floor"
shape = { half_space = { normal = [0.0, 1.0, 0.0] } }
material = "wood"
fixed = true
[[body]]
name = "left"
shape = { half_space = { normal = [1.0, 0.0, 0.0] } }
material = "wood"
fixed = true
[[body]]
name = "right"
shape = { half_space = { normal = [-1.0, 0.0, 0.0], offset = -1.0 } }
material = "wood"
fixed = true
[[body]]
name = "box"
shape = { box = [0.2, 0.2] }
position = [0.5, 0.5, 0.0]
material = "wood"
[output]
interval = 0.005
)";

class Frames : public RunFixture {
 protected:
    /// Returns the complaints of VTK's reader about a run and about the script that shows it; none without VTK.
    std::string opened(const std::string& name, const std::string& script) {
        const std::string command = "/usr/bin/python3 tests/cli/open_with_vtk.py '" + out(name) + "' " + script +
                                    " >'" + out("said") + "' 2>&1";
        const int status = std::system(command.c_str());
        EXPECT_TRUE(WIFEXITED(status));
        if (WEXITSTATUS(status) == 77 || WEXITSTATUS(status) == 127) {
            return "";
        }
        EXPECT_EQ(WEXITSTATUS(status), 0) << text_of(out("said"));
        return text_of(out("said"));
    }
    static constexpr const char* no_vtk = "VTK's Python modules are not installed (Debian: python3-vtk9)";
};

TEST_F(Frames, EveryFrameOfARunOpensInVtksOwnReader) {
    ASSERT_EQ(run({"run", case_file(), "--out", out("a"), "--set", "end=0.035"}).code, 0);
    const std::string said = opened("a", "paraview/riprap_run.py");
    if (said.empty()) {
        GTEST_SKIP() << no_vtk;
    }
    // Frames at 0, 0.01, 0.02, 0.03 and the end: one half-space as a square, three boxes.
    EXPECT_THAT(said, HasSubstr("bodies: 5 frames, 95 cells"));
    EXPECT_THAT(said, HasSubstr("contacts: 5 frames"));
    EXPECT_THAT(said, HasSubstr("riprap_run.py: 3 arrays are there"));
}

TEST_F(Frames, EveryFrameOfWaterOpensInVtksOwnReader) {
    const Ending ending = run({"run", write_case("tank.toml", tank), "--out", out("water")});
    ASSERT_EQ(ending.code, 0) << ending.err;
    const std::string said = opened("water", "paraview/riprap_run.py");
    if (said.empty()) {
        GTEST_SKIP() << no_vtk;
    }
    EXPECT_THAT(said, HasSubstr("water: 5 frames"));
    EXPECT_THAT(said, HasSubstr("bodies: 5 frames"));
    EXPECT_THAT(said, HasSubstr("contacts: 5 frames"));
    EXPECT_THAT(said, HasSubstr("riprap_run.py: 3 arrays are there"));
}

}  // namespace
}  // namespace riprap
