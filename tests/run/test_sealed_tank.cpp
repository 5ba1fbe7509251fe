// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {
namespace {

/// A hundred floes side by side on still water in a box with a lid: nothing comes in, nothing goes out. They are put a
/// centimetre too high, and dip, collide and tilt for ever.
constexpr const char* sealed_tank = R"(
dimension = 2
gravity = [0, -9.81]
end = 200
[material.ice]
density = 900.0
normal_stiffness = 1.0e6
friction_coefficient = 0.3
[[body]]
name = "floe"
material = "ice"
shape = { box = [0.09, 0.06] }
position = [0.06, 0.31]
repeat = { counts = [100, 1], pitch = [0.12, 1] }
[[body]]
name = "floor"
material = "ice"
fixed = true
shape = { half_space = { normal = [0, 1] } }
[[body]]
name = "left"
material = "ice"
fixed = true
shape = { half_space = { normal = [1, 0] } }
[[body]]
name = "right"
material = "ice"
fixed = true
shape = { half_space = { normal = [-1, 0], offset = -12 } }
[[body]]
name = "lid"
material = "ice"
fixed = true
shape = { half_space = { normal = [0, -1], offset = -0.6 } }
[fluid]
spacing = 0.03
domain = { low = [-0.3, -0.3], high = [12.3, 0.9] }
[[fluid.region]]
box = { low = [0, 0], high = [12, 0.3] }
)";

/// Energy of motion and of height above the floor of bodies and water [J/m].
double energy_there(const sim::Ledger& ledger) {
    return ledger.kinetic + ledger.potential + ledger.fluid.kinetic + ledger.fluid.potential;
}

/// 1e5 steps with RIPRAP_FULL=1, a quarter of an hour; 200 else.
TEST(SealedTank, keeps_the_energy_of_a_hundred_floes_to_a_ten_thousandth) {
    const std::int64_t steps = std::getenv("RIPRAP_FULL") != nullptr ? 100'000 : 200;
    Simulation simulation(scene::read_case_text(sealed_tank, "case.toml", "."));
    const std::int64_t particles = simulation.state().fluid.size();
    double worst = 0, mass = 0;
    while (simulation.state().step < steps) {
        const bool is_measured = (simulation.state().step + 1) % 100 == 0 || simulation.state().step == 0;
        const StepOutcome outcome = simulation.step(is_measured ? sim::Measure::energy : sim::Measure::flow);
        ASSERT_NE(outcome.kind, StepOutcome::Kind::refused) << outcome.why.text;
        if (is_measured && outcome.is_accepted()) {
            const sim::Ledger& ledger = simulation.report().ledger;
            worst = std::max(worst, std::abs(ledger.residual) / energy_there(ledger));
            mass = mass == 0 ? ledger.mass + ledger.fluid.mass : mass;
            ASSERT_EQ(ledger.mass + ledger.fluid.mass, mass);
        }
    }
    EXPECT_LT(worst, 1e-4);
    EXPECT_GT(worst, 0);
    EXPECT_EQ(simulation.state().fluid.size(), particles);
    RecordProperty("worst", fmt::format("{:.3g}", worst));
}

}  // namespace
}  // namespace riprap::run
