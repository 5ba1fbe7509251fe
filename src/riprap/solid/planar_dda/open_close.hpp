// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/planar_dda/step.hpp"

namespace riprap::solid::planar_dda {

/// Sets the trial of every contact to what the state remembers.
void begin_trials(const Settings& settings, Scratch& scratch);

/// Changes of one iteration.
struct Changes {
    int opened_or_closed{0};
    int returned{0};  ///< of these, contacts that had opened or closed before in this step
    int locked_or_slid{0};
    double friction{0};        ///< largest change of a friction force [N]
    double largest_normal{0};  ///< [N]
    std::int32_t worst{-1};    ///< a contact that opened or closed
};

/// Reads gap, slip and force of every contact from the last solution and decides its mode.
///
/// | was     | becomes                                                                                             |
/// |---------|-----------------------------------------------------------------------------------------------------|
/// | open    | closed when the gap is below -close_tolerance, the foot lies on the edge and the contact would push |
/// | closed  | open when spring, multiplier and dashpot together would pull; bonded: see break_bonds               |
/// | locked  | sliding when p_s abs(s) >= S                                                                        |
/// | sliding | locked when p_s abs(s) < S or the slip turns round                                                  |
///
/// S is the strength by the joint law, of Coulomb N tan(phi) + c l. The slip counts from a lock point that keeps the
/// spring of a sliding contact at its limit, so that one rule serves both ways: the elastic-plastic Coulomb spring.
Changes update_modes(const Settings& settings, double dt, Scratch& scratch);

/// Breaks all bonds whose tension passes the tensile strength, or that slide while they pull; a broken bond has lost
/// cohesion and tensile strength for good. Bonds without tensile strength open as any contact. @returns their number
int break_bonds(const Settings& settings, Scratch& scratch);

/// Adds up the plastic slip of bonds after the step and breaks those that have slid or opened by more than
/// Contact::bond_slip; see affine/bonds.hpp for why a length decides.
void end_bonds(const Settings& settings, Scratch& scratch);

/// lambda <- max(0, lambda - p d) of closed contacts [Ding2021, eq. 2.9]. @returns the largest gap left [m]
double update_multipliers(Scratch& scratch);

}  // namespace riprap::solid::planar_dda
