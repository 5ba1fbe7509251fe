// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/advance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "riprap/contact/distance_potential_physics.hpp"
#include "riprap/core/bytes.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/fluid/particle/sort.hpp"
#include "riprap/sim/ledger_account.hpp"
#include "riprap/sim/scratch_data.hpp"
#include "riprap/solid/explicit_dem.hpp"

namespace riprap::sim {

Scratch::Scratch() : data_(std::make_unique<ScratchData>()) {}
Scratch::~Scratch() = default;
Scratch::Scratch(Scratch&&) noexcept = default;
Scratch& Scratch::operator=(Scratch&&) noexcept = default;
contact::ContactRows Scratch::contacts() const { return data_->pipeline.rows(); }
const std::vector<Vec3>& Scratch::contact_force() const { return data_->loads.force; }
const std::vector<Vec3>& Scratch::contact_torque() const { return data_->loads.torque; }

const coupling::FluidLoads& Scratch::water_loads() const { return data_->water.loads; }

void Scratch::forget() {
    const StageTimes times = data_->times;
    data_ = std::make_unique<ScratchData>();
    data_->times = times;
}

StageTimes stage_times(const Scratch& scratch) { return scratch.data().times; }

namespace {

contact::ContactScene contact_scene(const Model& model) {
    return {model.shapes, model.materials, model.bodies, model.solid.grid_factor, model.solid.skin};
}

/// What happens between two parts: the one place that chooses it.
contact::DistancePotentialPhysics pair_physics(const Model& model, bool with_energy) {
    contact::DistancePotentialPhysics physics{model.solid.contact};
    physics.options.with_energy = with_energy;
    return physics;
}

/// Adds to a sum whose rounding errors are kept in `rest` and made good (Kahan): after any number of steps the time
/// is that of the exact sum to a unit in the last place.
void add_compensated(double& sum, double& rest, double term) {
    const double corrected = term - rest;
    const double next = sum + corrected;
    rest = (next - sum) - corrected;
    sum = next;
}

/// Sums and extremes over the contacts of one step, in fixed blocks of their order.
struct ContactSums {
    double elastic{0}, shear{0}, friction_loss{0};
    float potential{0}, overlap{0};
    std::int64_t deepest{-1};
};

ContactSums sum_contacts(const contact::ContactRows& rows, const contact::ContactHistory& history) {
    return parallel::reduce(
        static_cast<std::int64_t>(rows.size()), ContactSums{},
        [&](std::int64_t i) {
            const contact::ContactRow& row = rows[at(i)];
            return ContactSums{
                row.elastic_energy, history.shear_energy[at(i)], row.friction_loss, row.potential, row.overlap, i};
        },
        [](ContactSums a, const ContactSums& b) {
            a.elastic += b.elastic;
            a.shear += b.shear;
            a.friction_loss += b.friction_loss;
            a.overlap = std::max(a.overlap, b.overlap);
            // A potential that is not a number counts as the deepest and stays so.
            if (b.deepest >= 0 && (a.deepest < 0 || (!std::isnan(a.potential) && !(b.potential <= a.potential)))) {
                a.potential = b.potential;
                a.deepest = b.deepest;
            }
            return a;
        });
}

/// Names what makes the step unacceptable, if anything does.
StepStatus judge(const Model& model, const State& state, const solid::KickReport& kick, const ContactSums& contacts,
                 const contact::ContactRows& rows, double time) {
    const body::BodySet& bodies = model.bodies;
    if (kick.worst_body >= 0) {
        const BodyId body{static_cast<std::int32_t>(kick.worst_body)};
        const Vec3& v = state.bodies.velocity[at(kick.worst_body)];
        const Vec3& x = state.bodies.position[at(kick.worst_body)];
        return {fmt::format(
            "velocity of {} is ({:.6g}, {:.6g}, {:.6g}) m/s, its spin {:.6g} rad/s, at ({:.6g}, {:.6g}, {:.6g}) m, "
            "t = {:.9g} s; allowed: finite, sqrt(2 K/m) at most {:.6g} m/s",
            bodies.name(body), v.x, v.y, v.z, norm(angular_velocity(bodies, state.bodies, body)), x.x, x.y, x.z, time,
            model.solid.max_speed)};
    }
    if (contacts.deepest >= 0 && !(contacts.potential <= model.solid.max_potential)) {
        const contact::ContactRow& row = rows[at(contacts.deepest)];
        const auto name = [&](std::int32_t part) { return bodies.name(bodies.parts[at(part)].body); };
        return {
            fmt::format("overlap of {} and {} reaches {:.4g} of an inscribed radius at ({:.6g}, {:.6g}, {:.6g}) m, "
                        "t = {:.9g} s; allowed: {:.4g}",
                        name(row.parts.a), name(row.parts.b), contacts.potential, row.point.x, row.point.y, row.point.z,
                        time, model.solid.max_potential)};
    }
    return {};
}

/// One step of the solids from `time`.
StepReport advance_solids(const Model& model, State& state, ScratchData& data, double time, double dt, bool is_first,
                          Measure measure, const body::LoadView& loads) {
    contact::ContactPipeline& contacts = data.pipeline;
    const bool with_energy = measure == Measure::energy || is_first;
    const contact::ContactScene scene = contact_scene(model);
    const double kick_time = time + 0.5 * dt;
    const double sliding_time = 0.5 * (state.previous_dt + dt);
    const double previous_kick = !is_first ? kick_time - sliding_time : -std::numeric_limits<double>::infinity();
    StepReport report;
    double lost_springs = 0;
    {
        const ScopedTimer timer(data.times.move_bodies);
        solid::drift(model.bodies, state.bodies, kick_time, 0.5 * dt);
        body::update_kinematics(model.bodies, state.bodies, kick_time, data.kinematics);
    }
    {
        const ScopedTimer timer(data.times.find_pairs);
        contacts.place_parts(scene, state.bodies);
        report.pairs_rebuilt = contacts.find_pairs();
    }
    {
        const ScopedTimer timer(data.times.find_contacts);
        lost_springs = contacts.find_contacts(pair_physics(model, with_energy), scene, state.bodies, data.kinematics,
                                              sliding_time, state.contacts);
    }
    {
        const ScopedTimer timer(data.times.contact_loads);
        contacts.gather_loads(scene, state.bodies, data.loads);
    }
    const Vec3 gravity = model.gravity.at(kick_time);
    solid::KickReport kick;
    double dashpot_loss = 0;
    {
        const ScopedTimer timer(data.times.move_bodies);
        kick = solid::kick(model.bodies, model.solid, data.kinematics, data.loads,
                           data.point_loads.add(model.loads, state.bodies, kick_time, loads), gravity,
                           {kick_time, previous_kick, dt}, state.bodies);
        dashpot_loss = contacts.dashpot_loss(scene, state.bodies, data.kinematics, dt);
        solid::drift(model.bodies, state.bodies, time + dt, 0.5 * dt);
    }
    const ScopedTimer timer(data.times.measure);
    const ContactSums sums = sum_contacts(contacts.rows(), state.contacts);
    report.ledger = account({.kick = kick,
                             .kick_time = kick_time,
                             .gravity = gravity,
                             .elastic = with_energy ? sums.elastic : 0,
                             .has_elastic = with_energy,
                             .shear = sums.shear,
                             .friction_loss = sums.friction_loss + lost_springs,
                             .damping_loss = dashpot_loss},
                            state.ledger);
    state.previous_dt = dt;

    report.dt = dt;
    report.dt_bound = contacts.stable_step(scene);
    report.max_speed = kick.max_speed;
    report.max_potential = sums.potential;
    report.max_depth = sums.overlap;
    report.contact_count = static_cast<std::int64_t>(contacts.rows().size());
    report.pair_count = contacts.pair_count();
    report.status = judge(model, state, kick, sums, contacts.rows(), kick_time);
    return report;
}

/// What several steps of the solids report together.
void join(StepReport& all, const StepReport& step) {
    const StepReport before = all;
    all = step;
    all.dt_bound = std::min(before.dt_bound, step.dt_bound);
    all.max_speed = std::max(before.max_speed, step.max_speed);
    all.max_potential = std::max(before.max_potential, step.max_potential);
    all.max_depth = std::max(before.max_depth, step.max_depth);
    all.pairs_rebuilt = before.pairs_rebuilt || step.pairs_rebuilt;
}

/// One step of the water with the solids within it.
StepReport advance_with_water(const Model& model, State& state, ScratchData& data, double dt, Measure measure) {
    StepReport report;
    WaterReport water;
    const double dt_bound = model.time.is_automatic() ? std::numeric_limits<double>::infinity()
                                                      : choose_fluid_time_step(model.fluid->sph, state.fluid).limit;
    report.status.text = fixed_step_problem(model, state);
    if (!report.status.ok()) {
        return report;
    }
    {
        const ScopedTimer timer(data.times.water);
        if (state.step % model.fluid->sph.sort_interval == 0) {
            sort_by_place(state.fluid, model.fluid->sph.domain, model.fluid->sph.spacing);
        }
        water = kick_water(model, state, data.water, dt);
        report.status.text = water.fluid.problem;
        if (!report.status.ok()) {
            return report;
        }
    }
    data.before = state.bodies;
    const std::int64_t count = solid_substeps(model, state, data, dt);
    const double solid_dt = dt / static_cast<double>(count);
    const bool is_first = state.step == 0;
    for (std::int64_t k = 0; k < count; ++k) {
        const double time = state.time + solid_dt * static_cast<double>(k);
        const bool is_last = k + 1 == count;
        const StepReport step =
            advance_solids(model, state, data, time, solid_dt, is_first && k == 0, is_last ? measure : Measure::flow,
                           {data.water.force, data.water.torque});
        if (k == 0) {
            report = step;
        } else {
            join(report, step);
        }
        if (!report.status.ok()) {
            return report;
        }
    }
    const ScopedTimer timer(data.times.water);
    const double work_given = work_done(model, data.before, state, data.water);
    note_accelerations(model, data.before, state, data.water, dt);
    const fluid::Passage passage = end_water_step(model, state, water.fluid, data.water, dt);
    report.status.text = passage.problem;
    account_water({water.fluid, water.absorbed, water.flow_work, water.work_on_free, work_given}, state.ledger,
                  report.ledger);
    account_passage(passage, state.ledger);
    report.dt = dt;
    report.dt_bound *= static_cast<double>(count);
    report.substeps = count;
    report.water_passes = water.passes;
    report.water_residual = water.residual;
    report.is_water_settled = water.is_settled;
    report.max_water_speed = water.fluid.max_speed;
    report.water_dt_bound = dt_bound;
    report.intruder = std::move(water.intruder);
    return report;
}

}  // namespace

StepReport advance(const Model& model, State& state, Scratch& scratch, double dt, Measure measure,
                   const body::LoadView& loads) {
    ScratchData& data = scratch.data();
    RIPRAP_ASSERT(!model.fluid || loads.force.empty(), "water brings its own loads");
    const StepReport report = model.fluid
                                  ? advance_with_water(model, state, data, dt, measure)
                                  : advance_solids(model, state, data, state.time, dt, state.step == 0, measure, loads);
    add_compensated(state.time, state.time_rest, dt);
    state.step += 1;
    if (report.status.ok()) {
        accept_step(state.stepping);
    }
    return report;
}

void initialise(const Model& model, State& state) {
    reset(state.ledger);
    reset(model, state.coupling);
    if (model.fluid) {
        start_openings(model.fluid->open, model.fluid->sph, state.fluid, state.open);
    }
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
    std::size_t bytes = model.shapes.bytes() + data.pipeline.bytes();
    const auto add = [&bytes](std::string_view, const auto& field) {
        if constexpr (is_field_array<std::remove_cvref_t<decltype(field)>>) {
            bytes += bytes_of(field);
        }
    };
    State::visit_fields(state, add);
    body::BodyState::visit_fields(data.before, add);
    bytes += bytes_of(bodies.name_id, bodies.name_index, bodies.material, bodies.drive, bodies.mass) +
             bytes_of(bodies.principal_moments, bodies.principal_axes, bodies.driven, bodies.release_time) +
             bytes_of(bodies.part_begin, bodies.parts, bodies.driven_bodies);
    if (model.fluid) {
        bytes += model.fluid->samples.bytes() + data.water.bytes();
    }
    return bytes + bytes_of(data.loads.force, data.loads.torque, data.kinematics.angular_velocity) +
           bytes_of(data.kinematics.inverse_inertia, data.kinematics.inverse_mass);
}

}  // namespace riprap::sim
