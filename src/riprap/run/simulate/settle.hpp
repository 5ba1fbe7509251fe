// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "riprap/scene/read_case.hpp"

namespace riprap::run {

/// Told after each step of settling: which, its time and that of the last one [s].
using SettleWatch = std::function<void(std::int64_t step, double time, double end)>;

/// Lets the free bodies of a case come to rest before time 0, for TimeSettings::settle, as if there were no water:
/// armour settles dry. Free bodies start from rest, driven ones stand where they start, nothing is released, and loads
/// that start later than time 0 do not act, others do not stop, gravity does not turn. With `settle_static` methods
/// lose their inertia meanwhile. `state`, that of the case at time 0, gets where bodies lie then, how they are
/// strained, and the contacts that hold them; velocities are those of the case. Depends on the case alone: a run that
/// is resumed settles again, to the same bits. A warning says how fast the fastest body still moves where that is above
/// a centimetre a second.
/// @throws CaseError where bodies cannot settle
void settle(scene::LoadedCase& loaded, sim::State& state, const SettleWatch& watch = {});

}  // namespace riprap::run
