// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/step_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/scene/warnings/hard_impacts.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/solid/travel_bound.hpp"

namespace riprap::run {

namespace {

/// Smallest radius of the parts that a body may meet, or of the spheres that the method puts in their place [m].
double thinnest_of(const sim::Model& model) {
    return std::min(solid::smallest_radius(model.bodies, model.shapes), sim::smallest_stand_in(model));
}

/// Tells whether bodies may approach each other in a step by more than is allowed; in doubt true.
bool can_come_near(const sim::Model& model, const sim::State& state, double dt) {
    return dt * solid::approach_limit(model.bodies, model.shapes, state.bodies) >
           solid::most_approach * thinnest_of(model);
}

}  // namespace

sim::TimeStep choose_step(const sim::Model& model, sim::State& state, sim::Scratch& scratch) {
    sim::TimeStep step = sim::choose_time_step(model, state, scratch);
    if (!model.time.is_automatic() || step.steps_left == 0 || !can_come_near(model, state, step.dt)) {
        return step;
    }
    const double approach = solid::fastest_approach(model.bodies, model.shapes, state.bodies);
    // A step that was refused is halved whatever had bounded it.
    const double bound =
        std::ldexp(solid::most_approach * thinnest_of(model) / approach, -static_cast<int>(state.stepping.halvings));
    if (step.dt > bound) {
        const double span = step.dt * static_cast<double>(step.steps_left);
        step.steps_left = sim::steps_across(span, bound);
        step.dt = span / static_cast<double>(step.steps_left);
    }
    return step;
}

std::string step_problem(const sim::Model& model, const sim::State& state, double dt) {
    if (model.time.is_automatic() || !can_come_near(model, state, dt)) {
        return "";
    }
    const double thinnest = thinnest_of(model);
    if (!(dt * solid::fastest_approach(model.bodies, model.shapes, state.bodies) > thinnest)) {
        return "";
    }
    for (std::int32_t b = 0; b < model.bodies.size(); ++b) {
        const double speed = norm(state.bodies.velocity[at(b)]);
        if (!(speed * dt > thinnest) || model.bodies.part_begin[at(b)] == model.bodies.part_begin[at(b) + 1]) {
            continue;
        }
        const scene::Meeting met = scene::first_met(model, state, BodyId{b}, state.bodies.velocity[at(b)] / speed);
        const auto radius_of = [&](std::int32_t part) {
            return model.shapes.view(model.bodies.parts[at(part)].shape).inscribed_radius;
        };
        const double own = radius_of(model.bodies.part_begin[at(b)]);
        if (met.part >= 0 && std::isfinite(own) && speed * dt > std::min(own, radius_of(met.part)) &&
            met.distance < speed * dt + own) {
            return fmt::format(
                "in a time_step of {:.4g} s {} moves {:.3g} m towards {}, more than the inscribed radius "
                "of one of them, at t = {:.6g} s: it could pass unseen",
                dt, model.bodies.name(BodyId{b}), speed * dt, model.bodies.name(met.other), state.time);
        }
    }
    return "";
}

}  // namespace riprap::run
