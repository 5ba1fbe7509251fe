// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/implicit_dda/advance.hpp"

// Stages of one step of implicit DDA, in the order in which advance() calls them.

namespace riprap::solid::implicit_dda {

/// Makes the term of a contact point: springs, gap, and the mode and elastic slip that the history remembers.
ContactTerm make_term(const affine::BlockSystem& system, const Settings& settings, const State& state,
                      const Scratch& scratch, const affine::BlockContact& found, double dt);

/// Fills inertia, elasticity, loads, stress and fixed points of every row.
void fill_blocks(const affine::BlockSystem& system, const Settings& settings, double dt,
                 const affine::BlockLoads& external, const affine::BlockState& state, Scratch& scratch);

/// Assembles and solves until no spring comes or goes and friction has settled.
Outcome iterate(const Settings& settings, Scratch& scratch, StepReport& report);

/// Books strain energy, its numerical loss and the work of given loads; before the blocks move.
void book_blocks(const affine::BlockSystem& system, const affine::BlockLoads& external, const affine::BlockState& state,
                 Scratch& scratch, StepReport& report);

/// Keeps contacts that are closed or bonded in the history, with the slip that their shear springs hold, and bonds that
/// are left; books energies of contacts.
void remember(Scratch& scratch, affine::BlockContactHistory& history, StepReport& report);

}  // namespace riprap::solid::implicit_dda
