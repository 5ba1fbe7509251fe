// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/open/open_boundary.hpp"
#include "riprap/fluid/sph/sph_step.hpp"
#include "riprap/sim/ledger.hpp"
#include "riprap/sim/state.hpp"
#include "riprap/solid/explicit_dem.hpp"

namespace riprap::sim {

/// What one step brings to the ledger.
struct LedgerStep {
    const solid::KickReport& kick;
    double kick_time;      ///< [s]
    Vec3 gravity;          ///< at the kick [m/s^2]
    double elastic;        ///< stored in overlaps [J]; read where has_elastic
    bool has_elastic;      ///< always so at the first kick
    double shear;          ///< stored in tangential springs [J]
    double friction_loss;  ///< since the last kick [J]
    double damping_loss;   ///< of contact dashpots in this step, half of it after the kick [J]
};

/// Adds one step to the running totals and returns the ledger at the kick. Rates known at the kick count half before
/// and half after it (trapezoid between kicks); losses measured since the last kick count whole.
Ledger account(const LedgerStep& step, LedgerState& state);

/// What one step of water brings to its ledger.
struct WaterLedgerStep {
    const fluid::FluidReport& fluid;
    double absorbed;    ///< by sponges; also in fluid.work_external, with a minus [J]
    double flow_work;   ///< at inflows and outflows; also in fluid.work_on_solids [J]
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
