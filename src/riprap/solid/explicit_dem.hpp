// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "riprap/contact/pipeline.hpp"
#include "riprap/solid/dem_settings.hpp"
#include "riprap/solid/kick_report.hpp"

namespace riprap::solid {

/// Moves every body by `dt` along its present velocities: free bodies x += v dt and an exact free rotation,
/// driven bodies to their prescribed pose at `end_time`, fixed bodies not at all.
void drift(const body::BodySet& bodies, body::BodyState& state, double end_time, double dt);
/// Moves one body as drift() does.
void drift_one(const body::BodySet& bodies, body::BodyState& state, std::int64_t index, double end_time, double dt);

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
