// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/polyhedral_dem/polyhedral_dem.hpp"

#include <fmt/format.h>

#include <limits>

#include "riprap/core/bytes.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/solid/explicit_dem.hpp"

namespace riprap::solid {

namespace {

/// Names the body whose motion makes the step unacceptable, if any does.
Outcome judge_motion(const body::BodySet& bodies, const DemSettings& settings, const body::BodyState& state,
                     const KickReport& kick, double time) {
    if (kick.worst_body < 0) {
        return {};
    }
    const BodyId body{static_cast<std::int32_t>(kick.worst_body)};
    const Vec3& v = state.velocity[at(kick.worst_body)];
    const Vec3& x = state.position[at(kick.worst_body)];
    return {fmt::format(
        "velocity of {} is ({:.6g}, {:.6g}, {:.6g}) m/s, its spin {:.6g} rad/s, at ({:.6g}, {:.6g}, {:.6g}) m, "
        "t = {:.9g} s; allowed: finite, sqrt(2 K/m) at most {:.6g} m/s",
        bodies.name(body), v.x, v.y, v.z, norm(angular_velocity(bodies, state, body)), x.x, x.y, x.z, time,
        settings.max_speed)};
}

}  // namespace

std::size_t PolyhedralDem::Scratch::bytes() const {
    return faces.bytes() + bytes_of(kinematics.angular_velocity, kinematics.inverse_inertia, kinematics.inverse_mass);
}

Outcome PolyhedralDem::advance(const TimeSpan& span, const body::LoadView& loads, Measure measure,
                               SolidReport& report) {
    const body::BodySet& bodies = scene_->bodies;
    body::BodyState& state = state_.bodies;
    SolidTimes& times = scratch_->faces.times;
    FacesOnFaces contacts = faces();
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
    report.pairs_rebuilt = contacts.find();
    contacts.respond(scratch_->kinematics, sliding_time, report.has_stored);
    report.gravity = scene_->gravity.at(kick_time);
    report.kick_time = kick_time;
    {
        const ScopedTimer timer(times.move_bodies);
        report.kick = kick(bodies, *settings_, scratch_->kinematics, scratch_->faces.loads,
                           scratch_->point_loads.add(scene_->point_loads, state, kick_time, loads), report.gravity,
                           {kick_time, previous_kick, span.dt}, state);
    }
    const Outcome overlap = contacts.book(scratch_->kinematics, span.dt, report);
    {
        const ScopedTimer timer(times.move_bodies);
        drift(bodies, state, span.end(), 0.5 * span.dt);
    }
    state_.previous_dt = span.dt;
    const Outcome motion = judge_motion(bodies, *settings_, state, report.kick, kick_time);
    return motion.ok() ? overlap : motion;
}

std::vector<contact::ShownContact> PolyhedralDem::contacts(const SolidScene& scene, const Settings& /*settings*/,
                                                           const Fields& /*fields*/, const Scratch& scratch) {
    std::vector<contact::ShownContact> shown;
    show_rows(scratch.faces.pipeline.rows(), scene.bodies, shown);
    return shown;
}

}  // namespace riprap::solid
