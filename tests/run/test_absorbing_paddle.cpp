// SPDX-License-Identifier: Apache-2.0
// A paddle that absorbs waves is moved by the fluid's correction, whatever solid method moves the bodies.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "riprap/core/vec3.hpp"
#include "riprap/fluid/gauge/gauge_kinds.hpp"
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

/// A sea between a paddle and a wall: mean square of the surface over the flume and the last half of the run [m^2].
double surface_of_sea(const std::string& absorb, double end) {
    const std::string text = fmt::format(R"(dimension = 2
gravity = [0, -9.81]
end = {}
[material.wood]
density = 500.0
normal_stiffness = 1e6
[[body]]
name = "bed"
material = "wood"
shape = {{ box = [3.0, 0.2] }}
position = [0.8, -0.1]
fixed = true
[[body]]
name = "wall"
material = "wood"
shape = {{ box = [0.2, 0.8] }}
position = [1.7, 0.4]
fixed = true
[[body]]
name = "paddle"
material = "wood"
shape = {{ box = [0.2, 0.8] }}
position = [-0.1, 0.4]
[body.motion.wave_maker]
wave = "irregular"
height = 0.03
period = 1.4
depth = 0.2
{}
[fluid]
spacing = 0.02
domain = {{ low = [-0.5, -0.3], high = [1.9, 0.8] }}
[[fluid.region]]
box = {{ low = [0.0, 0.0], high = [1.6, 0.2] }}
)",
                                         end, absorb);
    scene::LoadedCase loaded = scene::read_case_text(text, "case.toml", "/nonexistent");
    sim::initialise(loaded.model, loaded.state);
    std::vector<fluid::Gauge> gauges(8);
    for (std::size_t k = 0; k < gauges.size(); ++k) {
        gauges[k].kind = &fluid::surface_gauge;
        gauges[k].up = {0, 1, 0};
        gauges[k].point = {0.2 + 0.18 * static_cast<double>(k), 0, 0};
        gauges[k].end = gauges[k].point + Vec3{0, 0.4, 0};
    }
    const auto& settings = std::get<coupling::ParticleFluid>(loaded.model.fluid).settings();
    sim::Scratch scratch;
    double sum = 0, squares = 0, count = 0;
    while (loaded.state.time < end) {
        const double dt = sim::choose_time_step(loaded.model, loaded.state, scratch).dt;
        const sim::StepReport report = advance(loaded.model, loaded.state, scratch, dt, sim::Measure::flow);
        if (!report.status.ok()) {
            ADD_FAILURE() << report.status.text;
            return 0;
        }
        for (std::size_t k = 0; k < gauges.size() && loaded.state.time > 0.5 * end && loaded.state.step % 20 == 0;
             ++k) {
            const double eta = read_gauge(gauges[k], settings, loaded.state.fluid)[0];
            sum += eta;
            squares += eta * eta;
            count += 1;
        }
    }
    return squares / count - sum * sum / (count * count);
}

TEST(AbsorbingPaddle, ASeaBeforeAWallKeepsTheEnergyOfOneReflection) {
    const double end = std::getenv("RIPRAP_FULL") != nullptr ? 56 : 21;
    const double without = surface_of_sea("", end), with = surface_of_sea("absorb = [0.0, 0.0]", end);
    // The sea and what the wall sends back, each H_m0^2/16; 1/(1 - sqrt(0.05))^2 of it where 5 % of the energy returns
    // in phase.
    const double theory = 2 * 0.03 * 0.03 / 16;
    const double bound = theory / std::pow(1 - std::sqrt(0.05), 2);
    RecordProperty("with", fmt::format("{:.4g}", with / theory));
    RecordProperty("without", fmt::format("{:.4g}", without / theory));
    EXPECT_LT(with, bound);
    EXPECT_GT(with, 0.4 * theory);  // the paddle still makes its sea
    EXPECT_GT(without, 1.3 * with);
}

}  // namespace
}  // namespace riprap::run
