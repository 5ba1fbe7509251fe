// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/coupling/fluid_report.hpp"
#include "riprap/sim/ledger.hpp"
#include "riprap/sim/state.hpp"
#include "riprap/solid/solid_scene.hpp"

namespace riprap::sim {

/// Adds one step to the running totals and returns the ledger at the kick. Rates known at the kick count half before
/// and half after it (trapezoid between kicks); losses measured since the last kick count whole.
Ledger account(const solid::SolidReport& step, LedgerState& state);

/// What one step of water brings to its ledger.
struct WaterLedgerStep {
    const coupling::FluidStep& step;
    double work_seen;   ///< on free bodies, as the water says [J]
    double work_given;  ///< as the bodies say [J]
};

/// Adds one step of water to the totals and its part to the ledger of the same kick.
void account_water(const WaterLedgerStep& step, LedgerState& state, Ledger& ledger);

/// Adds what passed the openings after that kick: the next one finds it in the water.
void account_passage(const fluid::Passage& passage, LedgerState& state);

/// Empties the ledger: the next kick becomes its reference.
void reset(LedgerState& state);

}  // namespace riprap::sim
