// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/core/vec3.hpp"

namespace riprap::sim {

/// The fluid's part of the ledger; zero without one. With its own accounts (core/account.hpp), its sum kinetic +
/// potential + internal + lost + given + work_on_solids - work_external - transported stays what it was.
struct FluidLedger {
    double kinetic{0}, potential{0}, internal{0};  ///< [J]
    double work_on_solids{0};                      ///< [J], accumulated like all below
    double work_external{0};   ///< by gravity along periodic axes or that changes, penalty walls, water in joints [J]
    double transported{0};     ///< energy of fluid that came in less that of fluid that went [J]
    std::vector<double> own;   ///< accounts of the method, as it lists them [J]
    double artificial{0};      ///< sum of the sizes of its artificial accounts [J]
    double coupling_gap{0};    ///< what free bodies were given beyond what the fluid says it gave them [J]
    double residual{0};        ///< the sum above less its first value [J]
    Vec3 momentum{};           ///< after the step [kg m/s]
    Vec3 momentum_residual{};  ///< momentum less the impulses of gravity and solids and less its first value [kg m/s]
    double mass{0};            ///< [kg]
};

/// Energy and momentum by account, always on. Everything is measured at the kick, at mid-step: `time` lies half a step
/// behind the State that it came with. Closure: what is stored + lost + given - gained (core/account.hpp) keeps its
/// value of the first kick [J]. The names of the accounts are in ledger_table.hpp.
struct Ledger {
    double time{0};             ///< [s]
    double kinetic{0};          ///< of free bodies [J]
    double potential{0};        ///< -m g . x of free bodies [J]
    bool has_energy{true};      ///< elastic and residual were asked for (see Measure)
    double elastic{0};          ///< stored in overlaps [J]
    double shear{0};            ///< stored in tangential and torsional springs [J]
    double friction{0};         ///< lost by friction [J], accumulated like all below
    double contact_damping{0};  ///< lost by contact dashpots [J]
    double damping{0};          ///< lost by local and mass damping [J]
    std::vector<double> own;    ///< accounts of the solid method, as it lists them [J]
    double driven{0};           ///< work done on the scene by driven bodies [J]
    double external{0};         ///< work done by loads that are not contacts, those of a fluid for one [J]
    double gravity_change{0};   ///< work done by a gravity that changes with time [J]
    double released{0};         ///< kinetic + potential energy that released bodies brought along [J]
    double residual{0};         ///< closure minus its first value, with a fluid that of both sides and the gap [J]
    /// The scale of residual [J]: the largest of
    ///   - the ranges, highest minus lowest value since the first kick, of kinetic, of kinetic + potential -
    ///     gravity_change - released, of shear, driven and external;
    ///   - the sum of all losses so far;
    ///   - the energy stored in contacts and blocks (not measured in every step, so its range is not known);
    ///   - the range of the kinetic energy of the fluid, and the largest sizes so far of what it has lost in sum, done
    ///   to
    ///     solids and given.
    /// The scale does not depend on the origin and, but for the energy stored, never shrinks.
    double turnover{0};
    Vec3 momentum{};           ///< of free bodies [kg m/s]
    Vec3 impulse{};            ///< of gravity, supports, damping, external loads, releases since the start [N s]
    Vec3 momentum_residual{};  ///< momentum - impulse minus its first value [kg m/s]
    Vec3 angular_momentum{};   ///< about the origin [kg m^2/s]
    Vec3 angular_impulse{};    ///< like impulse, about the origin [N m s]
    Vec3 angular_momentum_residual{};  ///< [kg m^2/s]
    double mass{0};                    ///< of free bodies [kg]
    FluidLedger fluid;
};

}  // namespace riprap::sim
