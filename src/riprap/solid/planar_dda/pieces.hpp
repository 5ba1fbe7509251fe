// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/planar_dda/step.hpp"

namespace riprap::solid::planar_dda {

/// Takes a step of `step.dt` in one piece, or in shorter ones where the method refuses: a refused piece leaves the
/// state as it was and is cut to the share that the refusal names; what follows begins with that length and grows
/// 1.3 times with every piece that is taken. Driven blocks move evenly. No piece is shorter than dt/1024.
/// @returns the refusal that no shorter piece helps, with the time that was left; the state is that of the last good
///          piece
Outcome advance_in_pieces(const Model& model, const Settings& settings, const Step& step, State& state,
                          Scratch& scratch, StepReport& report, int& piece_count);

}  // namespace riprap::solid::planar_dda
