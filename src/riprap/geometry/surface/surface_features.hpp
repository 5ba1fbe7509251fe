// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/geometry/surface/triangle_mesh.hpp"

namespace riprap::geometry {

/// Turn of a surface at an edge, seen from outside of the solid.
enum class EdgeKind : std::uint8_t {
    flat,    ///< by less than `flat_turn`: nothing meets this edge
    ridge,   ///< away; an edge with a triangle on one side alone is the rim of a cliff
    valley,  ///< towards the outside
    cleft    ///< a valley by more than `steep_turn`: a body may touch both sides at once
};

/// Two triangles are one plane below this angle, ten times what heights of six digits leave of a plane [rad].
inline constexpr double flat_turn = 1e-5;
/// Angle of a valley from which on what lies in it is pushed by both sides: 3 degrees [rad].
inline constexpr double steep_turn = 0.0523598775598;

/// An edge of a surface. The left triangle has it as from -> to, the right one, where there is one, as to -> from.
struct SurfaceEdge {
    std::int32_t from, to;     ///< numbers of points
    std::int32_t left, right;  ///< triangles; right = -1 at a rim
    EdgeKind kind;
    /// Unit normal of the wall under (and over) the edge that halves the angle, pointing to the right; of a rim across
    /// the left triangle.
    Vec3 wall;
    Vec3 mean;           ///< unit vector between the normals of both sides [-]
    double half_cosine;  ///< of the angle from `mean` to either normal [-]
};

/// The triangles, edges and points of a surface as contacts meet them: which points and edges stick out, and which cell
/// of space belongs to which triangle.
///
/// Cells are bounded by the walls of the edges. They divide the places near the surface, inside and outside, so that a
/// place has one triangle whose plane counts there, and the depth below that plane has no jump from cell to cell. Where
/// three or more walls meet under a point of several slopes cells may overlap or leave a gap, by a share of the depth.
class SurfaceFeatures {
 public:
    SurfaceFeatures() = default;
    explicit SurfaceFeatures(const TriangleMesh& mesh);

    std::int32_t triangle_count() const { return static_cast<std::int32_t>(normal_.size()); }
    const Vec3& normal(std::int32_t triangle) const { return normal_[index(triangle)]; }
    const SurfaceEdge& edge(std::int32_t e) const { return edges_[index(e)]; }
    /// Numbers of the edges from corner k to the next one.
    const std::array<std::int32_t, 3>& edges_of(std::int32_t triangle) const { return edges_of_[index(triangle)]; }
    /// Edges around a point.
    std::span<const std::int32_t> fan(std::int32_t point) const {
        const auto begin = index(fan_begin_[index(point)]), end = index(fan_begin_[index(point) + 1]);
        return std::span(fan_).subspan(begin, end - begin);
    }
    /// Direction that the surface faces at a point: the sum of the normals of the edges around it.
    const Vec3& facing(std::int32_t point) const { return facing_[index(point)]; }
    /// Tells whether a point can stick out: an edge around it is a ridge.
    bool is_sharp(std::int32_t point) const { return is_sharp_[index(point)] != 0; }
    /// The triangle on the other side of an edge; -1 = none.
    std::int32_t across(std::int32_t e, std::int32_t triangle) const {
        return edge(e).left == triangle ? edge(e).right : edge(e).left;
    }
    /// Tells whether x lies in the cell of a triangle of `mesh`, the mesh of the constructor. A place on a wall belongs
    /// to the left.
    bool is_in_cell(const TriangleMesh& mesh, std::int32_t triangle, const Vec3& x) const;
    std::size_t bytes() const;

 private:
    static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
    void link_edges(const TriangleMesh& mesh);
    void measure_edge(const TriangleMesh& mesh, SurfaceEdge& edge) const;
    void link_points(const TriangleMesh& mesh);

    std::vector<Vec3> normal_;
    std::vector<SurfaceEdge> edges_;
    std::vector<std::array<std::int32_t, 3>> edges_of_;
    std::vector<std::int32_t> fan_begin_, fan_;
    std::vector<Vec3> facing_;
    std::vector<std::uint8_t> is_sharp_;
};

}  // namespace riprap::geometry
