// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "case_fixture.hpp"
#include "riprap/scene/warnings/initial_overlaps.hpp"

namespace riprap::scene {
namespace {

using namespace test;

/// A ball of radius 0.1 m whose lowest point lies `depth` below z = 0, and below it a fixed shape.
LoadedCase ball_on(const std::string& shape, double depth) {
    return read(R"(gravity = [0.0, 0.0, -9.81]
end = 1.0
[solid]
method = "sphere_dem"
[material.rock]
density = 2000.0
youngs_modulus = 1.0e7
poisson_ratio = 0.2
restitution = 0.5
[[body]]
name = "below"
material = "rock"
fixed = true
)" + shape +
                fmt::format(R"([[body]]
name = "ball"
material = "rock"
shape = {{ sphere = 0.1 }}
position = [0.3, 0.2, {}]
)",
                            0.1 - depth));
}

// Holds the bound that tells balls apart to letting nothing through that is deeper than asked.
TEST(OverlapsOfBalls, a_ball_is_found_in_faces_and_planes_and_another_ball_by_its_depth) {
    const std::vector<std::string> shapes{"shape = { half_space = { normal = [0.0, 0.0, 1.0] } }\n",
                                          "shape = { box = [2.0, 2.0, 0.5] }\nposition = [0.0, 0.0, -0.25]\n",
                                          "shape = { sphere = 0.1 }\nposition = [0.3, 0.2, -0.1]\n"};
    for (const std::string& shape : shapes) {
        const LoadedCase loaded = ball_on(shape, 0.007);
        const std::vector<InitialOverlap> found = find_initial_overlaps(loaded.model, loaded.state, 0.06);
        ASSERT_EQ(found.size(), 1U) << shape;
        EXPECT_NEAR(found[0].share, 0.07, 0.025) << shape;
        EXPECT_TRUE(find_initial_overlaps(loaded.model, loaded.state, 0.1).empty()) << shape;
    }
}

}  // namespace
}  // namespace riprap::scene
