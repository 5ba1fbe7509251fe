// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "riprap/contact/pipeline.hpp"
#include "riprap/solid/dem_settings.hpp"

namespace riprap::solid {

/// Moves every body by `dt` along its present velocities: free bodies x += v dt and an exact free rotation,
/// driven bodies to their prescribed pose at `end_time`, fixed bodies not at all.
void drift(const body::BodySet& bodies, body::BodyState& state, double end_time, double dt);
/// Moves one body as drift() does.
void drift_one(const body::BodySet& bodies, body::BodyState& state, std::int64_t index, double end_time, double dt);

/// Works, losses and impulses of a kick, summed over bodies in fixed blocks. "At the kick" means with the velocity
/// v_n + a dt/2 at the mid-step pose: the state of the equivalent velocity-Verlet sequence.
struct KickReport {
    double kinetic{0};                 ///< of free bodies, at the kick [J]
    double potential{0};               ///< -m g . x of free bodies, at the kick [J]
    double damping_loss{0};            ///< by local and mass damping in this step [J]
    double external_work{0};           ///< of external loads in this step [J]
    double work_driven{0};             ///< by driven bodies on the scene in this step [J]
    double released_energy{0};         ///< kinetic + potential that newly released bodies bring along [J]
    Vec3 momentum{};                   ///< of free bodies, at the kick [kg m/s]
    Vec3 angular_momentum{};           ///< of free bodies about the origin, at the kick [kg m^2/s]
    Vec3 impulse{};                    ///< of gravity, supports, damping and external loads in this step [N s]
    Vec3 angular_impulse{};            ///< about the origin [N m s]
    Vec3 released_momentum{};          ///< that newly released bodies bring along [kg m/s]
    Vec3 released_angular_momentum{};  ///< [kg m^2/s]
    Vec3 mass_moment{};                ///< sum of m x of free bodies [kg m]
    Vec3 released_mass_moment{};       ///< part of it that is newly free [kg m]
    double mass{0};                    ///< of free bodies [kg]
    double max_speed{0};               ///< after the kick, spin included: sqrt(2 K/m) [m/s]
    std::int64_t worst_body{-1};       ///< first body whose motion is not finite or above max_speed
};

/// Times a kick needs: now, when the last kick was, and how long this step lasts [s].
struct KickTimes {
    double now;
    double previous;  ///< -infinity for the first kick
    double dt;
};

/// Velocities and angular momenta across one step with the loads of the mid-step pose.
///
/// v += (F_contact + F_external + m g) dt / m;  L += (M_contact + M_external) dt. Local damping [Cundall1987] opposes
/// each velocity component with alpha times the size of the unbalanced force; mass damping is -c m v.
KickReport kick(const body::BodySet& bodies, const DemSettings& settings, const body::BodyKinematics& kinematics,
                const body::Loads& contact_loads, const body::LoadView& external, const Vec3& gravity,
                const KickTimes& times, body::BodyState& state);

}  // namespace riprap::solid
