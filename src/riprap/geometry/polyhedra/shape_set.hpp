// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/core/ids.hpp"
#include "riprap/geometry/polyhedra/aligned_vector.hpp"
#include "riprap/geometry/polyhedra/convex_view.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry {

/// Every convex shape of a scene, each stored once however many bodies use it. Flat pools, so that a kernel on a
/// device needs a handful of pointers. Built while the case is read, then const. Every vertex and face array of a
/// shape begins on a multiple of 64 bytes and is padded to shape_lanes.
class ShapeSet {
 public:
    /// Adds a convex polyhedron given in any frame; stores it about its centre of mass, axes unchanged. Coplanar
    /// neighbours are merged first (merge_coplanar_faces). The caller has audited the input: closed, outward, convex,
    /// positive volume; builds with assertions check it again and throw InternalError.
    ///
    /// Internal faces carry no field, and inscribed_radius is then the largest value in the part of the distance to
    /// the faces that do (largest_inscribed_sphere).
    /// @param planar  the shape is a prism with end faces normal to z: the end faces become internal, so that
    ///                inscribed_radius is that of the largest inscribed circle.
    /// @returns the id and, in `centroid` where not null, where the shape's origin lies in the given frame [m].
    ShapeId add_convex(const Polyhedron& polyhedron, bool planar = false, Vec3* centroid = nullptr);

    /// Adds the half-space { x : normal . x <= offset }; no volume, no vertices; only for fixed or moving bodies.
    /// The plane is face 0 of the view, vertex_count 0, inscribed_radius and circumradius infinity, fdem_weight 0.
    /// @param normal  any length but zero; offset is in units of it, so the plane is that of the inequality [m]
    ShapeId add_half_space(const Vec3& normal, double offset);

    /// Gives back memory kept for growth. Invalidates views. Worth calling once the scene is read.
    void shrink_to_fit();

    std::int32_t size() const { return static_cast<std::int32_t>(entries_.size()); }
    /// Valid until the next shape is added.
    ConvexView view(ShapeId shape) const;
    bool is_half_space(ShapeId shape) const { return entry(shape).is_half_space; }
    double volume(ShapeId shape) const { return entry(shape).volume; }  ///< [m^3]; 0 for a half-space
    /// Integral of x x^T dV about the centre of mass [m^5]; 0 for a half-space.
    const Mat3& second_moment(ShapeId shape) const { return entry(shape).second_moment; }
    /// Sum over field-carrying faces of area * n n^T [m^2], for the time-step bound; 0 for a half-space.
    const Mat3& area_tensor(ShapeId shape) const { return entry(shape).area_tensor; }
    /// The shape as a polyhedron again (for output and audits), in its own frame; empty for a half-space.
    Polyhedron polyhedron(ShapeId shape) const;
    /// Bytes held, unused capacity included, for `riprap check` and the memory figures.
    std::size_t bytes() const;

 private:
    struct Entry {
        std::int32_t vertex_begin, vertex_count;
        std::int32_t face_begin, face_count;
        std::int32_t start_begin, loop_begin;
        bool is_half_space, is_planar, has_cut, is_sharp;
        double inscribed_radius, circumradius, round_radius, volume;
        Mat3 second_moment, area_tensor;
    };
    const Entry& entry(ShapeId shape) const { return entries_[static_cast<std::size_t>(shape.value)]; }
    Entry new_entry(std::size_t vertex_count, std::size_t face_count) const;
    ShapeId append_entry(const Entry& entry);
    void append_vertices(const std::vector<Vec3>& vertices);
    void append_faces(const Polyhedron& shape, const std::vector<Plane>& planes, const std::vector<double>& weights);

    std::vector<Entry> entries_;
    AlignedVector<double> vertex_x_, vertex_y_, vertex_z_;
    AlignedVector<double> normal_x_, normal_y_, normal_z_, offset_, fdem_weight_;
    std::vector<std::int32_t> face_start_, face_vertex_;
    std::vector<std::uint8_t> is_internal_;
};

}  // namespace riprap::geometry
