// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "riprap/coupling/cut_cells/cut_bodies.hpp"

namespace riprap::coupling {

/// Calls f(a, face, place, is_below) for the faces of a cell; is_below: the cell is below the face.
template <class F>
void for_faces_of(const fluid::grid::CellBox& box, const std::array<int, 3>& place, const F& f) {
    const std::int64_t cell = box.index(place[0], place[1], place[2]);
    for (int a = 0; a < box.axes; ++a) {
        const auto axis = static_cast<std::size_t>(a);
        f(a, cell, place[axis], false);
        f(a, cell + box.stride[axis], place[axis] + 1, true);
    }
}

/// Returns the middles of the edges of a triangle.
inline std::array<Vec3, 3> middles(const Vec3& p, const Vec3& q, const Vec3& r) {
    return {(p + q) * 0.5, (q + r) * 0.5, (r + p) * 0.5};
}

}  // namespace riprap::coupling
