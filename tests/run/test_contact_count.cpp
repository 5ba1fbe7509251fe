// SPDX-License-Identifier: Apache-2.0
// A pair of blocks that touch counts once, however many points a method puts between them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "riprap/run/simulate/simulation.hpp"
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

std::int64_t count_after_three_steps(const std::string& text) {
    Simulation simulation(scene::read_case_text(text, "case.toml", "/nonexistent", {}));
    for (int k = 0; k < 3; ++k) {
        EXPECT_TRUE(simulation.step(sim::Measure::energy).is_accepted());
    }
    return simulation.now().report->contact_count;
}

TEST(ContactCount, IsOfPairsNotOfPoints) {
    for (const std::string solid :
         {"method = \"distance_potential_dem\"\n", "contact = \"common_plane_soft\"\n", "method = \"explicit_dda\"\n",
          "method = \"implicit_dda\"\n", "method = \"planar_dda\"\n"}) {
        SCOPED_TRACE(solid);
        EXPECT_EQ(count_after_three_steps(two_blocks(solid, solid.find("planar") != std::string::npos)), 2);
    }
}

TEST(ContactCount, IsOfBodiesNotOfTheirSpheres) {
    EXPECT_EQ(count_after_three_steps(two_blocks("method = \"sphere_dem\"\n", false)), 2);
}

TEST(ContactCount, IsOfBodiesNotOfTheirParts) {
    std::string text = two_blocks("method = \"distance_potential_dem\"\n", false);
    const std::string box = "{ box = [1.0, 1.0, 1.0] }", part = "{ shape = { box = [0.5, 1.0, 1.0] }, position = [";
    for (std::size_t at = text.find(box); at != std::string::npos; at = text.find(box)) {
        text.replace(at, box.size(), "{ union = [" + part + "-0.25, 0, 0] }, " + part + "0.25, 0, 0] }] }");
    }
    EXPECT_EQ(count_after_three_steps(text), 2);
}

}  // namespace
}  // namespace riprap::run
