// SPDX-License-Identifier: Apache-2.0
// Story: a disc given a mass fell through its floor by 0.0376 m, as its sphere was that of the volume which the
// material's density gives this mass; a ball with a density of its own rolled 1 % too slowly.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap {
namespace {

/// Height of the centre of a body of radius 0.05 m, half a second after it was put on a floor [m].
double height_of(bool is_planar, const std::string& shape, const std::string& weight) {
    const std::string text = fmt::format(
        "gravity = [{0}]\nend = 0.5\n{1}[material.rock]\ndensity = 2000.0\n[solid]\nmethod = \"sphere_dem\"\nspheres = "
        "\"one\"\n[[body]]\nname = \"floor\"\nshape = {{ half_space = {{ normal = [{2}] }} }}\nmaterial = "
        "\"rock\"\nfixed = true\n[[body]]\nname = \"it\"\nshape = {{ {3} }}\nposition = [{4}]\nmaterial = "
        "\"rock\"\n{5}\n",
        is_planar ? "0.0, -9.81" : "0.0, 0.0, -9.81", is_planar ? "dimension = 2\n" : "",
        is_planar ? "0.0, 1.0" : "0.0, 0.0, 1.0", shape, is_planar ? "0.0, 0.05" : "0.0, 0.0, 0.05", weight);
    run::Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    while (simulation.steps_left() > 0) {
        EXPECT_TRUE(simulation.step(sim::Measure::flow).is_accepted());
    }
    const Vec3& place = simulation.state().bodies.position[1];
    return is_planar ? place.y : place.z;
}

TEST(RoundBodies, LieOnTheirRadiusWhateverTheirDensityAndMass) {
    for (const char* const weight : {"", "mass = 1.0", "mass = 20.0", "density = 500.0", "density = 9000.0"}) {
        SCOPED_TRACE(weight);
        EXPECT_NEAR(height_of(true, "sphere = 0.05", weight), 0.05, 2e-4);
        EXPECT_NEAR(height_of(false, "sphere = 0.05", weight), 0.05, 2e-4);
    }
    const double side =
        0.05 * std::cbrt(4 * M_PI / 3);  // a cube of the volume of the ball, one sphere of which stands for it
    EXPECT_NEAR(height_of(false, fmt::format("cube = {}", side), "density = 300.0"), 0.05, 2e-4);
}

}  // namespace
}  // namespace riprap
