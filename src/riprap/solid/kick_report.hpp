// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/core/vec3.hpp"

namespace riprap::solid {

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

}  // namespace riprap::solid
