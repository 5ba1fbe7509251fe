// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/advance.hpp"

#include <algorithm>
#include <utility>

#include "riprap/core/bytes.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/index.hpp"
#include "riprap/sim/bound_methods.hpp"
#include "riprap/sim/flow.hpp"
#include "riprap/sim/fluid_exchange.hpp"
#include "riprap/sim/gauge_reading.hpp"
#include "riprap/sim/ledger_table.hpp"
#include "riprap/sim/method_traits.hpp"
#include "riprap/sim/pieces.hpp"
#include "riprap/sim/prediction.hpp"
#include "riprap/sim/step_context.hpp"

namespace riprap::sim {

namespace {

/// Adds to a sum whose rounding errors are kept in `rest` and made good (Kahan): after any number of steps the time
/// is that of the exact sum to a unit in the last place.
void add_compensated(double& sum, double& rest, double term) {
    const double corrected = term - rest;
    const double next = sum + corrected;
    rest = (next - sum) - corrected;
    sum = next;
}

/// Adds the report of one piece of motion to that of the step.
void join(const solid::SolidReport& piece, StepContext& step) {
    StepReport& all = step.report;
    all.ledger = account(piece, step.accounts, step.state.ledger);
    all.dt_bound = std::min(all.dt_bound, static_cast<double>(step.cycle.pieces) * piece.dt_bound);
    all.max_speed = std::max(all.max_speed, piece.kick.max_speed);
    all.max_potential = std::max(all.max_potential, piece.max_potential);
    all.max_depth = std::max(all.max_depth, piece.max_depth);
    all.contact_count = piece.contact_count;
    all.open_frictions += piece.open_frictions;
    all.pair_count = piece.pair_count;
    all.pairs_rebuilt = all.pairs_rebuilt || piece.pairs_rebuilt;
}

/// Moves the solids over a piece under the loads of the step.
Outcome move(StepContext& step, std::int64_t k) {
    const bool is_last = k + 1 == step.cycle.pieces;
    const auto take = [&step](const solid::SolidReport& piece) { join(piece, step); };
    return move_over(step, {step.cycle.piece(k), step.loads, is_last ? step.measure : Measure::flow}, take);
}

/// One step: the fluid goes first, to the loads that it puts on bodies where they will be; the bodies follow under
/// those loads, in pieces; then the fluid ends its step, and what both sides exchanged is booked.
Outcome take_step(StepContext& step) {
    Outcome outcome = begin_flow(step);
    for (std::int64_t k = 0; k < step.cycle.spans && outcome.ok(); ++k) {
        predict(step, step.cycle.span(k));
        outcome = flow(step, k);
    }
    for (std::int64_t k = 0; k < step.cycle.pieces && outcome.ok(); ++k) {
        outcome = move(step, k);
    }
    return outcome.ok() ? book(step) : outcome;
}

}  // namespace

Scratch::Scratch() : data_(std::make_unique<ScratchData>()) {}
Scratch::~Scratch() = default;
Scratch::Scratch(Scratch&&) noexcept = default;
Scratch& Scratch::operator=(Scratch&&) noexcept = default;

const body::Loads& Scratch::contact_loads() const { return sim::contact_loads(*data_); }
const std::vector<Vec3>& Scratch::contact_force() const { return contact_loads().force; }
const std::vector<Vec3>& Scratch::contact_torque() const { return contact_loads().torque; }
const coupling::FluidLoads& Scratch::fluid_loads() const { return data_->fluid_loads; }

void Scratch::forget() {
    const StageTimes times = stage_times(*this);
    data_ = std::make_unique<ScratchData>();
    data_->times = times;
}

StageTimes stage_times(const Scratch& scratch) {
    StageTimes times = scratch.data().times;
    const solid::SolidTimes& of_solids = solid_times(scratch.data());
    times.find_pairs += of_solids.find_pairs;
    times.find_contacts += of_solids.find_contacts;
    times.contact_loads += of_solids.contact_loads;
    times.move_bodies += of_solids.move_bodies;
    times.measure += of_solids.measure;
    return times;
}

StepReport advance(const Model& model, State& state, Scratch& scratch, double dt, Measure measure,
                   const body::LoadView& loads) {
    RIPRAP_ASSERT(!model.has_fluid() || loads.empty(), "a fluid brings its own loads");
    BoundMethods bound(model, state, scratch.data());
    StepContext step = begin_step(model, state, scratch.data(), bound, dt, measure, loads);
    Outcome outcome = take_step(step);
    step.report.status = {std::move(outcome.problem), std::move(outcome.remedy)};
    add_compensated(state.time, state.time_rest, dt);
    state.step += 1;
    if (step.report.status.ok()) {
        follow(model, state, scratch, dt);
        accept_step(state.stepping);
    }
    return std::move(step.report);
}

void initialise(const Model& model, State& state) {
    reset(accounts_of(model), state.ledger);
    reset(model, state.coupling);
    ScratchData unused;
    BoundMethods(model, state, unused).fluid().start();  // makes the fields of the methods
    for (std::int32_t i = 0; i < model.bodies.size(); ++i) {
        if (model.bodies.drive[at(i)] != body::Drive::driven) {
            continue;
        }
        const body::DrivenState driven = driven_state(model.bodies, BodyId{i}, state.time);
        state.bodies.position[at(i)] = driven.pose.position;
        state.bodies.orientation[at(i)] = driven.pose.orientation;
        state.bodies.velocity[at(i)] = driven.velocity;
        state.bodies.angular_momentum[at(i)] =
            angular_momentum_of(model.bodies, BodyId{i}, driven.pose.orientation, driven.angular_velocity);
    }
}

std::size_t memory_bytes(const Model& model, const State& state, const Scratch& scratch) {
    const ScratchData& data = scratch.data();
    const body::BodySet& bodies = model.bodies;
    std::size_t bytes = model.shapes.bytes();
    const auto add = [&bytes](std::string_view, const auto& field) {
        if constexpr (is_field_array<std::remove_cvref_t<decltype(field)>>) {
            bytes += bytes_of(field);
        }
    };
    State::visit_fields(state, add);
    body::BodyState::visit_fields(data.before, add);
    body::BodyState::visit_fields(data.prediction.bodies, add);
    bytes +=
        bytes_of(bodies.name_id, bodies.name_index, bodies.material, bodies.drive, bodies.mass) +
        bytes_of(bodies.principal_moments, bodies.principal_axes, bodies.driven, bodies.locks, bodies.release_time) +
        bytes_of(bodies.part_begin, bodies.parts, bodies.driven_bodies);
    bytes += fluid_bytes(model) + method_bytes(data);
    const Prediction& prediction = data.prediction;
    return bytes + data.fluid_loads.bytes() + data.span_loads.bytes() + data.loads.bytes() + prediction.now.bytes() +
           prediction.middle.bytes() +
           bytes_of(prediction.guess, prediction.gained, prediction.moved, prediction.catch_up, prediction.way,
                    prediction.told, prediction.correction) +
           bytes_of(prediction.kinematics.angular_velocity, prediction.kinematics.inverse_inertia,
                    prediction.kinematics.inverse_mass);
}

}  // namespace riprap::sim
