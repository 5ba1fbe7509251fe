// SPDX-License-Identifier: Apache-2.0
#pragma once

// The surface of water given as particles, as triangles.
//
// Every particle fills the volume s^d of its lattice (s: spacing, d: 3, in planar scenes 2). The share of water is
//
//     f(x) = sum_j s^d W(|x - x_j|),    W(r) = c (1 - (r/R)^2)^3 for r < R = 2 s, of integral 1,
//
// which is 1 inside and 1/2 on a flat surface half a spacing beyond the last particles. The surface f = 1/2 is taken
// from a lattice of cells of one spacing, each cut into six tetrahedra (marching tetrahedra); in planar scenes the part
// of the plane with f > 1/2 is filled with triangles. Sheets thinner than half a spacing and single drops are lost.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/vec3.hpp"

namespace riprap::view {

/// Triangles, counter-clockwise seen from the air.
struct WaterMesh {
    std::vector<Vec3> points;                            ///< [m]
    std::vector<Vec3> normals;                           ///< of the points, away from the water [-]
    std::vector<float> speed;                            ///< of the water at the points [m/s]
    std::vector<std::array<std::int32_t, 3>> triangles;  ///< of points
};

/// @throws FileError where the lattice around the particles has more than 10^8 nodes
WaterMesh mesh_water(std::span<const Vec3> particles, std::span<const float> speed, double spacing, bool is_planar);

}  // namespace riprap::view
