// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/ground/ground_cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "riprap/core/index.hpp"
#include "riprap/geometry/polyhedra/clip.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::geometry {

namespace {

/// A prism over the loop of its first `count` vertices, the others straight below.
Polyhedron prism(std::vector<Vec3> vertices, std::int32_t count) {
    Polyhedron cell{std::move(vertices), {{}, {}}, {}};
    for (std::int32_t k = 0; k < count; ++k) {
        const std::int32_t next = (k + 1) % count;
        cell.faces[0].push_back(k);
        cell.faces[1].push_back(2 * count - 1 - k);
        cell.faces.push_back({k, k + count, next + count, next});
    }
    cell.is_internal.assign(cell.faces.size(), 1);
    cell.is_internal[0] = 0;
    return cell;
}

Polyhedron prism_under(const TriangleMesh& mesh, std::int32_t t, const Vec3& depth) {
    std::vector<Vec3> vertices;
    for (const double share : {0.0, 1.0}) {
        for (int k = 0; k < 3; ++k) {
            vertices.push_back(mesh.corner(t, k) + share * depth);
        }
    }
    return prism(std::move(vertices), 3);
}

/// Normals of the two triangles at each edge; an edge of more than two, or of two that wind against each other, counts
/// as open.
class EdgeNormals {
 public:
    explicit EdgeNormals(const TriangleMesh& mesh) {
        for (std::int32_t t = 0; t < mesh.size(); ++t) {
            for (int k = 0; k < 3; ++k) {
                sides_[directed(mesh, t, k)].push_back(t);
            }
        }
    }
    /// The triangle on the other side of edge k of t; -1 = none.
    std::int32_t across(const TriangleMesh& mesh, std::int32_t t, int k) const {
        const auto [a, b] = directed(mesh, t, k);
        const auto own = sides_.find({a, b}), other = sides_.find({b, a});
        const bool is_plain = own->second.size() == 1 && other != sides_.end() && other->second.size() == 1;
        return is_plain ? other->second.front() : -1;
    }

 private:
    static std::pair<std::int32_t, std::int32_t> directed(const TriangleMesh& mesh, std::int32_t t, int k) {
        const auto& corners = mesh.corners[at(t)];
        return {corners[at(k)], corners[at((k + 1) % 3)]};
    }
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::int32_t>> sides_;
};

Polyhedron cell_between_bisectors(const TriangleMesh& mesh, const EdgeNormals& edges, std::int32_t t,
                                  double thickness) {
    const Vec3 n = normalized(mesh.area_normal(t));
    const Vec3 middle = (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
    double reach = thickness;
    for (int k = 0; k < 3; ++k) {
        reach = std::max(reach, thickness + norm(mesh.corner(t, k) - middle));
    }
    // The triangle's plane is the first face of all: a box about it, turned by nothing, is cut by it.
    Polyhedron cell = moved(box({4 * reach, 4 * reach, 4 * reach}), {middle, Quat{}});
    const auto cut = [&cell](const Plane& plane) { cell = cell.faces.empty() ? cell : clip_convex(cell, plane); };
    cut({-n, dot(-n, middle) + thickness});
    for (int k = 0; k < 3; ++k) {
        const Vec3 &a = mesh.corner(t, k), &b = mesh.corner(t, (k + 1) % 3);
        const std::int32_t other = edges.across(mesh, t, k);
        const Vec3 down = other >= 0 ? n + normalized(mesh.area_normal(other)) : n;
        // A fold of half a turn has no bisector: the wall then is that of an open edge.
        const Vec3 wall = cross(b - a, norm(down) > 1e-6 ? down : n);
        const Vec3 outward = normalized(wall);
        cut({outward, dot(outward, a)});
    }
    cut({n, dot(n, middle)});
    if (cell.faces.empty()) {
        return {};
    }
    cell.is_internal.assign(cell.faces.size(), 1);
    for (std::size_t f = 0; f < cell.faces.size(); ++f) {
        const Plane plane = face_plane(cell.vertices, cell.faces[f]);
        if (dot(plane.normal, n) > 1 - 1e-9 && std::abs(plane.offset - dot(n, middle)) < 1e-9 * reach) {
            cell.is_internal[f] = 0;
        }
    }
    const bool has_field = std::find(cell.is_internal.begin(), cell.is_internal.end(), 0) != cell.is_internal.end();
    return has_field ? cell : Polyhedron{};
}

}  // namespace

std::vector<Polyhedron> cells_under(const TriangleMesh& mesh, double thickness, const std::optional<Vec3>& down) {
    std::vector<Polyhedron> cells;
    cells.reserve(at(mesh.size()));
    if (down) {
        for (std::int32_t t = 0; t < mesh.size(); ++t) {
            cells.push_back(prism_under(mesh, t, thickness * *down));
        }
        return cells;
    }
    const EdgeNormals edges(mesh);
    for (std::int32_t t = 0; t < mesh.size(); ++t) {
        cells.push_back(cell_between_bisectors(mesh, edges, t, thickness));
    }
    return cells;
}

std::vector<Polyhedron> cells_under_line(const std::vector<Vec3>& line, double thickness) {
    std::vector<Polyhedron> cells;
    const Vec3 depth{0, -thickness, 0}, half{0, 0, 0.5};
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec3 &a = line[i - 1], &b = line[i];
        cells.push_back(prism({a - half, a + half, b + half, b - half, a - half + depth, a + half + depth,
                               b + half + depth, b - half + depth},
                              4));
    }
    return cells;
}

}  // namespace riprap::geometry
