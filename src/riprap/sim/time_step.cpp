// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/time_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "riprap/core/error.hpp"
#include "riprap/sim/bound_methods.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/scratch_data.hpp"

namespace riprap::sim {

namespace {
constexpr const char* other_steps = "use \"auto\", a smaller step, or force_time_step = true";
}  // namespace

namespace {

/// Steps that solids and fluid allow from this State.
struct Limits {
    StepLimit solids, fluid;
    bool fluid_leads{false};  ///< the fluid's step is that of the run; else the solids'
};

Limits limits_of(const Model& model, State& state, ScratchData& scratch) {
    BoundMethods bound(model, state, scratch);
    return {bound.solid_limit(), bound.fluid().limit(), bound.fluid_leads()};
}

Limits limits_of(const Model& model, State& state) {
    ScratchData scratch;
    return limits_of(model, state, scratch);
}

double automatic_step(const Model& model, const StepLimit& solids) {
    const double factor = solids.is_wanted ? 1 : model.time.factor;
    return std::isfinite(solids.longest) ? factor * solids.longest : 1e-3 * model.time.end;
}

/// Returns the longest step that solids take. @throws CaseError
double largest_step(const Model& model, const Limits& limits) {
    const TimeSettings& time = model.time;
    if (time.is_automatic() || limits.fluid_leads) {
        return automatic_step(model, limits.solids);
    }
    if (!limits.solids.is_wanted && time.time_step > limits.solids.longest && !time.force_time_step) {
        Diagnostic problem;
        problem.message = fmt::format("time_step = {:.6g} s is above the stability limit {:.6g} s ({})", time.time_step,
                                      limits.solids.longest, limits.solids.reason);
        problem.allowed = other_steps;
        throw CaseError(std::move(problem));
    }
    return time.time_step;
}

std::string above_fluid_limit(const Model& model, const StepLimit& fluid) {
    const TimeSettings& time = model.time;
    return !time.is_automatic() && !time.force_time_step && time.time_step > fluid.longest
               ? fmt::format("time_step = {:.6g} s is above what the water allows, {:.6g} s ({})", time.time_step,
                             fluid.longest, fluid.reason)
               : std::string();
}

/// Returns the step that the case fixes: a case that starts above what the water allows is refused. Later it is the
/// step.
double fixed_fluid_step(const Model& model, const State& state, const StepLimit& fluid) {
    if (state.step == 0) {
        if (std::string message = above_fluid_limit(model, fluid); !message.empty()) {
            Diagnostic problem;
            problem.message = std::move(message);
            problem.allowed = other_steps;
            throw CaseError(std::move(problem));
        }
    }
    return model.time.time_step;
}

}  // namespace

TimeStepBound time_step_bound(const Model& model, State& state) {
    const StepLimit solids = limits_of(model, state).solids;
    return {solids.longest, solids.reason, solids.is_wanted};
}

TimeStepBound time_step_bound(const Model& model) {
    State empty;
    return time_step_bound(model, empty);
}

double largest_time_step(const Model& model, const TimeStepBound& bound) {
    Limits limits;
    limits.solids = {bound.limit, bound.is_wanted, bound.reason};
    limits.fluid_leads = fluid_leads(model);
    return largest_step(model, limits);
}

std::string fixed_step_problem(const Model& model, const State& state, const StepLimit& fluid) {
    const std::string message = above_fluid_limit(model, fluid);
    return message.empty() ? message : fmt::format("{} at t = {:.6g} s; {}", message, state.time, other_steps);
}

std::string fixed_step_problem(const Model& model, State& state) {
    return fixed_step_problem(model, state, limits_of(model, state).fluid);
}

TimeStepBound step_bound(const Model& model, State& state) {
    const Limits limits = limits_of(model, state);
    const StepLimit& leader = limits.fluid_leads ? limits.fluid : limits.solids;
    return {leader.longest, leader.reason, leader.is_wanted};
}

Cycle make_cycle(const Model& model, const State& state, const StepLimit& solids, const StepLimit& fluid,
                 bool fluid_leads, double dt) {
    Cycle cycle{state.time, dt, 1, 1};
    if (!fluid_leads) {
        return cycle;
    }
    const double allowed = std::ldexp(automatic_step(model, solids), -static_cast<int>(state.stepping.halvings));
    cycle.pieces = std::max<std::int64_t>(1, steps_across(dt, allowed));
    if (solids.is_wanted && model.time.is_automatic()) {
        const double longest =
            std::ldexp(std::min(fluid.longest, fluid.at_start), -static_cast<int>(state.stepping.halvings));
        cycle.spans = std::max<std::int64_t>(1, steps_across(dt, longest));
    }
    return cycle;
}

std::int64_t steps_across(double span, double dt) {
    constexpr double forgiven = 1e-9;  // of a step; span/dt carries a few units in the last place of error
    const double steps = std::ceil(span / dt * (1 - 1e-15) - forgiven);
    return static_cast<std::int64_t>(std::clamp(steps, 0.0, 9e18));
}

namespace {

/// Bodies that start in water at another speed give it their momentum in the first step. Both sides have to take that
/// one together: solids that feel the mean of several steps of the water move on while it has stopped them already.
bool starts_with_a_jolt(const Model& model, const State& state) {
    for (std::size_t b = 0; state.step == 0 && b < state.bodies.velocity.size(); ++b) {
        const bool moves = state.bodies.velocity[b] != Vec3{} || state.bodies.angular_momentum[b] != Vec3{};
        if (moves && model.bodies.drive[b] == body::Drive::free) {
            return true;
        }
    }
    return false;
}

/// Steps of scenes with bodies that forces move, in water of particles, grow from this share of what the water allows
/// by this share of the time since they were let go [-].
constexpr double first_share = 0.02, share_of_time = 0.05;

/// Time since a body was last left to the forces on it; infinite where there is none [s].
double time_since_let_go(const Model& model, double time) {
    double since = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < model.bodies.drive.size(); ++b) {
        const double let_go = model.bodies.drive[b] == body::Drive::fixed ? model.bodies.release_time[b] : 0;
        since = let_go <= time ? std::min(since, time - let_go) : since;
    }
    return since;
}

/// Returns the longest step soon after bodies were let go. Water meets walls where bodies are predicted to go by the
/// acceleration of the last step, and what they do otherwise is missing in the energy, F (a - a_predicted) dt^2/2.
/// While bodies take up their weight and contacts close, for which no force is known before, that would be much of what
/// little is turned over. MPS has its own step: it takes back a share of each error of density in a step, however
/// short.
double longest_at_start(const Model& model, double time, double allowed_by_water) {
    const coupling::ParticleFluid* const water = model.particles();
    const bool grows = water != nullptr && !std::holds_alternative<fluid::MpsSettings>(water->scheme);
    return grows ? first_share * allowed_by_water + share_of_time * time_since_let_go(model, time)
                 : std::numeric_limits<double>::infinity();
}

TimeStep choose(const Model& model, State& state, Scratch& scratch, bool grows_at_start) {
    const Limits limits = limits_of(model, state, scratch.data());
    const double span = (model.time.end - state.time) + state.time_rest;
    if (!model.time.is_automatic()) {
        const double fixed =
            limits.fluid_leads ? fixed_fluid_step(model, state, limits.fluid) : largest_step(model, limits);
        return {fixed, steps_across(span, fixed)};
    }
    const double of_fluid =
        grows_at_start ? std::min(limits.fluid.longest, limits.fluid.at_start) : limits.fluid.longest;
    double limit = limits.fluid_leads ? of_fluid : largest_step(model, limits);
    if (limits.fluid_leads && limits.solids.is_wanted) {
        limit = starts_with_a_jolt(model, state) ? std::min(limit, limits.solids.longest)
                                                 : std::max(limit, limits.solids.longest);
    }
    if (limits.fluid_leads && grows_at_start) {
        limit = std::min(limit, longest_at_start(model, state.time, limits.fluid.longest));
    }
    const double allowed = std::ldexp(limit, -static_cast<int>(state.stepping.halvings));
    // A run that is shorter than a billionth of a step that would be allowed takes one step all the same.
    const std::int64_t steps = state.step == 0 && span > 0 ? std::max<std::int64_t>(1, steps_across(span, allowed))
                                                           : steps_across(span, allowed);
    return {steps > 0 ? span / static_cast<double>(steps) : allowed, steps};
}

}  // namespace

TimeStep choose_time_step(const Model& model, State& state, Scratch& scratch) {
    return choose(model, state, scratch, true);
}

TimeStep full_time_step(const Model& model, State& state, Scratch& scratch) {
    return choose(model, state, scratch, false);
}

bool halve_time_step(const Model& model, State& state) {
    if (!model.time.is_automatic() || state.stepping.halvings >= max_halvings) {
        return false;
    }
    state.stepping.halvings += 1;
    state.stepping.accepted = 0;
    return true;
}

void accept_step(StepControl& stepping) {
    if (stepping.halvings == 0) {
        return;
    }
    stepping.accepted += 1;
    if (stepping.accepted >= steps_until_doubling) {
        stepping.halvings -= 1;
        stepping.accepted = 0;
    }
}

}  // namespace riprap::sim
