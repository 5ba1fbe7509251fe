// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/simulate/step_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "riprap/run/simulate/swept_bodies.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/solid/driven_travel.hpp"
#include "riprap/solid/travel_bound.hpp"

namespace riprap::run {

namespace {

/// Smallest radius of the parts that a body may meet, or of the spheres that the method puts in their place [m].
double thinnest_of(const sim::Model& model) {
    return std::min(solid::smallest_radius(model.bodies, model.shapes), sim::smallest_stand_in(model));
}

/// Tells whether bodies may approach each other in a step by more than `allowed`; in doubt true.
bool can_come_near(const sim::Model& model, const sim::State& state, double dt, double allowed) {
    return dt * solid::approach_limit(model.bodies, model.shapes, state.bodies) > allowed;
}

/// Longest way of a driven body in a step from here [m].
double driven_way(const sim::Model& model, const sim::State& state, double dt) {
    return solid::driven_travel(model.bodies, model.shapes, state.time, state.time + dt);
}

/// Cuts a step, in equal parts to the end of the run.
void cut(sim::TimeStep& step, double bound) {
    if (step.dt > bound) {
        const double span = step.dt * static_cast<double>(step.steps_left);
        step.steps_left = sim::steps_across(span, bound);
        step.dt = span / static_cast<double>(step.steps_left);
    }
}

}  // namespace

sim::TimeStep choose_step(const sim::Model& model, sim::State& state, sim::Scratch& scratch) {
    sim::TimeStep step = sim::choose_time_step(model, state, scratch);
    if (!model.time.is_automatic() || step.steps_left == 0) {
        return step;
    }
    const double allowed = solid::most_approach * thinnest_of(model);
    if (can_come_near(model, state, step.dt, allowed)) {
        // A step that was refused is halved whatever had bounded it.
        const double bound = allowed / solid::fastest_approach(model.bodies, model.shapes, state.bodies);
        cut(step, std::ldexp(bound, -static_cast<int>(state.stepping.halvings)));
    }
    // A table may move a body that rests now: halved until the step ends before that, or within it.
    const double least = 16 * std::numeric_limits<double>::epsilon() * (state.time + step.dt);
    for (double dt = step.dt; dt > least && driven_way(model, state, step.dt) > 2 * allowed; cut(step, dt)) {
        dt *= 0.5;
    }
    return step;
}

std::string step_problem(const sim::Model& model, const sim::State& state, double dt) {
    if (model.time.is_automatic() && model.bodies.driven_bodies.empty()) {
        return "";
    }
    const double thinnest = thinnest_of(model);
    const bool is_fast = !model.time.is_automatic() && can_come_near(model, state, dt, thinnest) &&
                         dt * solid::fastest_approach(model.bodies, model.shapes, state.bodies) > thinnest;
    if (!is_fast && !(driven_way(model, state, dt) > thinnest)) {
        return "";
    }
    const std::optional<Sweep> sweep = find_sweep(model, state, dt);
    if (!sweep) {
        return "";
    }
    return fmt::format(
        "in a time_step of {:.4g} s {} moves {:.3g} m, through {} or deep into it: more than the inscribed radius of "
        "one of them, at t = {:.6g} s: it could pass unseen",
        dt, model.bodies.name(sweep->body), sweep->way, model.bodies.name(sweep->other), state.time);
}

}  // namespace riprap::run
