// SPDX-License-Identifier: Apache-2.0
// Fields that a method shows of its bodies, by name in probes, frames and expected answers.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "riprap/io/scene_frame.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/shown.hpp"

namespace riprap::run {
namespace {

using testing::HasSubstr;

/// A block of 1 m rests on a floor.
std::string resting(const std::string& method) {
    return R"(gravity = [0, 0, -9.81]
end = 10.0
[material.rock]
density = 2500.0
normal_stiffness = "20 MPa"
friction_coefficient = 0.5
damping_ratio = 0.3
[[body]]
name = "floor"
shape = { box = [3.0, 3.0, 0.5] }
position = [0, 0, -0.25]
material = "rock"
fixed = true
[[body]]
name = "block"
shape = { cube = 1.0 }
position = [0, 0, 0.5]
material = "rock"
[[output.probe]]
body = "block"
quantity = "stress_zz"
[solid]
method = ")" +
           method + "\"\n";
}

Simulation load(const std::string& text) {
    return Simulation(scene::read_case_text(text, "case.toml", "/nonexistent", {}));
}

/// Mean of a probe over the second half of so many steps.
double mean_of(Simulation& simulation, int steps) {
    const sim::Column column = sim::record_columns(simulation.model()).at(0);
    double sum = 0;
    for (int k = 0; k < steps; ++k) {
        EXPECT_TRUE(simulation.step(sim::Measure::flow).is_accepted());
        sum += k >= steps / 2 ? sim::evaluate(column, simulation.now()) : 0;
    }
    return sum / (steps - steps / 2);
}

TEST(Shown, ARestingBlockBearsHalfItsWeightPerAreaAsItsMeanStress) {
    // V sigma_zz = sum f_z r_z about the centroid = m g (-h/2), whatever the stiffness: sigma_zz = -rho g h/2.
    const double exact = -0.5 * 2500 * 9.81;
    Simulation simulation = load(resting("implicit_dda"));
    EXPECT_NEAR(mean_of(simulation, 400), exact, 0.02 * std::abs(exact));
    const double across = shown_value(simulation.model(), simulation.state(), "stress_xy", BodyId{1});
    EXPECT_LT(std::abs(across), 0.02 * std::abs(exact));
}

TEST(Shown, FramesHaveTheFieldsOfTheMethodWithTheirUnits) {
    const Simulation simulation = load(resting("explicit_dda"));
    const io::PolyData data = io::draw_bodies(simulation.model(), simulation.state(), simulation.state(),
                                              io::draw_planes(simulation.model(), simulation.state()), {});
    std::size_t found = 0;
    for (const ShownField& field : sim::shown_fields(simulation.model())) {
        EXPECT_THAT(data.cell_arrays, HasSubstr(fmt::format("Name=\"{} [{}]\"", field.name, field.unit)));
        ++found;
    }
    EXPECT_EQ(found, 13U);
}

TEST(Shown, AFieldThatTheMethodDoesNotHaveIsRefusedWithTheOnesThatAreThere) {
    try {
        load(resting("distance_potential_dem"));
        FAIL() << "rigid blocks have no stress";
    } catch (const CaseError& error) {
        EXPECT_THAT(error.what(), HasSubstr("the methods of this case do not have 'stress_zz'"));
        EXPECT_THAT(error.what(), HasSubstr("'kinetic_energy'"));
    }
}

}  // namespace
}  // namespace riprap::run
