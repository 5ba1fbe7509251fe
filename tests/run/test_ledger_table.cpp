// SPDX-License-Identifier: Apache-2.0
// The table of accounts is the balance of energy: its lines, each on its side, add up to what the ledger misses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <sstream>
#include <vector>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/run/simulate/summary.hpp"
#include "riprap/sim/ledger_table.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::run {
namespace {

Simulation make(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return Simulation(scene::read_case_text(text.str(), "case.toml", "/nonexistent", {}));
}

/// Sum of the accounts of a case, and the size of the largest.
struct Balance {
    double sum{0}, size{0};
};

Balance balance_of(const Simulation& simulation) {
    Balance balance;
    const sim::Ledger& ledger = simulation.report().ledger;
    for (const sim::LedgerLine& line : sim::ledger_lines()) {
        if (has_line(simulation.model(), line) && line.entry != riprap::Balance::aside) {
            const double value = value_of(line, simulation.model(), ledger);
            balance.sum += line.entry == riprap::Balance::gained ? -value : value;
            balance.size = std::max(balance.size, std::abs(value));
        }
    }
    return balance;
}

TEST(LedgerTable, AccountsOfEveryMethodAddUpToTheResidual) {
    int cases = 0;
    for (const auto& entry : std::filesystem::directory_iterator("tests/run/methods")) {
        Simulation simulation = make(entry.path());
        ASSERT_TRUE(simulation.step(sim::Measure::energy).is_accepted()) << entry.path();
        const sim::Ledger first = simulation.report().ledger;
        const Balance before = balance_of(simulation);
        for (int k = 0; k < 3; ++k) {
            ASSERT_TRUE(simulation.step(sim::Measure::energy).is_accepted()) << entry.path();
        }
        const sim::Ledger& last = simulation.report().ledger;
        const Balance after = balance_of(simulation);
        EXPECT_NEAR(after.sum - before.sum + last.fluid.coupling_gap - first.fluid.coupling_gap,
                    last.residual - first.residual, 1e-12 * std::max(before.size, after.size))
            << entry.path();
        ++cases;
    }
    EXPECT_GE(cases, 8);
}

TEST(LedgerTable, TheSummaryHoldsTheAccountsOfTheMethodsOfTheCaseAndNoOthers) {
    Simulation simulation = make("tests/run/methods/fluid-sph.toml");
    for (int k = 0; k < 3; ++k) {
        ASSERT_TRUE(simulation.step(sim::Measure::energy).is_accepted());
    }
    const auto ledger = nlohmann::json::parse(summary_json(simulation.summary())).at("ledger");
    EXPECT_EQ(ledger.at("fluid.kinetic").get<double>(), simulation.report().ledger.fluid.kinetic);
    for (const char* const name : {"fluid.viscous", "fluid.diffusion", "fluid.wall_exchange", "fluid.shifting",
                                   "fluid.tearing", "fluid.volume_by_flow", "fluid.volume_by_tearing", "solid.friction",
                                   "solid.contact_damping", "solid.damping", "fluid.mass"}) {
        EXPECT_TRUE(ledger.contains(name)) << name;
    }
    EXPECT_NE(ledger.at("fluid.volume_by_flow").get<double>(), 0);
    const sim::QuantityInfo* const spread = sim::find_quantity("fluid.volume_by_flow", false);
    ASSERT_NE(spread, nullptr);
    EXPECT_EQ(spread->unit, "m^3");
    EXPECT_FALSE(ledger.contains("solid.strain"));
    Simulation dry = make("tests/run/methods/solid-implicit_dda.toml");
    ASSERT_TRUE(dry.step(sim::Measure::energy).is_accepted());
    const auto of_blocks = nlohmann::json::parse(summary_json(dry.summary())).at("ledger");
    EXPECT_TRUE(of_blocks.contains("solid.strain"));
    EXPECT_TRUE(of_blocks.contains("solid.numerical_damping"));
}

// Totals of a checkpoint from before water had a book of volume.
TEST(LedgerTable, TotalsWithoutYoungAccountsAreTakenUpWithNothingInThem) {
    const Simulation simulation = make("tests/run/methods/fluid-sph.toml");
    const sim::Accounts accounts = accounts_of(simulation.model());
    const std::ptrdiff_t young = fluid_account(accounts, first_young_account);
    ASSERT_GT(young, 0);
    const sim::Accounts old{accounts.solid, accounts.fluid.first(static_cast<std::size_t>(young))};
    sim::LedgerState state, whole;
    reset(old, state);
    reset(accounts, whole);
    std::iota(state.totals.begin(), state.totals.end(), 1.0);
    const std::vector<double> totals = state.totals;
    ASSERT_TRUE(take_up_old_totals(accounts, state));
    ASSERT_EQ(state.totals.size(), whole.totals.size());
    const auto first_zero = std::find(state.totals.begin(), state.totals.end(), 0.0);
    const auto count = static_cast<std::ptrdiff_t>(accounts.fluid.size()) - young;
    EXPECT_TRUE(std::all_of(first_zero, first_zero + count, [](double total) { return total == 0; }));
    EXPECT_EQ(*(first_zero - 1), static_cast<double>(first_zero - state.totals.begin()));
    std::erase(state.totals, 0.0);
    EXPECT_EQ(state.totals, totals);
    state.totals.pop_back();
    EXPECT_FALSE(take_up_old_totals(accounts, state));
}

}  // namespace
}  // namespace riprap::run
