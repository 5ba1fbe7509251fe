// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/settle.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>
#include <vector>

#include "riprap/run/simulation.hpp"

namespace riprap::run {

namespace {

/// Bodies slower than this are at rest [m/s].
constexpr double rest_speed = 0.01;

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
    for (std::int32_t b = 0; b < dry.model.bodies.size(); ++b) {
        stand_still(dry.model.bodies, dry.state.bodies, BodyId{b});
    }
    dry.model.bodies.driven_bodies.clear();
    return dry;
}

}  // namespace

void settle(scene::LoadedCase& loaded, sim::State& state) {
    Simulation dry(dry_case(loaded));
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
}

}  // namespace riprap::run
