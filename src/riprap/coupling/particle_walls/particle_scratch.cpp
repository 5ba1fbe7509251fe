// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/particle_scratch.hpp"

#include "riprap/core/bytes.hpp"

namespace riprap::coupling {

std::size_t ParticleScratch::bytes() const {
    return (scheme ? scheme->bytes() : 0) + walls.bytes() + penalty.bytes() + motion.bytes() + held_loads.bytes() +
           joints.bytes() + corners.bytes() + extra_force.bytes() + sponge.force.bytes() + sponge.before.bytes() +
           bytes_of(near_numbers) + bytes_of(bodies.kappa, bodies.is_still, bodies.is_loose, bodies.guard_share);
}

}  // namespace riprap::coupling
