// SPDX-License-Identifier: Apache-2.0
// Every word of output.probe.quantity gives values of its own: the cases of tests/run/methods, and two for what
// those lack, are run for a few steps, and no two words may read the same in all of them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/keys/key_table.hpp"

namespace riprap::run {
namespace {

std::string method_case(const std::string& name) {
    const std::string path = "tests/run/methods/" + name + ".toml";
    std::ifstream file(path);
    EXPECT_TRUE(file.good()) << path;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

struct Trial {
    std::string text;
    std::string body;  ///< whose quantities are read
    std::vector<std::string> overrides{};
    int steps{6};
};

/// Blocks with every kind of work: one is driven, one released while gravity grows and turns, all are damped.
const std::string moved = R"(end = 1.0
[gravity]
value = [0, 0, -9.81]
ramp = 0.01
rotation = { axis = [0, 1, 0], rate = 0.5 }
[material.rock]
density = 2500.0
normal_stiffness = 1e7
friction_coefficient = 0.5
[[body]]
name = "floor"
shape = { box = [3, 3, 0.5] }
position = [0, 0, -0.25]
material = "rock"
motion = { linear = { velocity = [0.5, 0, 0] } }
[[body]]
name = "block"
shape = { cube = 0.5 }
position = [0, 0, 0.249]
velocity = [0.1, 0, 0]
material = "rock"
[[body]]
name = "late"
shape = { cube = 0.5 }
position = [1, 0, 0.26]
material = "rock"
fixed = true
release_time = 1e-4
[solid]
local_damping = 0.3
)";

/// A stream from an inflow to an outflow past a rough block, through a sponge; it leaves before more comes in.
const std::string stream = R"(dimension = 2
gravity = [0, -9.81]
end = 1.0
[material.rock]
density = 2500.0
normal_stiffness = 1e6
[[body]]
name = "floor"
material = "rock"
shape = { half_space = { normal = [0, 1] } }
fixed = true
[[body]]
name = "block"
material = "rock"
shape = { box = [0.1, 0.1] }
position = [0.6, 0.05]
slip = false
[fluid]
spacing = 0.025
domain = { low = [-0.3, -0.2], high = [1.6, 1.0] }
expected_speed = 1.0
viscosity = "laminar_sps"
kinematic_viscosity = 1e-3
[[fluid.region]]
box = { low = [0, 0], high = [1.21, 0.3] }
velocity = [0.8, 0]
[[fluid.inflow]]
name = "upstream"
low = [0, 0]
high = [0, 0.6]
towards = "x"
speed = 0.5
level = 0.3
[[fluid.outflow]]
name = "downstream"
low = [1.2, 0]
high = [1.2, 0.6]
towards = "x"
level = 0.3
[[fluid.sponge]]
low = [0.8, 0]
high = [1.2, 0.6]
rate = 5.0
towards = "x"
)";

/// A plate squeezes a drop against the floor until it is alone between both.
const std::string squeezed = R"(dimension = 2
gravity = [0, -9.81]
end = 0.05
[material.rock]
density = 2500.0
normal_stiffness = 1e6
[[body]]
name = "floor"
material = "rock"
shape = { half_space = { normal = [0, 1] } }
fixed = true
[[body]]
name = "plate"
material = "rock"
shape = { box = [0.3, 0.1] }
position = [0.0, 0.085]
motion = { linear = { velocity = [0, -0.5] } }
[fluid]
spacing = 0.025
domain = { low = [-0.2, -0.2], high = [0.5, 0.5] }
expected_speed = 1.0
[[fluid.region]]
box = { low = [-0.0125, 0.0], high = [0.0125, 0.025] }
velocity = [0.05, 0]
)";

std::vector<Trial> trials() {
    std::vector<Trial> all{{moved, "block"}, {stream, "block", {}, 72}, {squeezed, "plate", {}, 110}};
    for (const char* solid : {"distance_potential_dem", "planar_dda", "implicit_dda", "explicit_dda"}) {
        all.push_back({method_case(std::string("solid-") + solid), "high"});
    }
    const std::string planar = method_case("solid-planar_dda");
    all.push_back({planar, "high", {"solid.normal_contact=\"augmented_lagrange\"", "solid.dynamic_factor=0.5"}});
    all.push_back({planar, "high", {"material.rock.cohesion=1e3", "material.rock.tensile_strength=1e3"}});
    all.push_back({method_case("solid-sphere_dem"), "low", {"solid.rolling_friction=0.1", "solid.spheres=\"one\""}});
    all.push_back({method_case("fluid-mps"), "block", {"fluid.collision_distance=1.0"}});
    all.push_back({method_case("fluid-wcmps"), "block", {"solid.method=\"explicit_dda\""}, 100});
    all.push_back({method_case("fluid-grid"), "box"});
    return all;
}

/// Values of every word after the steps of a trial, by word.
void read_all(const Trial& trial, std::map<std::string, std::string>& values) {
    Simulation simulation(scene::read_case_text(trial.text, "case.toml", "/nonexistent", trial.overrides));
    for (int taken = 0; taken < trial.steps;) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        ASSERT_NE(outcome.kind, StepOutcome::Kind::refused) << outcome.why.text;
        taken += outcome.is_accepted() ? 1 : 0;
    }
    const sim::Model& model = simulation.model();
    for (const sim::QuantityInfo& quantity : sim::quantities()) {
        std::string& read = values[std::string(quantity.name)];
        if (!has_quantity(model, quantity)) {
            read += " -";
            continue;
        }
        sim::Probe probe;
        probe.name = quantity.name;
        probe.quantity = quantity.name;
        probe.body = quantity.is_of_body ? sim::find_body(model.bodies, trial.body) : BodyId{};
        for (const sim::Column& column : columns_of(probe, false)) {
            read += fmt::format(" {}", sim::evaluate(column, simulation.now()));
        }
    }
}

TEST(EveryQuantity, has_values_of_its_own) {
    std::map<std::string, std::string> values;
    for (const Trial& trial : trials()) {
        SCOPED_TRACE(trial.text);
        read_all(trial, values);
    }
    std::map<std::string, std::string> words;  // by values
    for (const auto& [word, read] : values) {
        const auto [first, is_new] = words.emplace(read, word);
        EXPECT_TRUE(is_new) << word << " reads the same as " << first->second << ":" << read;
    }
}

}  // namespace
}  // namespace riprap::run
