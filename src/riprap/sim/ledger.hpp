// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/vec3.hpp"

namespace riprap::sim {

/// Energy and momentum by term, always on. The integrator is drift-kick-drift, so everything is measured at the
/// kick, at mid-step: `time` lies half a step behind the State it came with. Closure: kinetic + potential +
/// elastic + shear + dissipated - work_in = its first value [J].
struct Ledger {
    double time{0};                 ///< [s]
    double kinetic{0};              ///< of free bodies [J]
    double potential{0};            ///< -m g . x of free bodies [J]
    double elastic{0};              ///< stored in overlaps [J]
    double shear{0};                ///< stored in tangential and torsional springs [J]
    double dissipated_friction{0};  ///< [J], accumulated like all below
    double dissipated_contact{0};   ///< by contact dashpots [J]
    double dissipated_damping{0};   ///< by local and mass damping [J]
    double work_driven{0};          ///< done on the scene by driven bodies [J]
    double work_gravity_change{0};  ///< by a gravity that changes with time [J]
    double residual{0};             ///< closure minus its first value [J]
    double turnover{0};             ///< largest of kinetic range, dissipated, work: what residual is judged against [J]
    Vec3 momentum{};                ///< [kg m/s]
    Vec3 impulse{};                 ///< of gravity, supports and damping since the start [N s]
    Vec3 angular_momentum{};        ///< about the origin [kg m^2/s]
    Vec3 angular_impulse{};         ///< likewise [N m s]
    double mass{0};                 ///< of free bodies [kg]
};

}  // namespace riprap::sim
