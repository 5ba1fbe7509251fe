// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/core/step.hpp"
#include "riprap/coupling/particle_walls/room_cells.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/particle_state.hpp"

namespace riprap::coupling {

/// Most by which the mean density of the water in a closed pocket may be above that at rest [-]. Density varies by 1 %
/// where the sound speed is chosen for the scene; three times that is a pressure that nothing in the scene makes but
/// walls that leave the water too little room.
inline constexpr double most_crowding = 0.03;

/// Tells whether closed pockets are looked for in a span: some of the water is dense enough, and the span ends another
/// piece of the time that sound needs through eight spacings. It follows from the State alone.
/// @param carries_density  false for water whose density stays that at rest, however it is squeezed: no particle tells
///                         then, and it is looked every twenty spacings of sound, two of the fastest flow
bool is_time_to_look(const fluid::ParticleSettings& settings, const fluid::ParticleState& water, const TimeSpan& span,
                     bool carries_density);

/// Returns why water in a closed pocket cannot keep its volume: bodies wall it in on all sides, and its mean density is
/// more than most_crowding above that at rest. Empty where there is no such pocket.
///
/// The density is the mean of what the particles carry or that of their mass in the room that there is, whichever is
/// more: the one feels walls that come nearer at once, the other does not drift. A pocket that a tenth of is empty has
/// a free surface, and no pocket is meant that is narrower than three spacings: pores between blocks are not resolved.
/// The body named first is the one that takes most room away; of those at rest, one that forces move.
std::string crowded_pocket(const RoomWalls& walls, const fluid::ParticleSettings& settings,
                           const fluid::ParticleState& water, double time);

}  // namespace riprap::coupling
