// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/trial.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/coupling/added_mass.hpp"
#include "riprap/sim/pieces.hpp"
#include "riprap/sim/prediction.hpp"

namespace riprap::sim {

namespace {

/// Share of the acceleration of a body and of gravity by which its way may differ from the one that the fluid was told
/// [-].
constexpr double other_way = 0.001;

/// Most trials of the solids in a step.
constexpr int most_trials = 16;

/// Seconds that the solid method spent so far.
double seconds_of_solids(const ScratchData& data) {
    const solid::SolidTimes& times = solid_times(data);
    return times.find_pairs + times.find_contacts + times.contact_loads + times.move_bodies + times.measure;
}

}  // namespace

bool go_another_way(StepContext& step, const body::BodyState& after, std::span<const double> feedback) {
    const Model& model = step.model;
    const body::BodyState& before = step.state.bodies;
    Prediction& prediction = step.scratch.prediction;
    coupling::CouplingState& coupling = step.state.coupling;
    const double dt = step.cycle.dt;
    const std::vector<double> inertia = mean_inertia(model.bodies);
    const double per_way = 2 / (dt * dt), gravity = norm(model.gravity.value);
    bool is_other = false;
    for (std::size_t b = 0; b < prediction.guess.size(); ++b) {
        if (!(prediction.kinematics.inverse_mass[b] > 0)) {
            continue;
        }
        const body::Acceleration caught = prediction.catch_up.empty() ? body::Acceleration{} : prediction.catch_up[b];
        const body::Motion& seen = prediction.middle;
        const Vec3 way = after.position[b] - before.position[b] - dt * (seen.velocity[b] - caught.linear);
        const Vec3 turn = turn_between(before, after, b) - dt * (seen.angular_velocity[b] - caught.angular);
        const Vec3 more = per_way * way, faster = per_way * turn;
        body::Acceleration& guess = prediction.guess[b];
        const double arm = std::sqrt(inertia[b] / model.bodies.mass[b]);
        const body::Acceleration foreseen = response(step, b);
        const Vec3 pushed = more - (foreseen.linear - guess.linear),
                   turned = faster - (foreseen.angular - guess.angular);
        // The accelerations of bodies that are sought with their loads are not exact yet: what contacts add counts.
        const bool is_sought = b < feedback.size() && feedback[b] > coupling::AddedMassIteration::iterates_above;
        const double size = is_sought ? norm(pushed) + arm * norm(turned) : norm(more) + arm * norm(faster);
        is_other = is_other || size > other_way * (norm(guess.linear) + arm * norm(guess.angular) + gravity);
        coupling.dry_acceleration[b] += pushed;
        coupling.dry_angular_acceleration[b] += turned;
        guess = {guess.linear + more, guess.angular + faster};
    }
    return is_other;
}

bool foresee_contacts(StepContext& step) {
    ScratchData& scratch = step.scratch;
    const double seconds = seconds_of_solids(scratch);
    Kept kept = keep(step.state);
    bool is_ok = true;
    for (std::int64_t k = 0; k < step.cycle.pieces && is_ok; ++k) {
        const auto unread = [](const solid::SolidReport&) {};
        is_ok = move_over(step, {step.cycle.piece(k), scratch.span_loads, Measure::flow}, unread).ok();
    }
    const body::BodyState after = std::move(step.state.bodies);
    take_back(std::move(kept), step.state);
    scratch.times.fluid -= seconds_of_solids(scratch) - seconds;
    return is_ok && go_another_way(step, after, step.fluid.feedback());
}

bool settle_ways(const std::function<bool()>& goes_another_way, const std::function<void()>& find_loads) {
    for (int trial = 0; trial < most_trials; ++trial) {
        if (!goes_another_way()) {
            return true;
        }
        find_loads();
    }
    return false;
}

}  // namespace riprap::sim
