// SPDX-License-Identifier: Apache-2.0
#pragma once

// A few convex shapes about their centroid, as flat arrays. Written out by hand so that the self-test needs none of the
// compiled libraries behind riprap::geometry.

#include <vector>

#include "riprap/geometry/polyhedra/convex_view.hpp"

namespace selftest {

/// The arrays of one shape on the host.
struct FlatShape {
    std::vector<double> vertex_x, vertex_y, vertex_z, normal_x, normal_y, normal_z, offset, fdem_weight;
    std::vector<std::int32_t> face_start{0}, face_vertex;
    std::vector<std::uint8_t> is_internal;
    double inscribed_radius{0}, circumradius{0};

    /// @param faces             corners of each face, counter-clockwise seen from outside
    /// @param inscribed_radius  of the largest inscribed sphere [m]
    FlatShape(const std::vector<riprap::Vec3>& vertices, const std::vector<std::vector<std::int32_t>>& faces,
              double inscribed_radius);
};

/// Cuboid, regular tetrahedron, triangular prism.
std::vector<FlatShape> few_shapes();

}  // namespace selftest
