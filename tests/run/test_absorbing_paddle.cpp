// SPDX-License-Identifier: Apache-2.0
// A paddle that absorbs waves is moved by the fluid's correction, whatever solid method moves the bodies.
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/core/vec3.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/time_step.hpp"

namespace riprap::run {
namespace {

/// Water that is higher at one end runs towards a piston at the other one.
constexpr const char* flume = R"(dimension = 2
gravity = [0, -9.81]
end = 1.0
[material.wood]
density = 500.0
normal_stiffness = 1e6
[[body]]
name = "bed"
material = "wood"
shape = { box = [1.4, 0.2] }
position = [0.4, -0.1]
fixed = true
[[body]]
name = "wall"
material = "wood"
shape = { box = [0.2, 0.8] }
position = [0.9, 0.4]
fixed = true
[[body]]
name = "paddle"
material = "wood"
shape = { box = [0.2, 0.8] }
position = [-0.1, 0.4]
[body.motion.wave_maker]
paddle = "piston"
wave = "none"
depth = 0.2
absorb = [0.0, 0.0]
[fluid]
spacing = 0.025
domain = { low = [-0.4, -0.3], high = [1.1, 0.8] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [0.4, 0.2] }
[[fluid.region]]
box = { low = [0.4, 0.0], high = [0.8, 0.35] }
)";

/// Way of the paddle in half a second [m].
double way_of_paddle(const std::string& solid) {
    const std::vector<std::string> overrides{"solid.method=\"" + solid + "\""};
    scene::LoadedCase loaded = scene::read_case_text(flume, "case.toml", "/nonexistent", overrides);
    sim::initialise(loaded.model, loaded.state);
    const double start = loaded.state.bodies.position[2].x;
    sim::Scratch scratch;
    while (loaded.state.time < 0.5) {
        const double dt = sim::choose_time_step(loaded.model, loaded.state, scratch).dt;
        const sim::StepReport report = advance(loaded.model, loaded.state, scratch, dt, sim::Measure::flow);
        if (!report.status.ok()) {
            ADD_FAILURE() << solid << ": " << report.status.text;
            return 0;
        }
    }
    return loaded.state.bodies.position[2].x - start;
}

TEST(AbsorbingPaddle, goes_the_same_way_with_every_solid_method) {
    const double of_dem = way_of_paddle("distance_potential_dem");
    EXPECT_LT(of_dem, -0.01);  // away from the wave
    for (const char* solid : {"sphere_dem", "planar_dda", "implicit_dda", "explicit_dda"}) {
        EXPECT_NEAR(way_of_paddle(solid), of_dem, 0.02 * std::abs(of_dem)) << solid;
    }
}

}  // namespace
}  // namespace riprap::run
