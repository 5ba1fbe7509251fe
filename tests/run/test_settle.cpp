// SPDX-License-Identifier: Apache-2.0
// Bodies that settle before time 0, armour on a slope, and the damage of it.
#include <gtest/gtest.h>

#include "riprap/core/error.hpp"
#include "riprap/run/simulate/simulation.hpp"

namespace riprap::run {
namespace {

/// Two layers of tetrapods on a slope of 1:1.5 that a toe holds, beside water.
const std::string slope = R"(
dimension = 2
gravity = [0.0, -9.81]
end = 0.1
settle = "3 s"
[material.concrete]
density = 2400.0
normal_stiffness = "20 MPa"
friction_coefficient = 0.6
damping_ratio = 0.3
[solid]
local_damping = 0.3
[[body]]
name = "core"
shape = { polygon = [[2.0, 0.0], [11.0, 0.0], [11.0, 6.0]] }
material = "concrete"
fixed = true
[[body]]
name = "toe"
shape = { box = [2.0, 3.0] }
position = [0.9, 1.5]
material = "concrete"
fixed = true
[[pack]]
name = "armour"
material = "concrete"
slope = { shape = { armour = { unit = "tetrapod", nominal_diameter = 0.8 } }, from = [2.25, 0.166667], to = [8.0, 4.0], packing_density = 0.9, upper_orientation = { angle = "180 deg" } }
[[output.damage]]
name = "armour"
bodies = ["armour"]
)";

const std::string water = R"(
[fluid]
method = "grid"
spacing = 0.5
domain = { low = [-6.0, 0.0], high = [10.0, 8.0] }
[[fluid.region]]
box = { low = [-6.0, 0.0], high = [2.0, 3.0] }
)";

Simulation* start(const std::string& text) { return new Simulation(scene::read_case_text(text, "case.toml", ".")); }
double value(const Simulation& simulation, const char* column) {
    return sim::evaluate(*sim::find_column(simulation.model(), column), simulation.now());
}

TEST(Settle, armour_lies_at_rest_on_its_slope_at_time_0_and_displacements_count_from_there) {
    const std::unique_ptr<Simulation> settled(start(slope));
    const std::unique_ptr<Simulation> placed(start(std::string(slope).replace(slope.find("3 s"), 3, "0 s")));
    const sim::State& now = settled->initial();
    EXPECT_EQ(now.time, 0);
    double fallen = 0;
    for (std::size_t b = 0; b < now.bodies.position.size(); ++b) {
        fallen = std::max(fallen, placed->initial().bodies.position[b].y - now.bodies.position[b].y);
        EXPECT_EQ(now.bodies.velocity[b], Vec3{});
    }
    EXPECT_GT(fallen, 0.05);  // placed clear of each other
    EXPECT_FALSE(now.contacts.pair.empty());
    while (settled->steps_left() > 0) {
        ASSERT_TRUE(settled->step(sim::Measure::energy).is_accepted());
    }
    EXPECT_LT(value(*settled, "max_displacement"), 0.02);  // [m]
    EXPECT_EQ(value(*settled, "armour.displaced"), 0);
}

TEST(Settle, water_fills_what_settled_bodies_leave) {
    const std::unique_ptr<Simulation> settled(start(slope + water));
    const auto& fields = std::get<coupling::GridFluidFields>(settled->initial().fluid_fields);
    EXPECT_EQ(fields.cut_position, settled->initial().bodies.position);
}

TEST(Settle, goes_with_fluids_without_particles) {
    const std::string particles = std::string(water).replace(water.find("grid"), 4, "sph");
    EXPECT_THROW(start(slope + particles), CaseError);
}

TEST(Damage, counts_units_beyond_a_distance_and_per_strip_of_a_nominal_diameter) {
    // blocks of 1 m that fall freely, on a layer 4 m wide
    const std::string text = R"(
gravity = [0.0, 0.0, -9.81]
end = 0.5
[material.rock]
density = 2500.0
normal_stiffness = 1.0e7
[[body]]
name = "unit"
material = "rock"
shape = { cube = 1.0 }
repeat = { counts = [3, 2, 1], pitch = [2.0, 2.0, 2.0] }
[[body]]
name = "held"
material = "rock"
shape = { cube = 1.0 }
position = [20.0, 0.0, 0.0]
fixed = true
[[output.damage]]
name = "layer"
bodies = ["unit", "held"]
distance = 0.6
width = 4.0
)";
    const std::unique_ptr<Simulation> fall(start(text));
    EXPECT_EQ(value(*fall, "layer.displaced"), 0);
    while (fall->steps_left() > 0) {
        ASSERT_TRUE(fall->step(sim::Measure::flow).is_accepted());
        const double fallen = 0.5 * 9.81 * fall->state().time * fall->state().time;
        if (std::abs(fallen - 0.6) > 0.02) {
            EXPECT_EQ(value(*fall, "layer.displaced"), fallen > 0.6 ? 6 : 0);
        }
    }
    EXPECT_EQ(value(*fall, "layer.n_od"), 6 / 4.0);
}

}  // namespace
}  // namespace riprap::run
