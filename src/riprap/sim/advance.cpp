// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/advance.hpp"

#include <algorithm>
#include <limits>

#include "riprap/core/bytes.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/index.hpp"
#include "riprap/sim/bound_methods.hpp"
#include "riprap/sim/cycle.hpp"
#include "riprap/sim/flow.hpp"
#include "riprap/sim/ledger_table.hpp"
#include "riprap/sim/pieces.hpp"
#include "riprap/sim/scratch_data.hpp"

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
void join(const solid::SolidReport& piece, const Accounts& accounts, State& state, StepReport& all) {
    all.ledger = account(piece, accounts, state.ledger);
    all.dt_bound = std::min(all.dt_bound, piece.dt_bound);
    all.max_speed = std::max(all.max_speed, piece.kick.max_speed);
    all.max_potential = std::max(all.max_potential, piece.max_potential);
    all.max_depth = std::max(all.max_depth, piece.max_depth);
    all.contact_count = piece.contact_count;
    all.open_frictions += piece.open_frictions;
    all.pair_count = piece.pair_count;
    all.pairs_rebuilt = all.pairs_rebuilt || piece.pairs_rebuilt;
}

StepStatus status_of(Outcome outcome) { return {std::move(outcome.problem), std::move(outcome.remedy)}; }

/// One step with these methods.
StepReport take_step(const Model& model, State& state, ScratchData& data, Solid& solids, Fluid& fluid, double dt,
                     Measure measure, const body::LoadView& given) {
    StepReport report;
    report.dt = dt;
    report.dt_bound = std::numeric_limits<double>::infinity();
    const StepLimit of_solids = solids.limit();
    StepLimit of_fluid;
    if (fluid.leads() && (of_solids.is_wanted || !model.time.is_automatic())) {
        of_fluid = fluid.limit();
    }
    const Accounts accounts = accounts_of(model);
    const Cycle cycle = make_cycle(model, state, of_solids, of_fluid, fluid.leads(), dt);
    body::LoadView loads = given;
    std::vector<FluidSpan> spans;
    if (fluid.is_there()) {
        report.water_dt_bound = model.time.is_automatic() ? report.water_dt_bound : of_fluid.longest;
        report.status.text = fixed_step_problem(model, state, of_fluid);
        if (report.status.ok()) {
            report.status = status_of(flow_over(model, state, fluid, solids, cycle, data, spans, report));
        }
        data.before = state.bodies;
        loads = data.loads;
    }
    for (std::int64_t k = 0; k < cycle.pieces && report.status.ok(); ++k) {
        const Measure of_piece = k + 1 == cycle.pieces ? measure : Measure::flow;
        const auto take = [&](const solid::SolidReport& piece) { join(piece, accounts, state, report); };
        report.status = status_of(move_over(solids, state, cycle.piece(k), loads, of_piece, take));
    }
    if (fluid.is_there()) {
        if (report.status.ok()) {
            report.status = status_of(end_flow(model, state, fluid, cycle, data, spans, report));
        }
    }
    report.dt_bound *= static_cast<double>(cycle.pieces);
    report.substeps = cycle.pieces;
    return report;
}

}  // namespace

Scratch::Scratch() : data_(std::make_unique<ScratchData>()) {}
Scratch::~Scratch() = default;
Scratch::Scratch(Scratch&&) noexcept = default;
Scratch& Scratch::operator=(Scratch&&) noexcept = default;

const body::Loads& Scratch::contact_loads() const { return sim::contact_loads(*data_); }
const std::vector<Vec3>& Scratch::contact_force() const { return contact_loads().force; }
const std::vector<Vec3>& Scratch::contact_torque() const { return contact_loads().torque; }
const coupling::FluidLoads& Scratch::water_loads() const { return data_->fluid_loads; }

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
    const BoundMethods bound = bind_methods(model, state, scratch.data());
    StepReport report = take_step(model, state, scratch.data(), *bound.solid, *bound.fluid, dt, measure, loads);
    add_compensated(state.time, state.time_rest, dt);
    state.step += 1;
    if (report.status.ok()) {
        accept_step(state.stepping);
    }
    return report;
}

void initialise(const Model& model, State& state) {
    reset(accounts_of(model), state.ledger);
    reset(model, state.coupling);
    ScratchData unused;
    bind_methods(model, state, unused).fluid->start();  // makes the fields of the methods
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
    std::visit(
        [&bytes](const auto& settings) {
            if constexpr (requires { settings.bytes(); }) {
                bytes += settings.bytes();
            }
        },
        model.fluid);
    bytes += method_bytes(data);
    const Prediction& prediction = data.prediction;
    return bytes + data.fluid_loads.bytes() + data.span_loads.bytes() + data.loads.bytes() + prediction.now.bytes() +
           prediction.middle.bytes() +
           bytes_of(prediction.guess, prediction.gained, prediction.moved, prediction.catch_up, prediction.way,
                    prediction.told, prediction.correction) +
           bytes_of(prediction.kinematics.angular_velocity, prediction.kinematics.inverse_inertia,
                    prediction.kinematics.inverse_mass);
}

}  // namespace riprap::sim
