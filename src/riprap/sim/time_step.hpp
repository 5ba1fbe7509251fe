// SPDX-License-Identifier: Apache-2.0
#pragma once

// Length of the next step. Everything here is a function of Model and State alone, so a resumed run takes the same
// steps as one that was never stopped, at any number of threads.

#include <cstdint>
#include <string>

#include "riprap/sim/cycle.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::sim {

class Scratch;

// Functions that ask methods for their limits bind them to the State, which makes fields of theirs that are missing and
// brings up to date what they keep beside them: no value of a step changes.

/// Stability bound before any contact is known (docs/theory/time-step.md): every body fully covered by neighbours.
struct TimeStepBound {
    double limit{0};        ///< 2/omega_max, or the step that an implicit method wants [s]
    std::string reason;     ///< in words, for the log
    bool is_wanted{false};  ///< the step that an implicit method wants
};
TimeStepBound time_step_bound(const Model& model, State& state);
TimeStepBound time_step_bound(const Model& model);  ///< of a State with nothing in it

/// Returns the longest step that solids take: model.time.time_step, or factor * bound where that is automatic or where
/// there is a fluid whose step it then is [s]. @throws CaseError for a time_step above the bound, unless forced.
double largest_time_step(const Model& model, const TimeStepBound& bound);

/// Returns the step that the fluid allows from this State, which the solids cut into steps of their own.
TimeStepBound step_bound(const Model& model, State& state);

/// Returns the reason why a step that the case fixes cannot be taken from this State: it is longer than the water
/// allows and not forced. Empty where it can be taken, and where the step is automatic.
std::string fixed_step_problem(const Model& model, State& state);
std::string fixed_step_problem(const Model& model, const State& state, const StepLimit& fluid);

/// Shares a step of `dt` out between both sides, from what each allows.
/// @param fluid        of no meaning where the solids want no step of their own
/// @param fluid_leads  the step of the run is the fluid's
Cycle make_cycle(const Model& model, const State& state, const StepLimit& solids, const StepLimit& fluid,
                 bool fluid_leads, double dt);

/// The step to take from a State.
struct TimeStep {
    double dt{0};                ///< [s]
    std::int64_t steps_left{0};  ///< to model.time.end if all are like this one; 0 = the end is reached
};

/// Chooses the next step. A fixed time_step stays what it is, so that the last step may pass the end by up to one dt.
/// An automatic one is that of the water where there is any, which solids then cut into steps of their own, and
/// largest_time_step otherwise; halved State::stepping.halvings
/// times, then shortened so that equal steps meet the end exactly:
///
///     n = ceil((end - time) / allowed),   dt = (end - time) / n.
///
/// A method whose limit depends on its fields reads them from State here: what it keeps in Scratch for that must not
/// change the result.
/// @param scratch  keeps the bound, which depends on Model alone
TimeStep choose_time_step(const Model& model, State& state, Scratch& scratch);

/// The same where bodies were let go long ago, whose first steps in water of particles grow: what most steps of a run
/// are like.
TimeStep full_time_step(const Model& model, State& state, Scratch& scratch);

/// Equal steps of at most `dt` needed to cover `span` [s]; round-off in span/dt is forgiven. 0 where span is not
/// positive; saturates at 9e18.
std::int64_t steps_across(double span, double dt);

/// Number of halvings of a step before a run gives up, and number of accepted steps before it is doubled again.
inline constexpr std::int64_t max_halvings = 5;
inline constexpr std::int64_t steps_until_doubling = 32;

/// Makes the next step from this State half as long: for a step that was refused. False, and nothing changed, where
/// the step is fixed by the case or was halved max_halvings times already.
bool halve_time_step(const Model& model, State& state);

/// Counts an accepted step and doubles a halved step when it is time to. Called by `advance`.
void accept_step(StepControl& stepping);

}  // namespace riprap::sim
