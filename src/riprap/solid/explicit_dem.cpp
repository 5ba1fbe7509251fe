// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/explicit_dem.hpp"

#include <algorithm>

#include "riprap/body/free_rotation.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::solid {

namespace {

/// -alpha |f| sign(v), component by component.
Vec3 local_damping(double alpha, const Vec3& f, const Vec3& v) {
    const auto one = [alpha](double force, double velocity) {
        return velocity == 0 ? 0 : -std::copysign(alpha * std::abs(force), velocity);
    };
    return {one(f.x, v.x), one(f.y, v.y), one(f.z, v.z)};
}

/// A body's kick costs enough that small scenes share it too; part of the definition of the sums.
constexpr std::int64_t kick_block = 256;

KickReport fold(KickReport a, const KickReport& b) {
    a.kinetic += b.kinetic;
    a.potential += b.potential;
    a.damping_loss += b.damping_loss;
    a.external_work += b.external_work;
    a.work_driven += b.work_driven;
    a.released_energy += b.released_energy;
    a.momentum += b.momentum;
    a.angular_momentum += b.angular_momentum;
    a.impulse += b.impulse;
    a.angular_impulse += b.angular_impulse;
    a.released_momentum += b.released_momentum;
    a.released_angular_momentum += b.released_angular_momentum;
    a.mass_moment += b.mass_moment;
    a.released_mass_moment += b.released_mass_moment;
    a.mass += b.mass;
    a.max_speed = std::max(a.max_speed, b.max_speed);
    a.worst_body = a.worst_body >= 0 ? a.worst_body : b.worst_body;
    return a;
}

}  // namespace

void drift(const body::BodySet& bodies, body::BodyState& state, double end_time, double dt) {
    parallel::for_each(bodies.size(), [&](std::int64_t index) {
        const BodyId id{static_cast<std::int32_t>(index)};
        const auto i = at(index);
        // A body released during this drift is still driven: freedom starts with the first kick past its time.
        if (is_free(bodies, id, end_time - dt)) {
            state.position[i] += dt * state.velocity[i];
            state.orientation[i] = body::rotate_free(state.orientation[i], state.angular_momentum[i],
                                                     bodies.principal_moments[i], bodies.principal_axes[i], dt);
        } else if (bodies.drive[i] == body::Drive::driven) {
            const body::DrivenState driven = driven_state(bodies, id, end_time);
            state.position[i] = driven.pose.position;
            state.orientation[i] = driven.pose.orientation;
            state.velocity[i] = driven.velocity;
            if (!state.drive_offset.empty()) {
                state.drive_offset[i] += dt * state.drive_rate[i];
                state.position[i] += state.drive_offset[i];
                state.velocity[i] += state.drive_rate[i];
            }
            if (bodies.principal_moments[i].x > 0) {
                state.angular_momentum[i] =
                    angular_momentum_of(bodies, id, driven.pose.orientation, driven.angular_velocity);
            }
        }
    });
}

namespace {

/// A support or driver: what it takes, the free bodies gain; its motion works on them.
KickReport support_report(const body::BodyState& state, const body::BodyKinematics& kinematics,
                          const body::Loads& loads, std::size_t i, double dt) {
    KickReport report;
    report.impulse = -dt * loads.force[i];
    report.angular_impulse = -dt * (cross(state.position[i], loads.force[i]) + loads.torque[i]);
    report.work_driven =
        -dt * (dot(loads.force[i], state.velocity[i]) + dot(loads.torque[i], kinematics.angular_velocity[i]));
    return report;
}

/// Everything but gravity and contact that acts on a free body.
struct OtherLoad {
    Vec3 external_force{}, external_torque{};
    Vec3 damping_force{}, damping_torque{};
};

}  // namespace

KickReport kick(const body::BodySet& bodies, const DemSettings& settings, const body::BodyKinematics& kinematics,
                const body::Loads& contact_loads, const body::LoadView& external, const Vec3& gravity,
                const KickTimes& times, body::BodyState& state) {
    const double dt = times.dt;
    const auto kick_one = [&](std::int64_t index) {
        const auto i = at(index);
        if (kinematics.inverse_mass[i] == 0) {
            return support_report(state, kinematics, contact_loads, i, dt);
        }
        const double mass = bodies.mass[i];
        OtherLoad other;
        if (!external.force.empty()) {
            other.external_force = external.force[i];
            other.external_torque = external.torque[i];
        }
        Vec3 force = contact_loads.force[i] + other.external_force + mass * gravity;
        Vec3 torque = contact_loads.torque[i] + other.external_torque;
        other.damping_force = local_damping(settings.local_damping, force, state.velocity[i]) -
                              (settings.mass_damping * mass) * state.velocity[i];
        other.damping_torque = local_damping(settings.local_damping, torque, kinematics.angular_velocity[i]) -
                               settings.mass_damping * state.angular_momentum[i];
        force += other.damping_force;
        torque += other.damping_torque;
        if (bodies.is_planar) {
            force.z = 0;
            torque.x = torque.y = 0;
        }
        const Vec3 position = state.position[i], old_velocity = state.velocity[i];
        const Vec3 old_momentum = state.angular_momentum[i];
        const Vec3 mid_velocity = old_velocity + (0.5 * dt / mass) * force;
        const Vec3 mid_momentum = old_momentum + (0.5 * dt) * torque;
        const Vec3 mid_spin = kinematics.inverse_inertia[i] * mid_momentum;
        state.velocity[i] += (dt / mass) * force;
        state.angular_momentum[i] += dt * torque;

        KickReport report;
        report.mass = mass;
        report.mass_moment = mass * position;
        report.kinetic = 0.5 * (mass * norm_squared(mid_velocity) + dot(mid_momentum, mid_spin));
        report.potential = -mass * dot(gravity, position);
        report.damping_loss = -dt * (dot(other.damping_force, mid_velocity) + dot(other.damping_torque, mid_spin));
        report.external_work = dt * (dot(other.external_force, mid_velocity) + dot(other.external_torque, mid_spin));
        report.momentum = mass * mid_velocity;
        report.angular_momentum = mass * cross(position, mid_velocity) + mid_momentum;
        const Vec3 outside = other.damping_force + other.external_force + mass * gravity;
        report.impulse = dt * outside;
        report.angular_impulse = dt * (cross(position, outside) + other.damping_torque + other.external_torque);
        if (!is_free(bodies, BodyId{static_cast<std::int32_t>(index)}, times.previous)) {
            // At the kick, like everything else: half a kick of velocity came without a path to work along.
            report.released_energy = report.kinetic + report.potential;
            report.released_momentum = mass * old_velocity;
            report.released_angular_momentum = mass * cross(position, old_velocity) + old_momentum;
            report.released_mass_moment = report.mass_moment;
        }
        // Spin counts with the speed that holds its energy: |omega| times the radius of gyration.
        const Vec3 momentum = state.angular_momentum[i];
        report.max_speed =
            std::sqrt(norm_squared(state.velocity[i]) + dot(momentum, kinematics.inverse_inertia[i] * momentum) / mass);
        const bool is_sane = report.max_speed <= settings.max_speed && is_finite(position);
        report.worst_body = is_sane ? -1 : index;
        return report;
    };
    return parallel::reduce(bodies.size(), KickReport{}, kick_one, fold, kick_block);
}

}  // namespace riprap::solid
