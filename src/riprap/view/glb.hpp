// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/core/quat.hpp"
#include "riprap/view/pack_bodies.hpp"
#include "riprap/view/water_mesh.hpp"

namespace riprap::view {

/// A body where a frame has it.
struct PlacedBody {
    std::string name;
    std::size_t shape_index{0};
    const DrawnShape* shape{nullptr};
    std::int32_t material{0};
    Vec3 position;  ///< of the centre of mass [m]
    Quat orientation;
    bool is_free{true};
};

/// A frame as binary glTF 2.0: a node for the water and one for every body, turned so that y points against gravity.
std::string glb_of(const WaterMesh& water, const std::vector<PlacedBody>& bodies, const Vec3& gravity);

}  // namespace riprap::view
