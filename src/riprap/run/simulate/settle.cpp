// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/simulate/settle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "riprap/run/simulate/simulation.hpp"
#include "riprap/scene/text/toml_reader.hpp"
#include "riprap/sim/time_step.hpp"
#include "riprap/solid/affine/blocks.hpp"

namespace riprap::run {

namespace {

/// Bodies slower than this are at rest [m/s].
constexpr double rest_speed = 0.01;

/// Shares of its velocity that explicit methods take from a body in each step of a static settle. At the usual step of
/// rigid bodies the fastest mode then has a damping ratio of a sixth, slower ones have more. Steps of explicit DDA are
/// bounded by the strain of blocks, which swings some ten times as fast as blocks swing on their contacts.
constexpr double damped_share = 0.1, damped_share_of_strained = 0.01;

/// The keys of the case that only this file reads.
struct Settling {
    bool is_static{false};
    double time_step{0};             ///< 0 = that of the case [s]
    std::optional<double> friction;  ///< of all contacts, instead of that of the case [-]
};

Settling settling_of(const scene::LoadedCase& loaded) {
    std::vector<Diagnostic> ignored;
    const scene::Value checked = scene::parse_toml(loaded.resolved_toml, "the resolved case", ignored);
    const scene::Value *is_static = checked.find("settle_static"), *step = checked.find("settle_time_step"),
                       *friction = checked.find("settle_friction");
    Settling settling{is_static != nullptr && is_static->boolean, step != nullptr ? step->as_number() : 0, {}};
    if (friction != nullptr) {
        settling.friction = friction->as_number();
    }
    return settling;
}

/// Takes inertia out of the settings of a method: implicit ones start each step at rest, explicit ones are damped.
struct WithoutInertia {
    double dt;  ///< [s]
    void operator()(solid::DemSettings& settings) const { settings.mass_damping = damped_share / dt; }
    void operator()(solid::SphereDemSettings& settings) const { settings.laws.mass_damping = damped_share / dt; }
    void operator()(solid::ExplicitDdaSettings& settings) const {
        settings.engine.mass_damping = damped_share_of_strained / dt;
    }
    void operator()(solid::ImplicitDdaSettings& settings) const { settings.engine.dynamic = 0; }
    void operator()(solid::PlanarDdaSettings& settings) const { settings.engine.dynamic_factor = 0; }
};

/// Gives a method with a step of its own another one. @returns whether it has one
struct OtherStep {
    double step;  ///< [s]
    bool operator()(solid::ImplicitDdaSettings& settings) const { return settings.step = step, true; }
    bool operator()(solid::PlanarDdaSettings& settings) const { return settings.step = step, true; }
    bool operator()(auto& /*settings*/) const { return false; }
};

void change_method(sim::Model& model, sim::State& state, const Settling& settling) {
    if (settling.time_step > 0) {
        model.time.time_step = std::visit(OtherStep{settling.time_step}, model.solid) ? 0 : settling.time_step;
    }
    if (settling.friction) {
        for (material::PairProperties& pair : model.materials.pairs) {
            pair.friction = *settling.friction;
        }
    }
    if (settling.is_static) {
        const double dt = sim::largest_time_step(model, sim::time_step_bound(model, state));
        std::visit(WithoutInertia{dt}, model.solid);
    }
}

/// Gives the blocks of a method the velocities of bodies, without strain rates.
struct GiveVelocities {
    const body::BodySet& set;
    const body::BodyState& bodies;

    Vec3 spin(std::size_t b) const {
        return set.principal_moments[b].x > 0
                   ? body::angular_velocity(set, bodies, BodyId{static_cast<std::int32_t>(b)})
                   : Vec3{};
    }
    void operator()(solid::PlanarDdaFields& fields) const {
        for (std::size_t b = 0; b < fields.blocks.x.size(); ++b) {
            const Vec3& v = bodies.velocity[b];
            const std::array rates{v.x, v.y, spin(b).z, 0.0, 0.0, 0.0};
            std::copy(rates.begin(), rates.end(), fields.blocks.rates.begin() + static_cast<std::ptrdiff_t>(6 * b));
        }
    }
    void operator()(solid::affine::BlockState& blocks) const {
        for (std::size_t b = 0; b < blocks.velocity.size(); ++b) {
            blocks.velocity[b] = bodies.velocity[b];
            solid::affine::set_rows(blocks.velocity_gradient, b, solid::affine::cross_matrix(spin(b)));
        }
    }
    void operator()(solid::implicit_dda::State& fields) const { (*this)(fields.blocks); }
    void operator()(solid::explicit_dda::State& fields) const { (*this)(fields.blocks); }
    void operator()(auto& /*fields*/) const {}
};

/// Stops a free body, and makes one that is driven stand where its motion starts.
void stand_still(body::BodySet& bodies, body::BodyState& state, BodyId body) {
    const auto b = static_cast<std::size_t>(body.value);
    state.velocity[b] = {};
    state.angular_momentum[b] = {};
    if (bodies.drive[b] == body::Drive::driven) {
        const body::DrivenBody& driven = bodies.driven_bodies[static_cast<std::size_t>(bodies.driven[b])];
        const body::DrivenState start =
            evaluate(bodies.motions[static_cast<std::size_t>(driven.motion)], driven.start, 0);
        state.position[b] = start.pose.position;
        state.orientation[b] = start.pose.orientation;
        bodies.drive[b] = body::Drive::fixed;
        bodies.driven[b] = -1;
    }
    bodies.release_time[b] = std::numeric_limits<double>::infinity();
}

/// The case without water, which ends when bodies have settled.
scene::LoadedCase dry_case(const scene::LoadedCase& loaded) {
    scene::LoadedCase dry;
    dry.model = loaded.model;
    dry.state = loaded.state;
    dry.folder = loaded.folder;
    dry.model.fluid = {};
    dry.state.fluid_fields = {};
    dry.model.time.end = loaded.model.time.settle;
    dry.model.time.max_steps = -1;
    dry.model.time.settle = 0;
    dry.model.output.probes.clear();
    dry.model.output.gauges.clear();
    dry.model.output.faces.clear();
    dry.model.output.damage.clear();
    dry.model.expects.clear();
    std::erase_if(dry.model.loads, [](const body::PointLoad& load) { return load.start > 0; });
    dry.model.gravity = dry.model.gravity.held();
    dry.model.strength = dry.model.strength.held();
    for (body::PointLoad& load : dry.model.loads) {
        load.stop = std::numeric_limits<double>::infinity();  // it acts at time 0
    }
    for (std::int32_t b = 0; b < dry.model.bodies.size(); ++b) {
        stand_still(dry.model.bodies, dry.state.bodies, BodyId{b});
    }
    dry.model.bodies.driven_bodies.clear();
    std::visit(GiveVelocities{dry.model.bodies, dry.state.bodies}, dry.state.solid_fields);
    return dry;
}

}  // namespace

void settle(scene::LoadedCase& loaded, sim::State& state, const SettleWatch& watch) {
    scene::LoadedCase without_water = dry_case(loaded);
    change_method(without_water.model, without_water.state, settling_of(loaded));
    Simulation dry(std::move(without_water));
    while (dry.steps_left() > 0) {
        const StepOutcome outcome = dry.step(dry.next_is_last() ? sim::Measure::energy : sim::Measure::flow);
        if (outcome.kind == StepOutcome::Kind::refused) {
            Diagnostic problem;
            problem.place.file = loaded.folder;
            problem.message = fmt::format("bodies do not settle in {:.6g} s: {}", loaded.model.time.settle,
                                          outcome.why.with_remedy());
            problem.allowed = "bodies that start closer to rest, or settle = 0";
            throw CaseError(std::move(problem));
        }
        if (watch) {
            watch(dry.state().step, dry.steps_left() > 0 ? dry.state().time : dry.end(), dry.end());
        }
    }
    const double speed = dry.report().max_speed;
    if (speed > rest_speed) {
        loaded.warnings.push_back(fmt::format("after settling for {:.6g} s the fastest body moves at {:.3g} m/s",
                                              loaded.model.time.settle, speed));
    }
    state.bodies.position = dry.state().bodies.position;
    state.bodies.orientation = dry.state().bodies.orientation;
    state.bodies.stretch = dry.state().bodies.stretch;
    state.bodies.stretch_rate.assign(state.bodies.stretch.size(), {});
    state.contacts = dry.state().contacts;
    state.solid_fields = dry.state().solid_fields;
    std::visit(GiveVelocities{loaded.model.bodies, state.bodies}, state.solid_fields);
}

}  // namespace riprap::run
