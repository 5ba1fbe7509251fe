// SPDX-License-Identifier: Apache-2.0
// Still water over a slope that its lattice does not follow.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "riprap/scene/read_case.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::run {
namespace {

/// Water 0.4 m deep between an upright wall and a slope of 1 to 3.
const std::string basin = R"(dimension = 2
gravity = [0.0, -9.81]
end = 30.0
[material.rock]
density = 2400.0
normal_stiffness = 1.0e7
friction_coefficient = 0.7
[fluid]
spacing = 0.025
domain = { low = [2.7, -0.2], high = [5.2, 0.7] }
[[fluid.region]]
box = { low = [3.0, 0.0], high = [5.0, 0.4] }
[[body]]
name = "floor"
material = "rock"
shape = { half_space = { normal = [0.0, 1.0] } }
fixed = true
[[body]]
name = "wall"
material = "rock"
shape = { half_space = { normal = [1.0, 0.0] } }
position = [3.0, 0.0]
fixed = true
[[body]]
name = "slope"
material = "rock"
shape = { polygon = [[3.5, 0.0], [7.1, 0.0], [7.1, 1.2]] }
fixed = true
)";

/// Looks at every step from `start` to `end`.
void run(scene::LoadedCase& loaded, double start, double end,
         const std::function<void(const sim::Moment&, double dt)>& look) {
    sim::initialise(loaded.model, loaded.state);
    const sim::State initial = loaded.state;
    sim::Scratch scratch;
    while (loaded.state.time < end) {
        const double dt = choose_time_step(loaded.model, loaded.state, scratch).dt;
        const sim::StepReport report = advance(loaded.model, loaded.state, scratch, dt);
        ASSERT_TRUE(report.status.ok()) << report.status.text;
        if (loaded.state.time >= start) {
            look({loaded.model, initial, loaded.state, &scratch, &report}, dt);
        }
    }
}

TEST(WaterOnSlopes, still_water_is_stirred_little_by_the_steps_that_its_lattice_leaves) {
    scene::LoadedCase loaded = scene::read_case_text(basin, "case.toml", ".");
    double energy = 0, duration = 0;  // of motion [J s/m], [s]
    run(loaded, 2, 3, [&](const sim::Moment& moment, double dt) {
        double sum = 0;
        for (const Vec3& v : moment.state.fluid.velocity) {
            sum += 0.5 * moment.model.particles()->settings().particle_mass * dot(v, v);
        }
        energy += sum * dt;
        duration += dt;
    });
    const double mass =
        loaded.model.particles()->settings().particle_mass * static_cast<double>(loaded.state.fluid.size());
    const double speed = std::sqrt(2 * energy / duration / mass);
    EXPECT_LT(speed, 0.02 * std::sqrt(9.81 * 0.4));  // 0.034 with water that begins half a spacing off the slope
}

/// Mean force of the water on a square five spacings wide that lies on the slope, along and across it [N/m].
Vec3 force_on_square(double place_along) {
    const double angle = std::atan(1.0 / 3), c = std::cos(angle), s = std::sin(angle);
    const std::string block = fmt::format(R"([[body]]
name = "block"
material = "rock"
shape = {{ box = [0.1, 0.1] }}
position = [{}, {}]
orientation = {{ angle = {} }}
fixed = true
release_time = 29.0
)",
                                          4 + place_along * c - 0.05 * s, 0.5 / 3 + place_along * s + 0.05 * c, angle);
    scene::LoadedCase loaded =
        scene::read_case_text(basin + block, "case.toml", ".", std::vector<std::string>{"fluid.spacing=0.02"});
    const auto fx = sim::find_column(loaded.model, "block.fluid_force.x");
    const auto fy = sim::find_column(loaded.model, "block.fluid_force.y");
    Vec3 impulse{};
    double duration = 0;
    run(loaded, 1, 2, [&](const sim::Moment& moment, double dt) {
        impulse += dt * Vec3{evaluate(*fx, moment), evaluate(*fy, moment), 0};
        duration += dt;
    });
    const Vec3 force = impulse / duration;
    return {dot(force, Vec3{c, s, 0}), dot(force, Vec3{-s, c, 0}), 0};
}

TEST(WaterOnSlopes, a_block_on_a_slope_feels_the_buoyancy_of_archimedes) {
    const double angle = std::atan(1.0 / 3), buoyancy = 1000 * 9.81 * 0.1 * 0.1;
    // With the pressure of the crowded particles in the joint the force across the slope would be 1.17 of it.
    for (const double place : {0.0, 0.01}) {
        const Vec3 force = force_on_square(place);
        EXPECT_NEAR(force.x, buoyancy * std::sin(angle), 0.05 * buoyancy) << place;
        EXPECT_NEAR(force.y, buoyancy * std::cos(angle), 0.05 * buoyancy) << place;
    }
}

}  // namespace
}  // namespace riprap::run
