// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "riprap/fluid/open/open_boundary.hpp"

namespace riprap::fluid {

/// Books energy and momentum that go with one particle.
/// @param gravity  without its components along periodic axes [m/s^2]
/// @param sign     1 into the water, -1 out of it
void book_particle(const ParticleSettings& settings, const ParticleState& water, std::size_t i, const Vec3& gravity,
                   double sign, Passage& passage);

/// Leaves out the particles listed, in rising order; the others keep theirs.
void leave_out(const std::vector<std::size_t>& gone, ParticleState& water);

/// Lets go what leaves the domain through its top, the side that gravity points away from along its strongest axis,
/// within the next `dt`: single splashes that would come back as rain, of which nothing more is known. Other sides, and
/// a periodic top, let nothing go.
/// @returns what went with them
Passage let_go(const ParticleSettings& settings, const Vec3& gravity, double dt, ParticleState& water);

/// Particles that let_go has taken so far: those that were there or came in, less those that are there or left through
/// openings.
std::int64_t let_go_so_far(const OpenState& open, const ParticleState& water);

/// Share of all particles that may be let go; more is no splash.
inline constexpr double share_let_go = 0.001;
std::int64_t most_let_go(const OpenState& open);

}  // namespace riprap::fluid
