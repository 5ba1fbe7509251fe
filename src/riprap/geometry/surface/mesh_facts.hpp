// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "riprap/geometry/surface/triangle_mesh.hpp"

namespace riprap::geometry {

/// What a surface is like, for someone who gave it: a slip in units, axes or marks shows here.
struct MeshFacts {
    Vec3 low{}, high{};  ///< corners of its box [m]
    std::int32_t triangles{0};
    std::int32_t parts{0};       ///< pieces that no edge connects
    std::int32_t open_parts{0};  ///< of them, those with a rim
    std::int32_t holes{0};       ///< rims beyond one for each open part
    std::int32_t rim_edges{0};   ///< edges of one triangle alone
    double rim_length{0};        ///< their length [m]
    std::int32_t hollows{0};     ///< closed parts that face inwards: what is inside of them is hollow, solid around it
    Vec3 outward{};              ///< unit vector that open parts face most, by their area; zero where they close nearly
    double steepest{0};          ///< angle of a triangle against the level [rad]
    Vec3 at_steepest{};          ///< the middle of that triangle [m]
    double steep_share{0};       ///< share of triangles steeper than 80 degrees [-]
};

/// @param up  unit vector against which slopes are measured
MeshFacts facts_of(const TriangleMesh& mesh, const Vec3& up);

/// "x 0 to 10, y 0 to 20, z 1 to 3 m; 400 triangles in 1 part, 2 holes, rims 64 m long, facing +z; steepest 31.2 deg at
/// (...)", and of closed surfaces "closed, solid inside"
std::string text_of(const MeshFacts& facts);

/// "5.12e+06 m from the origin, where double precision resolves 9.3e-10 m"
/// @param epsilon  relative spacing of the numbers in which coordinates are kept
std::string precision_text(const Vec3& low, const Vec3& high, double epsilon, const char* of);

/// The largest coordinate in the box [m].
double farthest(const Vec3& low, const Vec3& high);

/// True where a box lies so far from the origin for its size that products of coordinates lose digits.
bool is_far(const Vec3& low, const Vec3& high);

/// Corners of the box around the vertices that faces use [m].
std::pair<Vec3, Vec3> box_of_faces(const Surface& surface);

/// Corners of the box around points [m].
std::pair<Vec3, Vec3> box_of(std::span<const Vec3> points);

/// Counts the groups of convex parts that neither a shared face nor touching boxes tie together: bodies of their own,
/// by the look of them. @param pieces  with their shared faces flagged internal
std::size_t count_apart(std::span<const Polyhedron> pieces);

}  // namespace riprap::geometry
