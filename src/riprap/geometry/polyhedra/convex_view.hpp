// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/core/vec3.hpp"

namespace riprap::geometry {

/// Lanes that vertex and face arrays of a shape are padded to, so that vector loops need no tail.
inline constexpr int shape_lanes = 8;

/// A convex polyhedron as the contact kernels read it: flat arrays in the body frame (origin at the centre of
/// mass), not owned, trivially copyable, usable on host and device.
///
/// The body is { x : h_j(x) >= 0 for all faces j } with h_j(x) = offset[j] - normal[j] . x, the signed distance to
/// face plane j, positive inside [m]. Vertex arrays are padded to a multiple of shape_lanes with copies of the last
/// vertex, face arrays with copies of the last face.
///
/// An *internal* face (between convex parts of one concave body, or the end face of a planar prism) bounds the part
/// but carries no field: it is not integrated over and takes no part in min_j w_j h_j. It still clips.
struct ConvexView {
    std::int32_t vertex_count;
    std::int32_t face_count;
    const double *vertex_x, *vertex_y, *vertex_z;           ///< [m]
    const double *normal_x, *normal_y, *normal_z, *offset;  ///< outward unit normal [-], plane offset [m]
    const double* fdem_weight;                              ///< 1/H_j [1/m], H_j = largest depth below face j
    const std::int32_t* face_start;                         ///< face_count + 1 entries into face_vertex
    const std::int32_t* face_vertex;  ///< vertices of each face, counter-clockwise seen from outside
    const std::uint8_t* is_internal;  ///< per face
    double inscribed_radius;          ///< radius r of the largest inscribed sphere [m]
    double circumradius;              ///< largest distance of a vertex from the origin [m]
    double round_radius;              ///< of the ball or disc that it stands for (round_radius_of); 0 = none [m]
    bool is_planar;                   ///< a prism of a planar scene (is_planar_prism)
    bool has_cut;                     ///< a face is internal that is no end of a planar prism
    bool is_sharp;                    ///< all edges are sharp (has_sharp_edges)

    RIPRAP_HD Vec3 vertex(int i) const { return {vertex_x[i], vertex_y[i], vertex_z[i]}; }
    RIPRAP_HD Vec3 normal(int j) const { return {normal_x[j], normal_y[j], normal_z[j]}; }
};

}  // namespace riprap::geometry
