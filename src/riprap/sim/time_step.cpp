// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/time_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/error.hpp"
#include "riprap/fluid/sph/sph_step.hpp"
#include "riprap/sim/scratch_data.hpp"
#include "riprap/solid/time_step.hpp"

namespace riprap::sim {

namespace {
constexpr const char* other_steps = "use \"auto\", a smaller step, or force_time_step = true";
}  // namespace

TimeStepBound time_step_bound(const Model& model) {
    const solid::DemTimeStep bound = solid::time_step_bound(model.bodies, model.shapes, model.materials);
    return {bound.limit, bound.body, bound.reason};
}

double largest_time_step(const Model& model, const TimeStepBound& bound) {
    const TimeSettings& time = model.time;
    if (time.is_automatic() || model.fluid) {
        return std::isfinite(bound.limit) ? time.factor * bound.limit : 1e-3 * time.end;
    }
    if (time.time_step > bound.limit && !time.force_time_step) {
        Diagnostic problem;
        problem.message = fmt::format("time_step = {:.6g} s is above the stability limit {:.6g} s ({})", time.time_step,
                                      bound.limit, bound.reason);
        problem.allowed = other_steps;
        throw CaseError(std::move(problem));
    }
    return time.time_step;
}

namespace {

std::string above_water_limit(const Model& model, const State& state) {
    const TimeSettings& time = model.time;
    if (!model.fluid || time.is_automatic() || time.force_time_step) {
        return {};
    }
    const fluid::FluidTimeStep water = choose_fluid_time_step(model.fluid->sph, state.fluid);
    return time.time_step > water.limit
               ? fmt::format("time_step = {:.6g} s is above what the water allows, {:.6g} s ({})", time.time_step,
                             water.limit, water.reason)
               : std::string();
}

/// The step that the case fixes: a case that starts above what the water allows is refused. Later it is the step.
double fixed_water_step(const Model& model, const State& state) {
    if (state.step == 0) {
        if (std::string message = above_water_limit(model, state); !message.empty()) {
            Diagnostic problem;
            problem.message = std::move(message);
            problem.allowed = other_steps;
            throw CaseError(std::move(problem));
        }
    }
    return model.time.time_step;
}

}  // namespace

std::string fixed_step_problem(const Model& model, const State& state) {
    const std::string message = above_water_limit(model, state);
    return message.empty() ? message : fmt::format("{} at t = {:.6g} s; {}", message, state.time, other_steps);
}

TimeStepBound step_bound(const Model& model, const State& state) {
    if (!model.fluid) {
        return time_step_bound(model);
    }
    const fluid::FluidTimeStep water = choose_fluid_time_step(model.fluid->sph, state.fluid);
    return {water.limit, BodyId{}, water.reason};
}

std::int64_t steps_across(double span, double dt) {
    constexpr double forgiven = 1e-9;  // of a step; span/dt carries a few units in the last place of error
    const double steps = std::ceil(span / dt * (1 - 1e-15) - forgiven);
    return static_cast<std::int64_t>(std::clamp(steps, 0.0, 9e18));
}

TimeStep choose_time_step(const Model& model, const State& state, Scratch& scratch) {
    std::optional<double>& largest = scratch.data().largest_time_step;
    if (!largest) {
        largest = largest_time_step(model, time_step_bound(model));
    }
    const double span = (model.time.end - state.time) + state.time_rest;
    if (!model.time.is_automatic()) {
        const double fixed = model.fluid ? fixed_water_step(model, state) : *largest;
        return {fixed, steps_across(span, fixed)};
    }
    const double limit = model.fluid ? choose_fluid_time_step(model.fluid->sph, state.fluid).limit : *largest;
    const double allowed = std::ldexp(limit, -static_cast<int>(state.stepping.halvings));
    const std::int64_t steps = steps_across(span, allowed);
    return {steps > 0 ? span / static_cast<double>(steps) : allowed, steps};
}

std::int64_t solid_substeps(const Model& model, const State& state, ScratchData& scratch, double dt) {
    if (!scratch.largest_time_step) {
        scratch.largest_time_step = largest_time_step(model, time_step_bound(model));
    }
    const double allowed = std::ldexp(*scratch.largest_time_step, -static_cast<int>(state.stepping.halvings));
    return std::max<std::int64_t>(1, steps_across(dt, allowed));
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
