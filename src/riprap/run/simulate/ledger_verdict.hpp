// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/sim/ledger.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::run {

/// Steps from the start in which a ledger is judged with more room: see ledger_problem.
inline constexpr std::int64_t first_steps = 10;

/// Share of the turnover that the artificial terms of a fluid may make, or take until that is told [-]. A tenth is what
/// a validation row of energy allows; the figure itself is `artificial_share` of every run.
inline constexpr double most_artificial = 0.1;

/// Returns the residual of a ledger over what was turned over [-]; 0 where it is no more than round-off after so many
/// steps, each of which rounds the largest energy by half a unit in the last place: a body that rests turns nothing
/// over but that.
double missed_share(const sim::Ledger& ledger, std::int64_t steps);

/// Returns why a ledger ends the run, with the body that has most of the energy; empty where it closes, to
/// output.ledger_tolerance of what counts:
///
///   - what was turned over so far (Ledger::turnover);
///   - the kinetic energy that is there, of bodies and water: a body in free flight turns nothing over, and the error
///     of its motion is a share of its energy;
///   - with water, what lifts all of it by one spacing: when it is let go, its lattice settles by hundredths of that;
///   - in the first steps, what each body wins by falling a tenth of its inscribed radius: a contact that opens or
///     closes between two kicks is not small yet beside what was turned over.
///
/// A residual within 1e-9 of the energies that are there is round-off. Methods that do not book all that they dissipate
/// step by step (DDA, spheres, MPS, grids) are judged after the first steps only. Then, too, what the artificial terms
/// of the fluid made in all may be no more than most_artificial of what counts: a ledger that books it closes all the
/// same. Of an account that is what the balance lacks (sim::rest_name) its largest rise counts, not its sum.
/// What the first steps missed and were allowed (accepted_miss) is not counted again with less room: a miss that grows
/// no more ends no run.
/// @param step  number of the step that the ledger is of, from 1
std::string ledger_problem(const sim::Ledger& ledger, const sim::Model& model, const sim::State& state,
                           std::int64_t step);

/// Returns the miss at the end of the first steps, no more than these may have [J]; kept in the State
/// (sim::keep_first_residual).
double accepted_miss(const sim::Ledger& ledger, const sim::Model& model, const sim::State& state);

/// Returns how much of the energy turned over the artificial terms of the fluid took, largest first: diffusion of
/// density, shifting, the exchange with walls; viscosity has an account of its own. Beside little turnover counts what
/// lifts all water by one spacing, as in ledger_problem. Empty below most_artificial.
std::string artificial_text(const sim::Ledger& ledger, const sim::Model& model);

}  // namespace riprap::run
