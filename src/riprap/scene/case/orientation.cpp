// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "riprap/core/direction.hpp"
#include "riprap/scene/case/orientation.hpp"

namespace riprap::scene {

Quat orientation_of(const Value* table) {
    if (table == nullptr) {
        return {};
    }
    if (const Value* axis_angle = table->find("axis_angle")) {
        return from_rotation_vector(get_number(*axis_angle, "angle") * direction_of(get_vector(*axis_angle, "axis")));
    }
    if (const Value* angle = table->find("angle")) {
        return from_rotation_vector({0, 0, angle->as_number()});
    }
    if (const Value* euler = table->find("euler")) {
        const Vec3 angles = to_vector(*euler);
        return from_rotation_vector({0, 0, angles.z}) * from_rotation_vector({0, angles.y, 0}) *
               from_rotation_vector({angles.x, 0, 0});
    }
    if (const Value* q = table->find("quaternion")) {
        return normalized(
            {q->items[0].as_number(), q->items[1].as_number(), q->items[2].as_number(), q->items[3].as_number()});
    }
    // The x-y plane of the body dips towards an azimuth: a turn by `dip` about the horizontal strike line, which
    // carries +z to (sin a sin d, cos a sin d, cos d); the strike is z x (that direction).
    const double dip = get_number(*table, "dip"), azimuth = get_number(*table, "dip_direction");
    return from_rotation_vector(dip * Vec3{-std::cos(azimuth), std::sin(azimuth), 0});
}

}  // namespace riprap::scene
