// SPDX-License-Identifier: Apache-2.0
#pragma once

// The accounts of methods by name: the one table behind ledger.csv, summary.json, quantities and Python.

#include <string>
#include <string_view>
#include <vector>

#include "riprap/sim/ledger_account.hpp"
#include "riprap/sim/model.hpp"

namespace riprap::sim {

/// One account of one side: "solid.friction", "fluid.viscous".
struct LedgerLine {
    std::string name;
    Balance entry;
    std::string_view help;
    bool is_artificial{false};
    double Ledger::*of_solid{nullptr};       ///< account of every solid; null for others
    double FluidLedger::*of_fluid{nullptr};  ///< account of every fluid; null for others
    bool is_of_fluid{false};
    std::string_view unit{"J"};
};

/// Returns the accounts that the methods of a case name themselves.
Accounts accounts_of(const Model& model);

/// Returns the accounts of every registered method, solids first: those that all methods have, then their own. A name
/// that several methods use stands once.
const std::vector<LedgerLine>& ledger_lines();

/// Tells whether the methods of a case have an account.
bool has_line(const Model& model, const LedgerLine& line);

/// Returns the amount of an account in its unit; NaN where the methods of the case do not have it.
double value_of(const LedgerLine& line, const Model& model, const Ledger& ledger);
/// Returns the amount of the account called `name`; NaN where there is none.
double value_of(std::string_view name, const Model& model, const Ledger& ledger);

}  // namespace riprap::sim
