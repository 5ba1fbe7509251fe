// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/advance.hpp"

#include <limits>

#include "riprap/core/timer.hpp"
#include "riprap/solid/sphere_dem/dashpot_loss.hpp"
#include "riprap/solid/sphere_dem/move_spheres.hpp"
#include "riprap/solid/sphere_dem/place.hpp"
#include "riprap/solid/sphere_dem/share.hpp"
#include "riprap/solid/sphere_dem/sphere_physics.hpp"

namespace riprap::solid::sphere_dem {

ContactSums evaluate_contacts(const SphereModel& model, double time, double sliding_time, const body::BodyState& bodies,
                              SphereState& state, SphereScratch& scratch, FacesOnFaces* faces, bool with_energy) {
    Laps laps;
    update_sphere_kinematics(model.bodies, bodies, time, scratch.kinematics);
    place(model, bodies, scratch);
    laps.end(scratch.times.move_bodies);
    Meeting meeting{model, bodies, sliding_time, with_energy, state, scratch, faces};
    SpherePhysics::for_each([&]<class P>() { P::find(meeting); });
    share_contacts(model, state, scratch);
    laps.end(scratch.times.find_contacts);
    SpherePhysics::for_each([&]<class P>() { P::respond(meeting); });
    laps.end(scratch.times.contact_loads);
    ContactSums& sums = meeting.sums;
    sums.friction_loss += meeting.lost;
    ++state.evaluations;
    scratch.evaluations = state.evaluations;
    state.friction_loss += sums.friction_loss;
    state.rolling_loss += sums.rolling_loss;
    return sums;
}

std::int64_t count_touching(const SphereModel& model, const SphereState& state) {
    std::int64_t count = 0;
    SpherePhysics::for_each([&]<class P>() { count += P::count(model, state); });
    return count;
}

SphereReport advance(const SphereModel& model, const Vec3& gravity, const body::LoadView& external,
                     const StepTimes& times, body::BodyState& bodies, SphereState& state, SphereScratch& scratch) {
    SphereReport report;
    const double half = 0.5 * times.dt, middle = times.begin + half;
    drift_spheres(model.bodies, bodies, middle, half);
    const std::int64_t searches = scratch.pairs.rebuild_count();
    report.contacts = evaluate_contacts(model, middle, 0.5 * (times.previous + times.dt), bodies, state, scratch);
    report.has_searched = scratch.pairs.rebuild_count() != searches;
    report.contact_count = static_cast<std::int64_t>(state.contacts.size() + state.walls.size());
    const bool is_first = state.evaluations == 1;
    const KickTimes kick_times{
        middle, is_first ? -std::numeric_limits<double>::infinity() : times.begin - 0.5 * times.previous, times.dt};
    DemSettings settings;
    settings.local_damping = model.settings.local_damping;
    settings.mass_damping = model.settings.mass_damping;
    settings.max_speed = model.settings.max_speed;
    report.kick =
        kick(model.bodies, settings, scratch.kinematics, scratch.loads, external, gravity, kick_times, bodies);
    report.dashpots = dashpot_loss(model, bodies, state, report.contacts.dashpot_power, times.dt, scratch);
    state.damping_loss += report.dashpots.all;
    drift_spheres(model.bodies, bodies, times.begin + times.dt, half);
    if (report.kick.worst_body >= 0) {
        report.problem = model.bodies.name(BodyId{static_cast<std::int32_t>(report.kick.worst_body)}) +
                         " moves faster than max_speed, or its motion is no number";
    } else if (!(report.contacts.deepest <= model.settings.max_overlap)) {
        report.problem = "two spheres overlap by more than max_overlap of the smaller radius";
    }
    return report;
}

}  // namespace riprap::solid::sphere_dem
