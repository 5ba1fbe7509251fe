// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "riprap/geometry/surface/triangle_mesh.hpp"

namespace riprap::geometry {

/// Position of a place relative to a surface.
struct SurfaceDistance {
    double distance;        ///< to the nearest point of the surface, negative inside of the solid [m]
    Vec3 normal;            ///< unit vector out of the solid there [-]
    std::int32_t triangle;  ///< that holds the nearest point
};

/// Questions about a surface of triangles and one place. Triangles are entered into columns along `up`, so that an
/// answer looks at those near the place alone.
///
/// A place is inside where the first triangle above it along `up` is seen from its inner side; of a closed surface that
/// is its inside, of an open one all that lies under it.
class TriangleField {
 public:
    TriangleField() = default;
    /// @param up  direction of length 1 that most of an open surface faces
    TriangleField(TriangleMesh mesh, const Vec3& up);

    bool is_inside(const Vec3& x) const;
    /// Nothing where the surface is farther than `reach` [m].
    std::optional<SurfaceDistance> nearest(const Vec3& x, double reach) const;
    /// Appends the triangles that come as near to x as `radius` [m], ascending.
    void near(const Vec3& x, double radius, std::vector<std::int32_t>& found) const;
    const TriangleMesh& mesh() const { return mesh_; }
    std::size_t bytes() const;

 private:
    struct Place {
        double u, v, height;
    };
    Place place(const Vec3& x) const { return {dot(x, u_), dot(x, v_), dot(x, up_)}; }
    /// Calls look(triangle) for the triangles of every column that a ball about a place may meet, some more than once.
    template <class Look>
    void visit_columns(const Place& here, double radius, const Look& look) const;
    std::int64_t column(double u) const;
    std::int64_t row(double v) const;
    /// Height of the triangle at (u, v) where it covers that; sharing edges leave no gap.
    std::optional<double> height_at(std::int32_t triangle, double u, double v) const;

    TriangleMesh mesh_;
    Vec3 up_{0, 0, 1}, u_{1, 0, 0}, v_{0, 1, 0};
    std::vector<Place> places_;  // of the points
    double u0_{0}, v0_{0}, cell_{1};
    std::int64_t columns_{0}, rows_{0};
    std::vector<std::int32_t> begin_, triangles_;  // of each column
    std::vector<double> low_, high_;               // heights of the triangles of each column
};

}  // namespace riprap::geometry
