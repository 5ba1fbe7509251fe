// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "riprap/core/account.hpp"
#include "riprap/coupling/fluid_step.hpp"
#include "riprap/sim/ledger.hpp"
#include "riprap/sim/state.hpp"
#include "riprap/solid/solid_scene.hpp"

namespace riprap::sim {

/// Own accounts of the methods of a scene.
struct Accounts {
    std::span<const Account> solid, fluid;
};

/// Name that a fluid gives to the account of what its balance lacks: a loss, so below zero energy came from nowhere.
/// Its value at a kick follows from all others, and the residual of the fluid is zero by construction.
inline constexpr std::string_view rest_name = "dissipated";
/// Name that a fluid gives to the account of work on the strain of blocks that its walls do not follow: a loss below
/// zero, for what the blocks get comes from nothing that the fluid has.
inline constexpr std::string_view straining_name = "straining";
/// Returns the number of an account among those of the fluid; -1 without it.
std::ptrdiff_t fluid_account(const Accounts& accounts, std::string_view name);
inline std::ptrdiff_t rest_account(const Accounts& accounts) { return fluid_account(accounts, rest_name); }

/// Adds one step to the running totals and returns the ledger at the kick. Rates known at the kick count half before
/// and half after it (trapezoid between kicks); losses measured since the last kick count whole.
Ledger account(const solid::SolidReport& step, const Accounts& accounts, LedgerState& state);

/// Contribution of one step of the fluid to its ledger.
struct FluidLedgerStep {
    const coupling::FluidStep& step;
    double work_seen;   ///< on free bodies, as the fluid says [J]
    double work_given;  ///< as the bodies say [J]
};

/// Adds one step of the fluid to the totals and its part to the ledger of the same kick.
void account_fluid(const FluidLedgerStep& step, const Accounts& accounts, LedgerState& state, Ledger& ledger);

/// Adds what came in and left after that kick: the next one finds it in the fluid.
void account_transport(const coupling::Transported& transported, LedgerState& state);

/// Empties the ledger: the next kick becomes its reference.
void reset(const Accounts& accounts, LedgerState& state);

/// Returns by how much the account rest_name of a fluid has fallen below a value that it had before, at most [J]: the
/// energy that came from nowhere in one go, which a net sum hides behind what was lost before. Zero without it.
double largest_rise(const Accounts& accounts, const LedgerState& state);

/// Residual of the first steps, which is judged with them and not again with what is turned over later [J].
void keep_first_residual(double residual, const Accounts& accounts, LedgerState& state);
double first_residual(const Accounts& accounts, const LedgerState& state);

/// Lengthens totals that a version without these, without what the fluid has turned over and the work of a changing
/// gravity, or without young accounts, wrote; tells whether they fit then.
bool take_up_old_totals(const Accounts& accounts, LedgerState& state);

}  // namespace riprap::sim
