// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/time_step.hpp"
#include "scene/case_fixture.hpp"

namespace riprap::scene {
namespace {

/// A heavy and a light block in a small tank, dimension 2, with the method of the water to be filled in.
const std::string tank = R"(dimension = 2
gravity = [0.0, -9.81]
end = 1.0
[material.wood]
density = 500.0
normal_stiffness = 1.0e6
[fluid]
method = "METHOD"
spacing = 0.025
domain = { low = [-0.2, -0.2], high = [0.8, 1.0] }
[[fluid.region]]
box = { low = [0.0, 0.0], high = [0.6, 0.3] }
[[body]]
name = "bottom"
material = "wood"
shape = { half_space = { normal = [0.0, 1.0], offset = 0.0 } }
fixed = true
[[body]]
name = "left"
material = "wood"
shape = { half_space = { normal = [1.0, 0.0], offset = 0.0 } }
fixed = true
[[body]]
name = "right"
material = "wood"
shape = { half_space = { normal = [-1.0, 0.0], offset = -0.6 } }
fixed = true
[[body]]
name = "block"
material = "wood"
shape = { box = [0.2, 0.1] }
position = [0.3, 0.3]
)";

class ParticleFluids : public ::testing::TestWithParam<const char*> {
 protected:
    static LoadedCase start() {
        LoadedCase loaded = test::read(test::with(tank, "METHOD", GetParam()));
        sim::initialise(loaded.model, loaded.state);
        return loaded;
    }
};
INSTANTIATE_TEST_SUITE_P(Words, ParticleFluids, ::testing::Values("sph", "wcmps", "mps"),
                         [](const auto& word) { return std::string(word.param); });

TEST_P(ParticleFluids, a_block_that_half_the_water_carries_stays_about_where_it_floats) {
    LoadedCase loaded = start();
    sim::Scratch scratch;
    Vec3 impulse{};
    while (loaded.state.time < 0.15) {
        const double dt = sim::choose_time_step(loaded.model, loaded.state, scratch).dt;
        const sim::StepReport report = sim::advance(loaded.model, loaded.state, scratch, dt);
        ASSERT_EQ(report.status.text, "");
        ASSERT_TRUE(std::isfinite(report.ledger.kinetic));
        impulse += dt * (scratch.fluid_loads().pressure.force[3] + scratch.fluid_loads().viscous.force[3]);
    }
    // what the water gave is what moves the block, and what carries it
    const double mass = loaded.model.bodies.mass[3];
    const Vec3 momentum = mass * loaded.state.bodies.velocity[3];
    EXPECT_NEAR(momentum.y, impulse.y - mass * 9.81 * loaded.state.time, 1e-9 * mass * 9.81);
    EXPECT_NEAR(loaded.state.bodies.position[3].y, 0.3, 0.05);
}

TEST_P(ParticleFluids, have_the_same_bits_with_two_threads_and_after_their_scratch_is_lost) {
    const auto hash = [](int threads, bool loses) {
        parallel::set_thread_count(threads);
        LoadedCase loaded = start();
        sim::Scratch scratch;
        for (int k = 0; k < 8; ++k) {
            if (loses) {
                scratch = sim::Scratch();
            }
            sim::advance(loaded.model, loaded.state, scratch,
                         sim::choose_time_step(loaded.model, loaded.state, scratch).dt);
        }
        parallel::set_thread_count(1);
        return sim::state_hash(loaded.state);
    };
    const std::uint64_t one = hash(1, false);
    EXPECT_EQ(hash(2, false), one);
    EXPECT_EQ(hash(1, true), one);
}

// Water began a whole spacing before faces that lie on rows of the lattice, and fell into the gap.
TEST_P(ParticleFluids, water_about_a_block_on_rows_of_the_lattice_begins_at_rest) {
    const std::string held = test::with(test::with(tank, "METHOD", GetParam()), "position = [0.3, 0.3]",
                                        "position = [0.3, 0.15]\nfixed = true");
    LoadedCase loaded = test::read(test::with(held, "[0.2, 0.1]", "[0.2, 0.075]"));
    sim::initialise(loaded.model, loaded.state);
    sim::Scratch scratch;
    double most = 0, lift = 0;
    while (loaded.state.time < 0.1) {
        const double dt = sim::choose_time_step(loaded.model, loaded.state, scratch).dt;
        const sim::StepReport report = sim::advance(loaded.model, loaded.state, scratch, dt, sim::Measure::energy);
        ASSERT_EQ(report.status.text, "");
        most = std::max(most, report.ledger.fluid.kinetic);
        lift += dt * scratch.fluid_loads().pressure.force[3].y;
    }
    EXPECT_LT(most, 0.1);  // it had 4.0 J/m (mps), 0.29 J/m (wcmps) and 0.81 J/m (sph)
    EXPECT_NEAR(lift / loaded.state.time, 1000 * 9.81 * 0.2 * 0.075, 0.05 * 1000 * 9.81 * 0.2 * 0.075);
}

TEST(ParticleFluid, only_water_whose_density_is_the_count_of_its_particles_begins_with_what_the_count_lacks) {
    const auto lack_of = [](const std::string& method) {
        const std::string text =
            test::with(test::with(tank, "METHOD\"", method), "position = [0.3, 0.3]", "position = [0.3, 0.15]");
        const LoadedCase loaded = test::read(test::with(text, "[0.2, 0.1]", "[0.2, 0.075]"));
        double most = 0;
        for (const double lack : loaded.state.fluid.dilution) {
            most = std::max(most, std::abs(lack));
        }
        return most;
    };
    EXPECT_GT(lack_of("mps\""), 1e-3);
    EXPECT_LT(lack_of("mps\""), 0.05);
    EXPECT_EQ(lack_of("mps\"\ndivergence_share = 0"), 0);
    EXPECT_EQ(lack_of("wcmps\""), 0);
    EXPECT_EQ(lack_of("sph\""), 0);
}

}  // namespace
}  // namespace riprap::scene
