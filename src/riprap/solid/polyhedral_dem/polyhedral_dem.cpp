// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/polyhedral_dem/polyhedral_dem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/contact/common_plane_physics.hpp"
#include "riprap/contact/count_pairs.hpp"
#include "riprap/contact/distance_potential_physics.hpp"
#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/solid/polyhedral_dem/contact_sums.hpp"

namespace riprap::solid {

namespace {

/// Names what makes the step unacceptable, if anything does.
Outcome judge(const body::BodySet& bodies, const DemSettings& settings, const body::BodyState& state,
              const KickReport& kick, const PolyhedralSums& contacts, const contact::ContactRows& rows, double time) {
    if (kick.worst_body >= 0) {
        const BodyId body{static_cast<std::int32_t>(kick.worst_body)};
        const Vec3& v = state.velocity[at(kick.worst_body)];
        const Vec3& x = state.position[at(kick.worst_body)];
        return {fmt::format(
            "velocity of {} is ({:.6g}, {:.6g}, {:.6g}) m/s, its spin {:.6g} rad/s, at ({:.6g}, {:.6g}, {:.6g}) m, "
            "t = {:.9g} s; allowed: finite, sqrt(2 K/m) at most {:.6g} m/s",
            bodies.name(body), v.x, v.y, v.z, norm(angular_velocity(bodies, state, body)), x.x, x.y, x.z, time,
            settings.max_speed)};
    }
    return judge_overlap(bodies, settings.max_potential, contacts, rows, time);
}

/// Finds contacts by the physics of the settings. @returns the friction loss of springs that were lost [J]
double find_contacts(const contact::ContactScene& scene, const DemSettings& settings, const SolidState& state,
                     double sliding_time, bool with_energy, PolyhedralDem::Scratch& scratch) {
    const auto find = [&](const auto& physics) {
        return scratch.pipeline.find_contacts(physics, scene, state.bodies, scratch.kinematics, sliding_time,
                                              state.contacts);
    };
    if (settings.pair_contact == PairContact::distance_potential) {
        contact::DistancePotentialPhysics physics{settings.contact, settings.friction};
        physics.options.with_energy = with_energy;
        return find(physics);
    }
    if (scratch.topologies.empty()) {
        scratch.topologies = contact::hull_topologies(scene.shapes);
    }
    const bool is_soft = settings.pair_contact == PairContact::common_plane_soft;
    return find(contact::CommonPlanePhysics{scratch.topologies, scene.bodies, settings.friction,
                                            is_soft ? contact::PlaneLaw::soft : contact::PlaneLaw::penalty});
}

}  // namespace

std::size_t PolyhedralDem::Scratch::bytes() const {
    return pipeline.bytes() + loads.bytes() +
           bytes_of(kinematics.angular_velocity, kinematics.inverse_inertia, kinematics.inverse_mass);
}

StepLimit PolyhedralDem::limit() const {
    if (!scratch_->limit) {
        const DemTimeStep bound = time_step_bound(scene_->bodies, scene_->shapes, scene_->materials);
        scratch_->limit = StepLimit{bound.limit, false, bound.reason};
    }
    return *scratch_->limit;
}

Outcome PolyhedralDem::advance(const TimeSpan& span, const body::LoadView& loads, Measure measure,
                               SolidReport& report) {
    const body::BodySet& bodies = scene_->bodies;
    body::BodyState& state = state_.bodies;
    SolidTimes& times = scratch_->times;
    contact::ContactPipeline& contacts = scratch_->pipeline;
    const contact::ContactScene scene{scene_->shapes, scene_->materials, bodies, settings_->grid_factor,
                                      settings_->skin};
    const double kick_time = span.middle();
    const double sliding_time = 0.5 * (state_.previous_dt + span.dt);
    const bool is_first = state_.previous_dt == 0;
    const double previous_kick = !is_first ? kick_time - sliding_time : -std::numeric_limits<double>::infinity();
    report.has_stored = measure == Measure::energy || is_first;
    {
        const ScopedTimer timer(times.move_bodies);
        drift(bodies, state, kick_time, 0.5 * span.dt);
        update_kinematics(bodies, state, kick_time, scratch_->kinematics);
    }
    {
        const ScopedTimer timer(times.find_pairs);
        contacts.place_parts(scene, state);
        report.pairs_rebuilt = contacts.find_pairs();
    }
    {
        const ScopedTimer timer(times.find_contacts);
        report.friction_loss =
            find_contacts(scene, *settings_, state_, sliding_time, report.has_stored, *scratch_);  // of lost springs
    }
    {
        const ScopedTimer timer(times.contact_loads);
        contacts.gather_loads(scene, state, scratch_->loads);
    }
    report.gravity = scene_->gravity.at(kick_time);
    report.kick_time = kick_time;
    {
        const ScopedTimer timer(times.move_bodies);
        report.kick = kick(bodies, *settings_, scratch_->kinematics, scratch_->loads,
                           scratch_->point_loads.add(scene_->point_loads, state, kick_time, loads), report.gravity,
                           {kick_time, previous_kick, span.dt}, state);
        report.damping_loss = contacts.dashpot_loss(scene, state, scratch_->kinematics, span.dt);
        drift(bodies, state, span.end(), 0.5 * span.dt);
    }
    const ScopedTimer timer(times.measure);
    const PolyhedralSums sums = sum_contacts(contacts.rows(), state_.contacts);
    report.elastic = report.has_stored ? sums.elastic : 0;
    report.shear = sums.shear;
    report.friction_loss = sums.friction_loss + report.friction_loss;
    report.dt_bound = contacts.stable_step(scene);
    report.max_potential = sums.potential;
    report.max_depth = sums.overlap;
    report.contact_count = contact::count_pairs(state_.contacts.pair);
    report.pair_count = contacts.pair_count();
    state_.previous_dt = span.dt;
    return judge(bodies, *settings_, state, report.kick, sums, contacts.rows(), kick_time);
}

}  // namespace riprap::solid
