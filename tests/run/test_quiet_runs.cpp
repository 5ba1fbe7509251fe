// SPDX-License-Identifier: Apache-2.0
// Scenes in which next to nothing happens, or all there is begins from nothing: their ledgers close, and no run ends.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "riprap/run/simulate/ledger_verdict.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/ledger_account.hpp"
#include "riprap/sim/ledger_table.hpp"

namespace riprap::run {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::vector<std::string> in_space{"distance_potential_dem", "sphere_dem", "explicit_dda", "implicit_dda"};

/// End of a run, with its worst ledger: the residual over what was turned over then, of all steps but the first ones,
/// in which a method that books over several steps knows only a part.
struct Quiet {
    std::string reason;  ///< why a step was refused; empty where the end was reached
    double worst{0};     ///< [-]
    double miss{0};      ///< largest residual of these steps [J]
    std::int64_t retries{0};
    sim::State state{};
};

Quiet quiet(const std::string& text) {
    Simulation simulation(scene::read_case_text(text, "case.toml", "."));
    Quiet end;
    while (simulation.steps_left() > 0) {
        const StepOutcome outcome = simulation.step(sim::Measure::energy);
        if (outcome.kind == StepOutcome::Kind::refused) {
            end.reason = outcome.why.text;
            break;
        }
        const sim::Ledger& ledger = simulation.report().ledger;
        if (simulation.state().step > 10 && ledger.turnover > 0) {
            end.miss = std::max(end.miss, std::abs(ledger.residual));
            end.worst = std::max(end.worst, std::abs(ledger.residual) / ledger.turnover);
        }
    }
    end.retries = simulation.summary().retries;
    end.state = simulation.state();
    return end;
}

std::string solids(const std::string& method, const std::string& more = {}) {
    return "[solid]\nmethod = '" + method + "'\n" + more + "\n";
}
std::string rock(const std::string& more = {}) {
    return "[material.rock]\ndensity = 2500\nnormal_stiffness = 1e8\nfriction_coefficient = 0.5\n" + more + "\n";
}
std::string body(const std::string& name, const std::string& shape, const std::string& more = {}) {
    return "[[body]]\nname = '" + name + "'\nmaterial = 'rock'\nshape = { " + shape + " }\n" + more + "\n";
}
const std::string weightless = "gravity = [0, 0, 0]\n";

TEST(QuietRun, ALoadThatGrowsFromNothingGivesItsImpulse) {
    // At the first kicks a tenth of the work of such a load was booked at the wrong side of the kick.
    for (const std::string& method : in_space) {
        const Quiet end = quiet(weightless + "end = 1\n" + solids(method) + rock() +
                                body("b", "cube = 1", "[[body.load]]\nforce = [2500, 0, 0]\nramp = 0.5"));
        EXPECT_THAT(end.reason, IsEmpty()) << method;
        EXPECT_LT(end.worst, 1e-9) << method;
        EXPECT_NEAR(end.state.bodies.velocity[0].x, 0.75, 1e-3) << method;
    }
}

TEST(QuietRun, ACoupleThatGrowsFromNothingGivesItsTurn) {
    for (const std::string& method : in_space) {
        const Quiet end = quiet(weightless + "end = 0.5\n" + solids(method) + rock() +
                                body("b", "box = [1, 0.6, 0.4]",
                                     "load = [{ force = [-500, 0, 0], at = [0, 0.3, 0], ramp = 0.5 }, "
                                     "{ force = [500, 0, 0], at = [0, -0.3, 0], ramp = 0.5 }]"));
        EXPECT_THAT(end.reason, IsEmpty()) << method;
        EXPECT_LT(end.worst, method == "explicit_dda" ? 5e-3 : 1e-6) << method;      // its strain modes ring
        EXPECT_NEAR(end.state.bodies.angular_momentum[0].z, 74.68, 0.01) << method;  // the arms turn by 11 degrees
    }
}

TEST(QuietRun, ALoadThatGrowsIsBookedWithItsDamping) {
    for (const std::string method : {"distance_potential_dem", "sphere_dem"}) {
        for (const std::string damping : {"local_damping = 0.7", "mass_damping = 50.0"}) {
            const Quiet end = quiet(weightless + "end = 0.2\n" + solids(method, damping) + rock() +
                                    body("b", "cube = 1", "[[body.load]]\nforce = [300, 0, 0]\nramp = 0.1"));
            EXPECT_THAT(end.reason, IsEmpty()) << method << ' ' << damping;
            EXPECT_LT(end.worst, 1e-9) << method << ' ' << damping;
        }
    }
    const Quiet blocks = quiet(weightless + "end = 0.05\n" + solids("explicit_dda", "mass_damping = 50.0") + rock() +
                               body("b", "cube = 1", "[[body.load]]\nforce = [300, 0, 0]\nramp = 0.05"));
    EXPECT_THAT(blocks.reason, IsEmpty());
    EXPECT_LT(blocks.worst, 1e-9);
}

TEST(QuietRun, WindThatBeginsToPushAFloeInPlanViewMovesIt) {
    for (const std::string method :
         {"distance_potential_dem", "sphere_dem", "explicit_dda", "implicit_dda", "planar_dda"}) {
        const Quiet end = quiet("dimension = 2\ngravity = [0, 0]\nend = 0.2\n" + solids(method) + rock() +
                                body("floe", "box = [2, 1]", "[[body.load]]\nforce = [500, 300]\nramp = 0.1"));
        EXPECT_THAT(end.reason, IsEmpty()) << method;
        EXPECT_LT(end.worst, 1e-9) << method;
        EXPECT_NEAR(end.state.bodies.velocity[0].y, 300 * 0.15 / 5000, 1e-5) << method;
    }
}

TEST(QuietRun, ASliderThatIsLockedButForOneWayGoesThatWay) {
    for (const std::string method : {"distance_potential_dem", "sphere_dem"}) {
        const Quiet end = quiet("gravity = [0, 0, -9.81]\nend = 0.5\n" + solids(method) + rock() +
                                body("b", "cube = 1",
                                     "locked = ['y', 'z', 'rotation_x', 'rotation_y', 'rotation_z']\n"
                                     "[[body.load]]\nforce = [2500, 100, 50]\nramp = 0.5"));
        EXPECT_THAT(end.reason, IsEmpty()) << method;
        EXPECT_LT(end.worst, 1e-9) << method;
        EXPECT_NEAR(end.state.bodies.velocity[0].x, 0.25, 1e-3) << method;
    }
}

TEST(QuietRun, ShearSpringsThatGrowWithThePushOfASliderAreNoEnergyOfTheNumerics) {
    // Corners of a block that slides, or creeps below the limit as gravity grows, take more shear as they are pushed
    // harder. That was booked as friction, and what the springs then held as made by the integration.
    const double limit = std::atan(0.5);
    for (const double slope : {0.5 * limit, 0.98 * limit, 1.1 * limit}) {
        for (const std::string shape : {"box = [0.8, 0.5, 0.2]", "box = [0.2, 0.5, 0.3]", "cube = 0.3"}) {
            const double height = shape == "box = [0.8, 0.5, 0.2]" ? 0.1 : 0.15;
            Simulation simulation(
                scene::read_case_text(fmt::format("gravity = {{ value = [{}, 0, {}], ramp = 0.2 }}\nend = 0.25\n",
                                                  9.81 * std::sin(slope), -9.81 * std::cos(slope)) +
                                          solids("implicit_dda") + rock() +
                                          body("floor", "box = [4, 2, 0.5]", "position = [0, 0, -0.25]\nfixed = true") +
                                          body("block", shape, fmt::format("position = [0, 0, {}]", height)),
                                      "case.toml", "."));
            double lost = 0;
            while (simulation.steps_left() > 0) {
                ASSERT_TRUE(simulation.step(sim::Measure::energy).is_accepted()) << slope << ' ' << shape;
                const double now = simulation.report().ledger.own[3];  // numerical_damping
                ASSERT_GE(now, lost * (1 - 1e-9)) << slope << ' ' << shape << ' ' << simulation.state().time;
                lost = now;
            }
            EXPECT_GT(lost, 0) << slope << ' ' << shape;
        }
    }
}

TEST(QuietRun, ASlabThatTumblesIsNotEnded) {
    const Quiet end = quiet(weightless + "end = 4\n" + solids("implicit_dda", "step = '20 ms'") + rock() +
                            body("slab", "box = [4, 2, 1]", "angular_velocity = [0.1, 3, 0.05]"));
    EXPECT_THAT(end.reason, IsEmpty());
}

TEST(QuietRun, ARodThatTurnsIntoACubeOfSpheresPushesItAway) {
    // The step was that of bodies whose centres stand still: forty times too long for the end of the rod.
    const Quiet end =
        quiet(weightless + "end = 1\n" + solids("sphere_dem") + rock() +
              body("rod", "box = [2, 0.1, 0.1]", "motion = { rotation = { center = [0, 0, 0], rate = 1 } }") +
              body("cube", "cube = 0.4", "position = [0.7, 0.5, 0.03]"));
    EXPECT_THAT(end.reason, IsEmpty());
    EXPECT_EQ(end.retries, 0);
    EXPECT_GT(end.state.bodies.velocity[1].y, 0.3);
}

/// A tank with still water and a body in it.
std::string tank(const std::string& solid, const std::string& block, double density, double end) {
    const std::string wall = "fixed = true\n";
    return fmt::format(
               "dimension = 2\ngravity = [0, -9.81]\nend = {}\n"
               "[material.rock]\ndensity = {}\nnormal_stiffness = 1e7\nfriction_coefficient = 0.4\ndamping_ratio = "
               "0.2\n",
               end, density) +
           "[solid]\nmethod = '" + solid +
           "'\n[fluid]\nmethod = 'grid'\nspacing = 0.04\ndomain = { low = [-0.1, -0.1], high = [1.1, 0.8] }\n"
           "[[fluid.region]]\nbox = { low = [0, 0], high = [1, 0.4] }\n" +
           body("floor", "box = [1.2, 0.1]", wall + "position = [0.5, -0.05]") +
           body("left", "box = [0.1, 1]", wall + "position = [-0.05, 0.5]") +
           body("right", "box = [0.1, 1]", wall + "position = [1.05, 0.5]") + block;
}

TEST(QuietRun, ABlockRestsUnderWaterOnTheFloor) {
    // The grid took the work that it did on a block that falls, as was foreseen, for that on a block which stands.
    for (const std::string method : {"planar_dda", "implicit_dda", "explicit_dda", "distance_potential_dem"}) {
        const Quiet end = quiet(tank(method, body("block", "box = [0.2, 0.16]", "position = [0.5, 0.08]"), 1900, 0.2));
        EXPECT_THAT(end.reason, IsEmpty()) << method;
        EXPECT_LT(end.miss, method == "planar_dda" || method == "implicit_dda" ? 1e-7 : 1e-4) << method;
        EXPECT_EQ(end.retries, 0) << method;
    }
}

TEST(QuietRun, ABlockAsHeavyAsWaterStaysWhereItIs) {
    for (const std::string method : {"planar_dda", "distance_potential_dem"}) {
        const Quiet end = quiet(tank(method, body("block", "box = [0.2, 0.16]", "position = [0.5, 0.2]"), 1000, 0.4));
        EXPECT_THAT(end.reason, IsEmpty()) << method;
        EXPECT_EQ(end.retries, 0) << method;
        EXPECT_NEAR(end.state.bodies.position[3].y, 0.2, 1e-3) << method;
    }
}

TEST(QuietRun, ABallAsHeavyAsWaterStaysWhereItIs) {
    const Quiet end = quiet(
        "gravity = [0, 0, -9.81]\nend = 0.3\n[material.rock]\ndensity = 1000\nnormal_stiffness = 1e6\n"
        "[fluid]\nmethod = 'grid'\nspacing = 0.06\ndomain = { low = [0, 0, 0], high = [0.6, 0.6, 0.9] }\n"
        "[[fluid.region]]\nbox = { low = [0, 0, 0], high = [0.6, 0.6, 0.6] }\n" +
        body("ball", "sphere = 0.12", "position = [0.3, 0.3, 0.3]"));
    EXPECT_THAT(end.reason, IsEmpty());
    EXPECT_EQ(end.retries, 0);
    EXPECT_NEAR(end.state.bodies.position[0].z, 0.3, 1e-5);
}

/// A ledger of still water on a grid, with a block on its floor.
struct StillTank {
    Simulation simulation{scene::read_case_text(
        tank("planar_dda", body("block", "box = [0.2, 0.16]", "position = [0.5, 0.08]"), 1900, 0.05), "case.toml",
        ".")};
    sim::Ledger ledger;

    StillTank() {
        while (simulation.state().step < 20) {
            const StepOutcome outcome = simulation.step(sim::Measure::energy);
            if (outcome.kind == StepOutcome::Kind::refused) {
                ADD_FAILURE() << outcome.why.text;
                break;
            }
        }
        ledger = simulation.report().ledger;
    }
    /// Energy that lifts all water by one cell [J].
    double lift() const {
        const auto& settings = std::get<coupling::GridFluidSettings>(simulation.model().fluid);
        return ledger.fluid.mass * 9.81 * settings.grid.mesh.smallest_width();
    }
    std::string problem(double residual, double dissipated) const {
        sim::Ledger changed = ledger;
        changed.residual = residual;
        changed.fluid.own.front() = dissipated;
        return ledger_problem(changed, simulation.model(), simulation.state(), simulation.state().step);
    }
};

TEST(LedgerVerdict, EndsARunThatGainsEnergyHoweverQuietItIs) {
    const StillTank tank;
    const double counted = std::max(tank.ledger.turnover, tank.ledger.kinetic + tank.ledger.fluid.kinetic);
    ASSERT_LT(counted, 1e-2 * tank.lift());  // the water of the tank excuses nothing that bodies gain
    for (const double sign : {-1.0, 1.0}) {
        EXPECT_THAT(tank.problem(sign * 0.049 * counted, 0), IsEmpty());
        EXPECT_THAT(tank.problem(sign * 0.051 * counted, 0), HasSubstr("the energy ledger misses"));
    }
}

TEST(LedgerVerdict, EndsARunInWhichTheBalanceOfAGridMakesEnergy) {
    const StillTank tank;
    const double lift = tank.lift();
    EXPECT_THAT(tank.problem(0, 5 * lift), IsEmpty());  // lost
    EXPECT_THAT(tank.problem(0, -0.099 * lift), IsEmpty());
    EXPECT_THAT(tank.problem(0, -0.101 * lift), HasSubstr("the numerics made"));
}

TEST(LedgerVerdict, SeesEnergyThatAGridMakesAfterItHasLostMore) {
    const StillTank tank;
    const sim::Accounts accounts = accounts_of(tank.simulation.model());
    sim::State state = tank.simulation.state();
    reset(accounts, state.ledger);
    sim::Ledger ledger = tank.ledger;
    ledger.turnover = ledger.kinetic = 0;
    const auto measure = [&](double kinetic) {
        coupling::FluidStep step;
        step.balance.kinetic = kinetic * tank.lift();
        step.balance.mass = tank.ledger.fluid.mass;
        step.own = {0};
        account_fluid({step, 0, 0}, accounts, state.ledger, ledger);
        ledger.residual = 0;
        return ledger_problem(ledger, tank.simulation.model(), state, 20);
    };
    for (const double kinetic : {0.5, 0.1, 0.195, 0.1}) {  // over lift
        EXPECT_THAT(measure(kinetic), IsEmpty()) << kinetic;
    }
    EXPECT_GT(ledger.fluid.own.front(), 0.3 * tank.lift());
    EXPECT_NEAR(largest_rise(accounts, state.ledger), 0.095 * tank.lift(), 1e-9 * tank.lift());
    EXPECT_THAT(measure(0.205), HasSubstr("the numerics made"));
    EXPECT_GT(ledger.fluid.own.front(), 0);  // in all it has lost
}

// A lid that swings on water gives it all back in the end: a run that stopped just there was judged by nothing.
TEST(LedgerVerdict, RemembersWhatWaterHasTurnedOverWhenItComesBack) {
    const StillTank tank;
    const sim::Accounts accounts = accounts_of(tank.simulation.model());
    sim::State state = tank.simulation.state();
    reset(accounts, state.ledger);
    const auto turned_over = [&](double work, double lost) {
        coupling::FluidStep step;
        step.balance.work_on_solids = work * tank.lift();
        step.own = {lost * tank.lift()};
        sim::Ledger ledger = tank.ledger;
        ledger.turnover = 0;
        account_fluid({step, 0, 0}, accounts, state.ledger, ledger);
        return ledger.turnover / tank.lift();
    };
    turned_over(0, 0);
    EXPECT_NEAR(turned_over(2, 0), 1, 1e-12);  // half of a step's work lies before the kick
    EXPECT_NEAR(turned_over(-2, 0), 1, 1e-12);
    EXPECT_NEAR(turned_over(0, 0), 1, 1e-12);
    EXPECT_NEAR(turned_over(6, 0), 3, 1e-12);
}

TEST(LedgerVerdict, CountsNotAgainWhatTheFirstStepsMissed) {
    const StillTank tank;
    const sim::Accounts accounts = accounts_of(tank.simulation.model());
    sim::State state = tank.simulation.state();
    const double counted = std::max(tank.ledger.turnover, tank.ledger.kinetic + tank.ledger.fluid.kinetic);
    const auto problem = [&](double residual, std::int64_t step) {
        sim::Ledger changed = tank.ledger;
        changed.residual = residual;
        return ledger_problem(changed, tank.simulation.model(), state, step);
    };
    keep_first_residual(3 * counted, accounts, state.ledger);
    EXPECT_THAT(problem(3.049 * counted, 11), IsEmpty());  // it grows no more
    EXPECT_THAT(problem(3.051 * counted, 11), HasSubstr("the energy ledger misses"));
    EXPECT_THAT(problem(2.949 * counted, 11), HasSubstr("the energy ledger misses"));
    // No more than what the first steps may miss of what a short fall brings.
    sim::Ledger large = tank.ledger, least = tank.ledger;
    large.residual = 1e9;
    least.residual = -1e9;
    const double most = accepted_miss(large, tank.simulation.model(), state);
    EXPECT_GT(most, 0.049 * counted);
    EXPECT_LT(most, 1);
    EXPECT_EQ(accepted_miss(least, tank.simulation.model(), state), -most);
    keep_first_residual(most, accounts, state.ledger);
    EXPECT_THAT(problem(1e9, 11), HasSubstr("the energy ledger misses"));
}

TEST(LedgerVerdict, KeepsWhatTheFirstStepsMissedInTheState) {
    StillTank tank;
    const sim::Accounts accounts = accounts_of(tank.simulation.model());
    Simulation short_run(scene::read_case_text(
        riprap::run::tank("planar_dda", body("block", "box = [0.2, 0.16]", "position = [0.5, 0.08]"), 1900, 0.05),
        "case.toml", "."));
    while (short_run.state().step < first_steps) {
        ASSERT_TRUE(short_run.step(sim::Measure::energy).is_accepted());
    }
    EXPECT_EQ(first_residual(accounts, short_run.state().ledger), short_run.report().ledger.residual);
    EXPECT_EQ(first_residual(accounts, tank.simulation.state().ledger),
              first_residual(accounts, short_run.state().ledger));
}

TEST(LedgerVerdict, TakesRoundOffOfGreatEnergiesForNothing) {
    StillTank tank;
    tank.ledger.fluid.potential = 1e12;  // a tank on a mountain
    EXPECT_THAT(tank.problem(900, 0), IsEmpty());
    EXPECT_THAT(tank.problem(1100, 0), HasSubstr("the energy ledger misses"));
}

}  // namespace
}  // namespace riprap::run
