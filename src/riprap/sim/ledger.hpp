// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/vec3.hpp"

namespace riprap::sim {

/// The water's part of the ledger; zero without water. Its sum kinetic + potential + internal + dissipated_viscous +
/// dissipated_diffusion + shifted + work_on_solids + wall_exchange - work_external + absorbed + flow_work - transported
/// stays what it was (fluid/sph, fluid/open).
struct WaterLedger {
    double kinetic{0}, potential{0}, internal{0};  ///< [J]
    double dissipated_viscous{0};                  ///< [J], accumulated like all below
    double dissipated_diffusion{0};                ///< by the diffusion of density and by tearing [J]
    double shifted{0};                             ///< by shifting, potential and of compression [J]
    double work_on_solids{0};                      ///< [J]
    double wall_exchange{0};                       ///< of mirrored wall pressure that no body sees [J]
    double work_external{0};   ///< by gravity along periodic axes, penalty walls and water in joints [J]
    double absorbed{0};        ///< by sponges [J]
    double flow_work{0};       ///< of pressure on what lies beyond inflows and outflows [J]
    double transported{0};     ///< energy of water that came in less that of water that went [J]
    double coupling_gap{0};    ///< what free bodies were given beyond what water says it gave them [J]
    double residual{0};        ///< the sum above less its first value [J]
    Vec3 momentum{};           ///< after the step [kg m/s]
    Vec3 momentum_residual{};  ///< momentum less the impulses of gravity and solids and less its first value [kg m/s]
    double mass{0};            ///< [kg]
};

/// Energy and momentum by term, always on. The integrator is drift-kick-drift, so everything is measured at the
/// kick, at mid-step: `time` lies half a step behind the State it came with. Closure: kinetic + potential +
/// elastic + shear + dissipated - work = its value at the first kick [J].
struct Ledger {
    double time{0};                 ///< [s]
    double kinetic{0};              ///< of free bodies [J]
    double potential{0};            ///< -m g . x of free bodies [J]
    bool has_energy{true};          ///< elastic and residual were asked for (see Measure)
    double elastic{0};              ///< stored in overlaps [J]
    double shear{0};                ///< stored in tangential and torsional springs [J]
    double dissipated_friction{0};  ///< [J], accumulated like all below
    double dissipated_contact{0};   ///< by contact dashpots [J]
    double dissipated_damping{0};   ///< by local and mass damping [J]
    double work_driven{0};          ///< done on the scene by driven bodies [J]
    double work_external{0};        ///< done by loads that are not contacts, a fluid's say [J]
    double work_gravity_change{0};  ///< by a gravity that changes with time [J]
    double work_released{0};        ///< kinetic + potential that released bodies brought along [J]
    double residual{0};             ///< closure minus its first value, with water that of both sides and the gap [J]
    /// The scale of residual [J]: the largest of
    ///   - the ranges, highest minus lowest value since the first kick, of kinetic, of kinetic + potential -
    ///     work_gravity_change - work_released, of shear, work_driven and work_external;
    ///   - what was dissipated so far, all together;
    ///   - elastic + shear as they are (elastic is not measured in every step, so its range is not known).
    /// It does not depend on where the origin lies and, but for the last term, never shrinks.
    double turnover{0};
    Vec3 momentum{};           ///< of free bodies [kg m/s]
    Vec3 impulse{};            ///< of gravity, supports, damping, external loads, releases since the start [N s]
    Vec3 momentum_residual{};  ///< momentum - impulse minus its first value [kg m/s]
    Vec3 angular_momentum{};   ///< about the origin [kg m^2/s]
    Vec3 angular_impulse{};    ///< like impulse, about the origin [N m s]
    Vec3 angular_momentum_residual{};  ///< [kg m^2/s]
    double mass{0};                    ///< of free bodies [kg]
    WaterLedger water;
};

}  // namespace riprap::sim
