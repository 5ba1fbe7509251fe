// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/advance.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "riprap/core/bytes.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/coupling/added_mass.hpp"
#include "riprap/sim/bound_methods.hpp"
#include "riprap/sim/cycle.hpp"
#include "riprap/sim/fluid_exchange.hpp"
#include "riprap/sim/ledger_table.hpp"
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

/// Most halvings of a refused piece: 2^10 = 1024 parts.
constexpr int most_cuts = 10;

/// Fields that a refused piece of the solids may have changed.
struct Kept {
    body::BodyState bodies;
    contact::ContactHistory contacts;
    SolidFields fields;
    double previous_dt;
};

Kept keep(const State& state) { return {state.bodies, state.contacts, state.solid_fields, state.previous_dt}; }

void take_back(Kept&& kept, State& state) {
    state.bodies = std::move(kept.bodies);
    state.contacts = std::move(kept.contacts);
    std::swap(state.solid_fields, kept.fields);
    state.previous_dt = kept.previous_dt;
}

/// Takes one piece into the report of the step.
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

/// Moves the solids over a piece; what is refused is taken back and cut finer where the method says that this helps.
Outcome advance_piece(Solid& solids, State& state, const TimeSpan& span, const body::LoadView& loads, Measure measure,
                      int cuts, const Accounts& accounts, StepReport& report) {
    std::optional<Kept> kept;
    if (solids.takes_back()) {
        kept = keep(state);
    }
    solid::SolidReport piece;
    Outcome outcome = solids.advance(span, loads, measure, piece);
    if (outcome.ok() || !kept || outcome.shorten <= 0 || cuts == most_cuts) {
        join(piece, accounts, state, report);
        return outcome;
    }
    take_back(std::move(*kept), state);
    const double half = 0.5 * span.dt;
    outcome = advance_piece(solids, state, {span.time, half}, loads, Measure::flow, cuts + 1, accounts, report);
    return outcome.ok()
               ? advance_piece(solids, state, {span.time + half, half}, loads, measure, cuts + 1, accounts, report)
               : outcome;
}

/// Most passes whose guess is Newton's, where a fluid offers that. Water that does not pull gives the loads kinks; a
/// body at one of them may go to and fro between its sides, which the iteration that remembers all passes does not.
constexpr int most_newton_passes = 8;

/// Finds the loads of the fluid with which bodies accelerate as they were taken to, from the guess of the last step on.
void settle_light_bodies(const Model& model, const State& state, Fluid& fluid, const TimeSpan& span, ScratchData& data,
                         StepReport& report) {
    Prediction& prediction = data.prediction;
    const auto count = at(model.bodies.size());
    const std::span<const double> feedback = fluid.feedback();
    std::vector<double> kappa(count, 0);
    for (std::size_t b = 0; b < feedback.size(); ++b) {
        kappa[b] = prediction.kinematics.inverse_mass[b] > 0 ? feedback[b] : 0;
    }
    const std::vector<double> inertia = mean_inertia(model.bodies);
    coupling::AddedMassIteration iteration(model.bodies.mass, inertia, kappa);
    std::vector<std::uint8_t> is_sought(count);
    for (std::size_t b = 0; b < count; ++b) {
        is_sought[b] = kappa[b] > coupling::AddedMassIteration::iterates_above ? 1 : 0;
    }
    std::vector<body::Acceleration> found(count), tried;
    for (bool is_settled = false; !is_settled;) {
        predict_middle(model, span, prediction);
        fluid.load(span, prediction.middle, data.fluid_loads);
        add_up(model.bodies, data.fluid_loads, data.span_loads);
        for (std::size_t b = 0; b < count; ++b) {
            found[b] = response(model.bodies, state.coupling, prediction.kinematics, data.span_loads, b);
        }
        tried = prediction.guess;
        is_settled = iteration.accept(prediction.guess, found, norm(model.gravity.value));
        if (!fluid.corrects() || is_settled || iteration.passes() > most_newton_passes) {
            continue;
        }
        for (std::size_t b = 0; b < count; ++b) {
            found[b] = {found[b].linear - tried[b].linear, found[b].angular - tried[b].angular};
        }
        if (fluid.correct(model.bodies, prediction.kinematics, is_sought, found, tried)) {
            prediction.guess = tried;
        }
    }
    report.water_passes = std::max<std::int64_t>(report.water_passes, iteration.passes());
    report.water_residual = std::max(report.water_residual, iteration.residual());
    report.is_water_settled = report.is_water_settled && iteration.is_settled();
}

bool has_free_bodies(const body::BodyKinematics& kinematics) {
    return std::any_of(kinematics.inverse_mass.begin(), kinematics.inverse_mass.end(), [](double w) { return w > 0; });
}

/// Moves the solids over a piece without a report; what is refused is cut finer, as in advance_piece.
bool try_piece(Solid& solids, State& state, const TimeSpan& span, const body::LoadView& loads, int cuts) {
    std::optional<Kept> kept;
    if (solids.takes_back()) {
        kept = keep(state);
    }
    solid::SolidReport unread;
    const Outcome outcome = solids.advance(span, loads, Measure::flow, unread);
    if (outcome.ok() || !kept || outcome.shorten <= 0 || cuts == most_cuts) {
        return outcome.ok();
    }
    take_back(std::move(*kept), state);
    const double half = 0.5 * span.dt;
    return try_piece(solids, state, {span.time, half}, loads, cuts + 1) &&
           try_piece(solids, state, {span.time + half, half}, loads, cuts + 1);
}

/// Moves the solids over the step on trial, with the loads found, and takes them back. Tells whether they went another
/// way than the fluid was told; then the accelerations that it is told next lead there.
bool foresee_contacts(const Model& model, State& state, Solid& solids, Fluid& fluid, const Cycle& cycle,
                      ScratchData& data) {
    Kept kept = keep(state);
    bool is_ok = true;
    for (std::int64_t k = 0; k < cycle.pieces && is_ok; ++k) {
        is_ok = try_piece(solids, state, cycle.piece(k), data.span_loads, 0);
    }
    const body::BodyState after = std::move(state.bodies);
    take_back(std::move(kept), state);
    return is_ok && go_another_way(model, state.bodies, after, cycle.dt, data.span_loads, fluid.feedback(),
                                   data.prediction, state.coupling);
}

/// Most trials of the solids in a step.
constexpr int most_trials = 16;

/// The fluid from the beginning of a span to its loads and its kick.
Outcome flow(const Model& model, State& state, Fluid& fluid, Solid& solids, const Cycle& cycle, const TimeSpan& span,
             ScratchData& data, FluidSpan& brought, StepReport& report) {
    Prediction& prediction = data.prediction;
    const double since = span.time - state.time;
    fluid.drive(span, prediction.correction);
    predict(model, state, span, since, prediction);
    Outcome outcome = fluid.begin(span, prediction.now, prediction.middle, brought.step);
    if (!outcome.ok()) {
        return outcome;
    }
    settle_light_bodies(model, state, fluid, span, data, report);
    if (fluid.corrects() && cycle.spans == 1 &&
        has_free_bodies(prediction.kinematics)) {  // water that cannot give way: its loads follow the way of bodies
        int trial = 0;
        for (; trial < most_trials && foresee_contacts(model, state, solids, fluid, cycle, data); ++trial) {
            settle_light_bodies(model, state, fluid, span, data, report);
        }
        report.is_water_settled = report.is_water_settled && trial < most_trials;
    }
    outcome = fluid.kick(span, brought.step);
    brought.work_on_free = work_on_free(prediction, data.span_loads, span.dt);
    note_way(span.dt, prediction, state.coupling);
    note_gain(model, state, data.span_loads, span.dt, prediction);
    report.through_walls.add(brought.step.through_walls);
    if (report.intruder.empty()) {
        report.intruder = brought.step.intruder;
    }
    report.solver_iterations += brought.step.fluid.solver_iterations;
    report.solver_residual = std::max(report.solver_residual, brought.step.fluid.solver_residual);
    report.max_water_speed = std::max(report.max_water_speed, brought.step.fluid.max_speed);
    return outcome;
}

/// The spans of the fluid, to the loads that the solids feel over the step. The last span is not ended yet.
Outcome flow_over(const Model& model, State& state, Fluid& fluid, Solid& solids, const Cycle& cycle, ScratchData& data,
                  std::vector<FluidSpan>& spans, StepReport& report) {
    const ScopedTimer timer(data.times.water);
    fluid.tidy(state.step);
    data.loads.clear(at(model.bodies.size()), state.bodies.deforms());
    data.prediction.guess = last_accelerations(state.coupling);
    data.prediction.gained.assign(at(model.bodies.size()), {});
    data.prediction.moved.assign(at(model.bodies.size()), {});
    begin_ways(model, state, cycle.dt, data.prediction);
    for (std::int64_t k = 0; k < cycle.spans; ++k) {
        Outcome outcome = flow(model, state, fluid, solids, cycle, cycle.span(k), data, spans.emplace_back(), report);
        if (!outcome.ok()) {
            return outcome;
        }
        add_share(data.span_loads, cycle.spans, data.loads);
        if (k + 1 < cycle.spans) {
            outcome = fluid.end(cycle.span(k), spans.back().step);
            if (!outcome.ok()) {
                return outcome;
            }
        }
    }
    return {};
}

/// Books what both sides exchanged, and ends the last span of the fluid.
Outcome end_flow(const Model& model, State& state, Fluid& fluid, const Cycle& cycle, ScratchData& data,
                 std::vector<FluidSpan>& spans, StepReport& report) {
    const ScopedTimer timer(data.times.water);
    const WorkDone work = work_done(data.before, state.bodies, data.prediction.kinematics, data.loads);
    note_missed_way(data.before, data.prediction, state);
    note_accelerations(model, data.before, data.prediction.kinematics, data.loads, cycle.dt, state);
    if (cycle.pieces > 1) {
        forget_impacts(model, data.prediction.kinematics, contact_loads(data), cycle.dt, state);
    }
    const Accounts accounts = accounts_of(model);
    const Outcome outcome = fluid.end(cycle.span(cycle.spans - 1), spans.back().step);
    if (!fluid.leads()) {
        // Such a fluid does not move by itself: its work is what the bodies say, whatever was predicted of them.
        for (FluidSpan& span : spans) {
            span.work_on_free = work.all() / static_cast<double>(spans.size());
        }
    } else if (const std::ptrdiff_t rest = rest_account(accounts); rest >= 0 && !fluid.feedback().empty()) {
        book_true_way(work.all(), static_cast<std::size_t>(rest), spans);
    } else if (const std::ptrdiff_t straining = fluid_account(accounts, straining_name); straining >= 0) {
        book_straining(work.strain, static_cast<std::size_t>(straining), spans);
    }
    book_fluid(spans, work.all(), accounts, state.ledger, report.ledger);
    return outcome;
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
        report.status = status_of(advance_piece(solids, state, cycle.piece(k), loads, of_piece, 0, accounts, report));
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
