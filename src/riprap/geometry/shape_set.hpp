// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/ids.hpp"
#include "riprap/core/quat.hpp"
#include "riprap/geometry/convex_view.hpp"
#include "riprap/geometry/polyhedron.hpp"

namespace riprap::geometry {

/// Every convex shape of a scene, each stored once however many bodies use it. Flat pools, so that a kernel on a
/// device needs a handful of pointers. Built while the case is read, then const.
class ShapeSet {
 public:
    /// Adds a convex polyhedron given in any frame; stores it about its centre of mass, axes unchanged.
    /// Coplanar faces are merged. @throws CaseError-free: the caller has audited; asserts convexity in debug builds.
    /// @param planar  the shape is a prism with end faces normal to z: the end faces become internal and
    ///                inscribed_radius is that of the largest inscribed circle.
    /// @returns the id and, in `centroid`, where the shape's origin lies in the given frame [m].
    ShapeId add_convex(const Polyhedron& polyhedron, bool planar, Vec3* centroid);

    /// Adds the half-space { x : normal . x <= offset }; no volume, no vertices; only for fixed or moving bodies.
    /// Its plane is face 0 of the view, vertex_count 0, inscribed_radius infinity.
    ShapeId add_half_space(const Vec3& normal, double offset);

    std::int32_t size() const { return static_cast<std::int32_t>(entries_.size()); }
    ConvexView view(ShapeId shape) const;
    bool is_half_space(ShapeId shape) const;
    double volume(ShapeId shape) const;              ///< [m^3]; 0 for a half-space
    const Mat3& second_moment(ShapeId shape) const;  ///< integral of x x^T dV [m^5]
    /// Sum over field-carrying faces of area * n n^T [m^2], for the time-step bound.
    const Mat3& area_tensor(ShapeId shape) const;
    /// The shape as a polyhedron again (for output and audits), in its own frame.
    Polyhedron polyhedron(ShapeId shape) const;
    /// Bytes held, for `riprap check` and the memory figures.
    std::size_t bytes() const;

 private:
    struct Entry {
        std::int32_t vertex_begin, vertex_count;
        std::int32_t face_begin, face_count;
        std::int32_t start_begin, loop_begin;
        bool is_half_space;
        double inscribed_radius, circumradius, volume;
        Mat3 second_moment, area_tensor;
    };
    std::vector<Entry> entries_;
    std::vector<double> vertex_x_, vertex_y_, vertex_z_;
    std::vector<double> normal_x_, normal_y_, normal_z_, offset_, fdem_weight_;
    std::vector<std::int32_t> face_start_, face_vertex_;
    std::vector<std::uint8_t> is_internal_;
};

}  // namespace riprap::geometry
