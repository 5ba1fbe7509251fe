// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/water_scratch.hpp"

#include <string_view>

#include "riprap/core/bytes.hpp"

namespace riprap::sim {

std::size_t WaterScratch::bytes() const {
    std::size_t bytes = sph.bytes() + walls.bytes() + penalty.bytes() + motion.bytes() + loads.bytes() +
                        held_loads.bytes() + bytes_of(near_numbers) +
                        bytes_of(force, torque, extra_force, sponge.force, sponge.before, correction) + joints.bytes() +
                        bytes_of(kappa, inertia, is_still, is_loose, guard_share, kinematics.angular_velocity) +
                        bytes_of(kinematics.inverse_inertia, kinematics.inverse_mass);
    body::BodyState::visit_fields(middle, [&](std::string_view, const auto& field) { bytes += bytes_of(field); });
    return bytes;
}

}  // namespace riprap::sim
