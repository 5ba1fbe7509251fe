// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/shape_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "riprap/core/error.hpp"
#include "riprap/geometry/polyhedra/chebyshev.hpp"
#include "riprap/geometry/polyhedra/merge_faces.hpp"
#include "riprap/geometry/polyhedra/round_shapes.hpp"
#include "riprap/geometry/polyhedra/sharp_edges.hpp"

namespace riprap::geometry {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Round-off allowed in the checks of convexity, as a fraction of the shape's size.
constexpr double convexity_tolerance = 1e-9;

std::size_t padded(std::size_t count) {
    constexpr auto lanes = static_cast<std::size_t>(shape_lanes);
    return (count + lanes - 1) / lanes * lanes;
}

/// Fills up to a whole number of lanes with copies of the last entry.
template <class Vector>
void pad(Vector& array) {
    if (!array.empty()) {
        array.resize(padded(array.size()), array.back());
    }
}

std::vector<Plane> face_planes(const Polyhedron& shape) {
    std::vector<Plane> planes;
    planes.reserve(shape.faces.size());
    for (const auto& loop : shape.faces) {
        planes.push_back(face_plane(shape.vertices, loop));
    }
    return planes;
}

/// H_j: the largest depth below face j of any vertex.
double depth_below(const Plane& plane, const std::vector<Vec3>& vertices) {
    double depth = 0;
    for (const Vec3& x : vertices) {
        depth = std::max(depth, plane.offset - dot(plane.normal, x));
    }
    return depth;
}

double middle_height(const std::vector<Vec3>& vertices) {
    const auto [low, high] =
        std::minmax_element(vertices.begin(), vertices.end(), [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
    return 0.5 * (low->z + high->z);
}

/// The end faces of a prism along z carry no field, nor do those that carried none before.
void mark_end_faces(Polyhedron& shape, const std::vector<Plane>& planes) {
    shape.is_internal.resize(shape.faces.size(), 0);
    for (std::size_t j = 0; j < planes.size(); ++j) {
        const bool is_end = std::abs(planes[j].normal.z) > 1 - convexity_tolerance;
        RIPRAP_ASSERT(is_end || std::abs(planes[j].normal.z) < convexity_tolerance,
                      "a planar shape has faces along and normal to z only");
        shape.is_internal[j] = is_end || shape.is_internal[j] != 0 ? 1 : 0;
    }
}

/// Tells whether a face carries no field that is no end of a planar prism: the part was cut from a larger one.
bool has_cut(const Polyhedron& shape, const std::vector<Plane>& planes, bool is_planar) {
    for (std::size_t j = 0; j < shape.is_internal.size(); ++j) {
        if (shape.is_internal[j] != 0 && !(is_planar && std::abs(planes[j].normal.z) > 0.5)) {
            return true;
        }
    }
    return false;
}

Mat3 area_tensor_of(const Polyhedron& shape, const std::vector<Plane>& planes) {
    Mat3 sum{};
    for (std::size_t j = 0; j < planes.size(); ++j) {
        if (shape.is_internal.empty() || shape.is_internal[j] == 0) {
            const double area = norm(vector_area(shape.vertices, shape.faces[j]));
            sum = sum + area * outer(planes[j].normal, planes[j].normal);
        }
    }
    return sum;
}

[[maybe_unused]] bool is_convex(const std::vector<Vec3>& vertices, const std::vector<Plane>& planes, double scale) {
    return std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
        return std::all_of(vertices.begin(), vertices.end(), [&](const Vec3& x) {
            return plane.offset - dot(plane.normal, x) >= -convexity_tolerance * scale;
        });
    });
}

}  // namespace

ShapeId ShapeSet::add_convex(const Polyhedron& polyhedron, bool planar, Vec3* centroid) {
    Polyhedron shape = merge_coplanar_faces(polyhedron);
    MassProperties mass = mass_properties(shape);
    if (planar) {
        mass.centroid.z = middle_height(shape.vertices);  // no round-off out of the plane of motion
    }
    for (Vec3& x : shape.vertices) {
        x -= mass.centroid;
    }
    const std::vector<Plane> planes = face_planes(shape);
    const double scale = length_scale(shape.vertices);
    RIPRAP_ASSERT(mass.volume > 0, "volume " + std::to_string(mass.volume));
    RIPRAP_ASSERT(is_convex(shape.vertices, planes, scale), "a vertex lies outside a face plane");
    if (planar) {
        mark_end_faces(shape, planes);
    }
    // A part surrounded by other parts carries no field at all; its radius is then that of the plain largest sphere.
    const bool has_field = shape.is_internal.empty() ||
                           std::find(shape.is_internal.begin(), shape.is_internal.end(), 0) != shape.is_internal.end();

    Entry added = new_entry(shape.vertices.size(), shape.faces.size());
    added.volume = mass.volume;
    added.second_moment = mass.second_moment;
    added.area_tensor = area_tensor_of(shape, planes);
    const std::span<const std::uint8_t> flags = has_field ? std::span(shape.is_internal) : std::span<std::uint8_t>{};
    added.inscribed_radius = largest_inscribed_sphere(planes, flags, {}, scale).radius;
    added.has_cut = has_cut(shape, planes, planar);
    added.round_radius = round_radius_of(shape, planar, mass.volume);
    for (const Vec3& x : shape.vertices) {
        added.circumradius = std::max(added.circumradius, norm(x));
    }
    std::vector<double> weights;
    weights.reserve(planes.size());
    for (const Plane& plane : planes) {
        weights.push_back(1 / depth_below(plane, shape.vertices));
    }
    append_vertices(shape.vertices);
    append_faces(shape, planes, weights);
    if (centroid != nullptr) {
        *centroid = mass.centroid;
    }
    return append_entry(added);
}

ShapeId ShapeSet::add_half_space(const Vec3& normal, double offset) {
    const double length = norm(normal);
    RIPRAP_ASSERT(length > 0 && std::isfinite(length) && std::isfinite(offset), "half-space without a direction");
    Entry added = new_entry(0, 1);
    added.is_half_space = true;
    added.inscribed_radius = infinity;
    added.circumradius = infinity;
    append_faces({{}, {{}}, {}}, {{normal / length, offset / length}}, {0.0});
    return append_entry(added);
}

ShapeId ShapeSet::append_entry(const Entry& entry) {
    entries_.push_back(entry);
    const ShapeId id{size() - 1};
    const ConvexView added = view(id);
    entries_.back().is_planar = is_planar_prism(added);
    entries_.back().is_sharp = has_sharp_edges(added);
    return id;
}

ShapeSet::Entry ShapeSet::new_entry(std::size_t vertex_count, std::size_t face_count) const {
    Entry e{};
    e.vertex_begin = static_cast<std::int32_t>(vertex_x_.size());
    e.vertex_count = static_cast<std::int32_t>(vertex_count);
    e.face_begin = static_cast<std::int32_t>(offset_.size());
    e.face_count = static_cast<std::int32_t>(face_count);
    e.start_begin = static_cast<std::int32_t>(face_start_.size());
    e.loop_begin = static_cast<std::int32_t>(face_vertex_.size());
    return e;
}

void ShapeSet::append_vertices(const std::vector<Vec3>& vertices) {
    for (const Vec3& x : vertices) {
        vertex_x_.push_back(x.x);
        vertex_y_.push_back(x.y);
        vertex_z_.push_back(x.z);
    }
    for (auto* array : {&vertex_x_, &vertex_y_, &vertex_z_}) {
        pad(*array);
    }
}

void ShapeSet::append_faces(const Polyhedron& shape, const std::vector<Plane>& planes,
                            const std::vector<double>& weights) {
    std::int32_t start = 0;
    for (std::size_t j = 0; j < planes.size(); ++j) {
        normal_x_.push_back(planes[j].normal.x);
        normal_y_.push_back(planes[j].normal.y);
        normal_z_.push_back(planes[j].normal.z);
        offset_.push_back(planes[j].offset);
        fdem_weight_.push_back(weights[j]);
        is_internal_.push_back(shape.is_internal.empty() ? std::uint8_t{0} : shape.is_internal[j]);
        face_start_.push_back(start);
        face_vertex_.insert(face_vertex_.end(), shape.faces[j].begin(), shape.faces[j].end());
        start += static_cast<std::int32_t>(shape.faces[j].size());
    }
    face_start_.push_back(start);
    for (auto* array : {&normal_x_, &normal_y_, &normal_z_, &offset_, &fdem_weight_}) {
        pad(*array);
    }
    pad(is_internal_);
}

void ShapeSet::shrink_to_fit() {
    entries_.shrink_to_fit();
    for (auto* array :
         {&vertex_x_, &vertex_y_, &vertex_z_, &normal_x_, &normal_y_, &normal_z_, &offset_, &fdem_weight_}) {
        array->shrink_to_fit();
    }
    face_start_.shrink_to_fit();
    face_vertex_.shrink_to_fit();
    is_internal_.shrink_to_fit();
}

ConvexView ShapeSet::view(ShapeId shape) const {
    const Entry& e = entry(shape);
    return {.vertex_count = e.vertex_count,
            .face_count = e.face_count,
            .vertex_x = vertex_x_.data() + e.vertex_begin,
            .vertex_y = vertex_y_.data() + e.vertex_begin,
            .vertex_z = vertex_z_.data() + e.vertex_begin,
            .normal_x = normal_x_.data() + e.face_begin,
            .normal_y = normal_y_.data() + e.face_begin,
            .normal_z = normal_z_.data() + e.face_begin,
            .offset = offset_.data() + e.face_begin,
            .fdem_weight = fdem_weight_.data() + e.face_begin,
            .face_start = face_start_.data() + e.start_begin,
            .face_vertex = face_vertex_.data() + e.loop_begin,
            .is_internal = is_internal_.data() + e.face_begin,
            .inscribed_radius = e.inscribed_radius,
            .circumradius = e.circumradius,
            .round_radius = e.round_radius,
            .is_planar = e.is_planar,
            .has_cut = e.has_cut,
            .is_sharp = e.is_sharp};
}

Polyhedron ShapeSet::polyhedron(ShapeId shape) const {
    Polyhedron result;
    if (is_half_space(shape)) {
        return result;
    }
    const ConvexView v = view(shape);
    for (std::int32_t i = 0; i < v.vertex_count; ++i) {
        result.vertices.push_back(v.vertex(i));
    }
    for (std::int32_t j = 0; j < v.face_count; ++j) {
        result.faces.emplace_back(v.face_vertex + v.face_start[j], v.face_vertex + v.face_start[j + 1]);
    }
    if (std::any_of(v.is_internal, v.is_internal + v.face_count, [](std::uint8_t flag) { return flag != 0; })) {
        result.is_internal.assign(v.is_internal, v.is_internal + v.face_count);
    }
    return result;
}

std::size_t ShapeSet::bytes() const {
    std::size_t doubles = 0;
    for (const auto* array :
         {&vertex_x_, &vertex_y_, &vertex_z_, &normal_x_, &normal_y_, &normal_z_, &offset_, &fdem_weight_}) {
        doubles += array->capacity();
    }
    return entries_.capacity() * sizeof(Entry) + doubles * sizeof(double) +
           (face_start_.capacity() + face_vertex_.capacity()) * sizeof(std::int32_t) + is_internal_.capacity();
}

}  // namespace riprap::geometry
