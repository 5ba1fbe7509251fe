// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/remedy/end_causes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "riprap/core/index.hpp"
#include "riprap/run/remedy/contact_need.hpp"
#include "riprap/run/remedy/deep_pairs.hpp"
#include "riprap/run/remedy/ledger_advice.hpp"
#include "riprap/run/remedy/remedy_text.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/settings.hpp"
#include "riprap/solid/travel_bound.hpp"

namespace riprap::run {

namespace {

std::string as_the_method_says(const Refused& /*refused*/) { return ""; }

// Of contacts.

std::string carry_within_most_overlap(const Refused& refused) { return stiffness_advice(refused, solid::most_overlap); }

std::string carry_within_max_potential(const Refused& refused) {
    const solid::DemSettings* const dem = refused.model.dem();
    return stiffness_advice(refused,
                            dem != nullptr ? std::min(dem->max_potential, solid::most_overlap) : solid::most_overlap);
}

std::string carry_within_max_overlap(const Refused& refused) {
    const auto* const spheres = std::get_if<solid::SphereDemSettings>(&refused.model.solid);
    return stiffness_advice(refused, spheres != nullptr ? spheres->laws.max_overlap : solid::most_overlap);
}

/// Returns the stiffness that holds a body at the mouth of a gap: what it lets through is hardly deep in its sides.
std::string hold_at_the_mouth(const Refused& refused) { return stiffness_advice(refused, deep_overlap); }

/// Half of the step in which the two fastest bodies approach each other by solid::most_approach of the thinnest: their
/// first touch, anywhere within a step, is then within what a ledger may miss.
std::string step_that_sees(const Refused& refused) {
    const sim::Model& model = refused.model;
    const double approach = solid::fastest_approach(model.bodies, model.shapes, refused.before.bodies);
    const double step = 0.5 * solid::most_approach * solid::smallest_radius(model.bodies, model.shapes) / approach;
    return fmt::format("{} sees it, and \"auto\" chooses such a step", assignment_below("time_step", step));
}

/// Returns the load that alone gives its body more than the allowed speed within this step; null where none does.
const body::PointLoad* load_beyond(const Refused& refused, double allowed) {
    const body::BodySet& bodies = refused.model.bodies;
    const auto found = std::ranges::find_if(refused.model.loads, [&](const body::PointLoad& load) {
        const double speed = norm(load.at(refused.after.time)) / bodies.mass[at(load.body.value)] * refused.report.dt;
        return is_free(bodies, load.body, refused.before.time) && !(speed <= allowed);
    });
    return found == refused.model.loads.end() ? nullptr : &*found;
}

/// A finite speed that the case gives is no fault of the step.
std::string speed_or_step(const Refused& refused) {
    const sim::Model& model = refused.model;
    double fastest = 0;  // sqrt(2 K/m) of a body
    for (std::int32_t b = 0; b < model.bodies.size(); ++b) {
        if (is_free(model.bodies, BodyId{b}, refused.before.time)) {
            const Vec3 spin = angular_velocity(model.bodies, refused.before.bodies, BodyId{b});
            const double turning = dot(spin, refused.before.bodies.angular_momentum[at(b)]) / model.bodies.mass[at(b)];
            fastest = std::max(fastest, std::sqrt(norm_squared(refused.before.bodies.velocity[at(b)]) + turning));
        }
    }
    const double allowed = sim::max_speed(model);
    if (const double pull = norm(model.gravity.at(refused.before.time)); pull * refused.report.dt > allowed) {
        return fmt::format("{} m/s^2 or less keeps what falls for the whole run within solid.max_speed",
                           assignment_below("gravity", allowed / model.time.end));
    }
    if (const body::PointLoad* const load = load_beyond(refused, allowed); load != nullptr) {
        const double mass = model.bodies.mass[at(load->body.value)];
        return fmt::format("a force of {:.2g} N or less on '{}' keeps it within solid.max_speed for the whole run",
                           allowed * mass / model.time.end, model.bodies.name(load->body));
    }
    constexpr double nearly = 0.8;  // a body that was as fast a step before has its speed from the case
    return fastest > nearly * allowed
               ? fmt::format("{} where such a speed is meant", assignment("solid.max_speed", 2 * fastest))
               : shorter_step(refused);
}

std::string more_rounds_or_a_shorter_step(const Refused& refused) {
    constexpr int usual = 6, many = 24;
    const int rounds = sim::open_close(refused.model);
    return rounds > 0 && rounds < many ? fmt::format("solid.open_close = {}", std::max(usual, 2 * rounds))
                                       : shorter_step(refused);
}

/// Energy goes with the square of the strain: a modulus with which the block takes up what it has taken up at a quarter
/// of the logarithmic strain that it has.
std::string stiffer_blocks(const Refused& refused) {
    constexpr double bearable = 0.25;
    const auto* const elasticity = sim::elasticity_of(refused.model.solid);
    const double stretch = sim::max_stretch(refused.model);
    if (elasticity == nullptr || !(stretch > 0)) {
        return "";
    }
    const double factor = std::pow(std::log(stretch) / bearable, 2);
    return assignment("solid.youngs_modulus", factor * elasticity->youngs_modulus);
}

// Of water.

/// A domain as high as the water that left it would have risen: v^2/(2 g) above its top.
std::string higher_domain(const Refused& refused) {
    const sim::Model& model = refused.model;
    const fluid::Domain* const domain = sim::fluid_domain(model);
    const Vec3 gravity = model.gravity.at(refused.before.time);
    const double pull = norm(gravity);
    if (domain == nullptr) {
        return "";
    }
    int up = 0;
    for (int axis = 1; axis < domain->dimension; ++axis) {
        up = std::abs(gravity[axis]) > std::abs(gravity[up]) ? axis : up;
    }
    if (!(pull > 0) || gravity[up] > 0) {
        return "";
    }
    const double speed = fastest_fluid(refused);
    Vec3 high = domain->high;
    high[up] += speed * speed / (2 * pull) + 2 * sim::fluid_spacing(model);
    return domain->dimension == 2
               ? fmt::format("fluid.domain.high = [{:.6g}, {:.6g}] holds it", high.x, high.y)
               : fmt::format("fluid.domain.high = [{:.6g}, {:.6g}, {:.6g}] holds it", high.x, high.y, high.z);
}

std::string more_of_the_solver(const Refused& refused) {
    constexpr int usual = 1000;
    const coupling::ParticleFluid* const water = refused.model.particles();
    const auto* const mps = water != nullptr ? std::get_if<fluid::MpsSettings>(&water->scheme) : nullptr;
    if (mps == nullptr) {
        return "";
    }
    return refused.why.text.find("iterations allowed") != std::string::npos
               ? fmt::format("fluid.max_iterations = {}", std::max(usual, 4 * mps->max_iterations))
               : assignment("fluid.tolerance", 10 * mps->tolerance);
}

std::string automatic_step(const Refused& /*refused*/) { return assignment("time_step", "auto"); }

constexpr std::array causes{
    EndCause{"deep_contact", "deep in each other",
             "Two bodies lie so deep in each other that their contact would push them on: it is too soft for what they "
             "bring, or a driven body presses them.",
             "the stiffness that carries it: `normal_stiffness` of the materials, `solid.contact_stiffness`, or "
             "`solid.youngs_modulus` or `spring_stiffness` of spheres; the `stop` of a motion that presses",
             carry_within_most_overlap},
    EndCause{"squeezed", "is squeezed through between",
             "A body goes through a gap narrower than itself: its sides are too soft for what it brings.",
             "the stiffness that holds it at the mouth of the gap", hold_at_the_mouth},
    EndCause{"gone_through", "against the push with which they met",
             "Two bodies go through each other: their contact is too soft for what they bring.",
             "the stiffness that holds them where they meet", hold_at_the_mouth},
    EndCause{"deep_potential", "of an inscribed radius at", "An overlap is deeper than `solid.max_potential` allows.",
             "the stiffness that carries it", carry_within_max_potential},
    EndCause{"deep_spheres", "of the smaller sphere's radius",
             "Two spheres overlap by more than `solid.max_overlap` allows.",
             "`solid.youngs_modulus` or `solid.spring_stiffness` that carries it; the `stop` of a motion that presses",
             carry_within_max_overlap},
    EndCause{"unseen", "could pass unseen",
             "In a `time_step` of the case a body goes farther than it or what it comes to is thick.",
             "a shorter `time_step`", step_that_sees},
    EndCause{"fast_body", "allowed: finite,", "A body is faster than `solid.max_speed`, or its speed is no number.",
             "`solid.max_speed` where the case gives that speed, less force where a load gives it in one step, else a "
             "shorter step",
             speed_or_step},
    EndCause{"open_and_close", "open and close without end", "Contacts of a DDA open and close in turn within a step.",
             "more rounds of `solid.open_close`; a shorter step where there are many", more_rounds_or_a_shorter_step},
    EndCause{"long_way", "a corner moves",
             "A corner moves too far in a step of implicit or planar DDA, though it was "
             "cut to a thousandth.",
             "`time_step = \"auto\"`", automatic_step},
    EndCause{"strained", "is strained to", "A block of explicit DDA is pressed flat or torn long.",
             "`solid.youngs_modulus` with which it takes that up", stiffer_blocks},
    EndCause{"water_above_limit", "is above what the water allows",
             "The water moves so fast that a `time_step` of the case is too long for it.", "`time_step = \"auto\"`",
             automatic_step},
    EndCause{"fast_water", "is faster than the sound speed of the model",
             "Water is faster than the sound in it: its density is not that of water any more.", "`fluid.sound_speed`",
             faster_sound},
    EndCause{"lost_water", "has left the domain", "A particle has left `fluid.domain` where nothing holds it.",
             "a wall, an `[[fluid.outflow]]`, or a larger `fluid.domain`", as_the_method_says},
    EndCause{"left_water", "leaves the water through",
             "A free body goes through a side of the domain of a grid, which holds the water alone.",
             "a fixed body along that side, or a larger `fluid.domain`", as_the_method_says},
    EndCause{"splash", "have left through the", "More than a splash has left the domain through its top.",
             "a higher `fluid.domain`", higher_domain},
    EndCause{"unsolved_pressure", "the pressure equation of", "The solver of `mps` stops short of its tolerance.",
             "more `fluid.max_iterations`, or a larger `fluid.tolerance` where they do not help", more_of_the_solver},
    EndCause{"crowded_pocket", "too little room to the water in a closed pocket",
             "A body takes the room of water that cannot get away.",
             "a way out for the water, less water, or a motion that stops before", as_the_method_says},
    EndCause{"pressed_pocket", "presses together", "The same on a grid.",
             "a way out for the water, or a motion that stops before", as_the_method_says},
    EndCause{"drawn_pocket", "draws apart",
             "A body would make room in a pocket full of water, into which none can come.", "a way in for the water",
             as_the_method_says},
    EndCause{"through_walls", "of water have gone through walls",
             "Particles have gone through a wall thinner than two "
             "spacings.",
             "thicker walls, a smaller `fluid.spacing`, or less force", as_the_method_says},
    EndCause{"made_energy", "the numerics made", "The energy of the water grows out of nothing.",
             "`fluid.sound_speed` where water is pressed together, a smaller `fluid.spacing` where bodies leave a gap "
             "of one row of particles or shorter steps of a grid did not help, else a smaller `fluid.courant`",
             made_advice},
    EndCause{"ledger", "the energy ledger misses", "The energy of the scene does not add up.",
             "what made it: the stiffness of a contact that is deep, `solid.youngs_modulus` of blocks that are "
             "strained far, "
             "`time_step = \"auto\"` for a step above its bound, a shorter step of the side that misses it, "
             "`output.ledger_tolerance` where the case asks for more than "
             "its methods give",
             ledger_advice},
};

}  // namespace

std::span<const EndCause> end_causes() { return causes; }

const EndCause* cause_of(std::string_view message) {
    const auto found = std::find_if(causes.begin(), causes.end(), [message](const EndCause& cause) {
        return message.find(cause.says) != std::string_view::npos;
    });
    return found == causes.end() ? nullptr : &*found;
}

sim::StepStatus with_advice(const Refused& refused) {
    sim::StepStatus status = refused.why;
    const EndCause* const cause = cause_of(status.text);
    std::string advice = cause != nullptr ? cause->advise(refused) : "";
    if (!advice.empty()) {
        status.remedy = std::move(advice);
    }
    return status;
}

}  // namespace riprap::run
