// SPDX-License-Identifier: Apache-2.0
// A pair of blocks that touch counts once, however many points a method puts between them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "riprap/run/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

/// Two blocks side by side on a floor: two pairs touch, each across a whole face.
std::string two_blocks(const std::string& solid, bool is_planar) {
    const std::string z = is_planar ? "" : ", 1.0";
    const auto at = [&](const std::string& x) { return is_planar ? "[" + x + ", 0.499]" : "[" + x + ", 0.499, 0.0]"; };
    const std::string box = "shape = { box = [1.0, 1.0" + z + "] }\nmaterial = \"rock\"\n";
    return std::string(is_planar ? "dimension = 2\n" : "") + "gravity = [0.0, -9.81" + (is_planar ? "" : ", 0.0") +
           "]\nend = 1.0\n[material.rock]\ndensity = 2500.0\nnormal_stiffness = 1e7\nfriction_coefficient = 0.5\n"
           "[[body]]\nname = \"floor\"\nfixed = true\nmaterial = \"rock\"\nshape = { box = [6.0, 1.0" +
           (is_planar ? "" : ", 3.0") + "] }\nposition = [0.0, -0.5" + (is_planar ? "" : ", 0.0") +
           "]\n[[body]]\nname = \"left\"\n" + box + "position = " + at("-1.0") + "\n[[body]]\nname = \"right\"\n" +
           box + "position = " + at("1.0") + "\n[solid]\n" + solid;
}

TEST(ContactCount, IsOfPairsNotOfPoints) {
    for (const std::string solid :
         {"method = \"distance_potential_dem\"\n", "contact = \"common_plane_soft\"\n", "method = \"explicit_dda\"\n",
          "method = \"implicit_dda\"\n", "method = \"planar_dda\"\n"}) {
        SCOPED_TRACE(solid);
        Simulation simulation(scene::read_case_text(two_blocks(solid, solid.find("planar") != std::string::npos),
                                                    "case.toml", "/nonexistent", {}));
        for (int k = 0; k < 3; ++k) {
            ASSERT_TRUE(simulation.step(sim::Measure::energy).is_accepted());
        }
        EXPECT_EQ(simulation.now().report->contact_count, 2);
    }
}

}  // namespace
}  // namespace riprap::run
