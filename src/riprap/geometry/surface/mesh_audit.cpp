// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/surface/mesh_audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <span>
#include <tuple>

#include "riprap/core/index.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"
#include "riprap/geometry/surface/surface.hpp"

namespace riprap::geometry {

namespace {

constexpr std::size_t most_told = 5;

/// One side of an edge.
struct Side {
    std::int32_t low, high, triangle;
    bool is_up;  ///< runs from low to high

    auto order() const { return std::tuple{low, high, triangle}; }
};

std::vector<Side> sides_of(const TriangleMesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(3 * at(mesh.size()));
    for (std::int32_t t = 0; t < mesh.size(); ++t) {
        const auto& corners = mesh.corners[at(t)];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t p = corners[k], q = corners[(k + 1) % 3];
            sides.push_back({std::min(p, q), std::max(p, q), t, p < q});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.order() < b.order(); });
    return sides;
}

/// Calls `look` with the sides of each edge.
template <class Look>
void for_each_edge(const std::vector<Side>& sides, Look look) {
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
        while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) {
            ++end;
        }
        look(std::span(sides).subspan(i, end - i));
    }
}

std::size_t count_rims(const TriangleMesh& mesh) {
    std::size_t count = 0;
    for_each_edge(sides_of(mesh), [&count](std::span<const Side> edge) { count += edge.size() == 1 ? 1 : 0; });
    return count;
}

class Auditor {
 public:
    Auditor(TriangleMesh& mesh, const Surface& surface) : mesh_(mesh), surface_(surface) {}

    MeshAudit run() {
        look_at_polygons();
        join_doubles();
        if (audit_.problems.empty()) {
            look_at_winding();
        }
        if (audit_.problems.empty()) {
            look_for_cracks();
        }
        return std::move(audit_);
    }

 private:
    std::size_t face(std::int32_t t) const { return at(mesh_.faces[at(t)]); }
    std::string name(std::int32_t t) const {
        return surface_.face_place[face(t)] > 0 ? surface_.name_of(face(t)) : fmt::format("face {}", face(t) + 1);
    }
    std::string place(std::int32_t point) const {
        const Vec3& x = mesh_.points[at(point)];
        return fmt::format("({:.9g}, {:.9g}, {:.6g})", x.x, x.y, x.z);
    }
    void problem(std::int32_t t, std::string message, std::string allowed) {
        SourcePlace where = surface_.place_of(face(t));
        where.line = surface_.face_place[face(t)] > 0 ? where.line : 0;
        audit_.problems.push_back({std::move(where), std::move(message), std::move(allowed)});
    }

    /// Refuses polygons that have triangles which turn against them.
    void look_at_polygons() {
        for (std::int32_t t = 0; t < mesh_.size(); ++t) {
            const auto corners = surface_.face(face(t));
            if (corners.size() > 3 && dot(vector_area(surface_.vertices, corners), mesh_.area_normal(t)) < 0) {
                problem(t,
                        fmt::format("{} is no polygon that triangles can fill: it crosses itself, or is far from flat",
                                    name(t)),
                        "triangles, or flat polygons of at most 1000 corners that do not cross themselves");
                return;
            }
        }
    }

    /// Triangles in an order that puts those of the same three points beside each other, and whether they turn like
    /// these points in rising order.
    struct Triple {
        std::array<std::int32_t, 3> points;
        std::int32_t triangle;
        bool is_even;
    };

    std::vector<Triple> triples() const {
        std::vector<Triple> list;
        list.reserve(at(mesh_.size()));
        for (std::int32_t t = 0; t < mesh_.size(); ++t) {
            std::array<std::int32_t, 3> points = mesh_.corners[at(t)];
            std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
            const bool is_even = points[1] < points[2];
            std::sort(points.begin(), points.end());
            list.push_back({points, t, is_even});
        }
        std::sort(list.begin(), list.end(), [](const Triple& a, const Triple& b) {
            return std::tie(a.points, a.triangle) < std::tie(b.points, b.triangle);
        });
        return list;
    }

    void join_doubles() {
        const std::vector<Triple> list = triples();
        std::vector<std::int32_t> doubles;
        for (std::size_t i = 1; i < list.size(); ++i) {
            if (list[i].points != list[i - 1].points) {
                continue;
            }
            if (list[i].is_even != list[i - 1].is_even) {
                problem(list[i].triangle,
                        fmt::format("{} lies on {} back to back, at {}: both sides would be solid",
                                    name(list[i].triangle), name(list[i - 1].triangle), place(list[i].points[0])),
                        "a wall with two sides apart by its thickness, or one of the two faces");
                return;
            }
            doubles.push_back(list[i].triangle);
        }
        if (doubles.empty()) {
            return;
        }
        std::sort(doubles.begin(), doubles.end());
        audit_.warnings.push_back(fmt::format("{} of {} triangles, the first of {}, repeat others and are left out",
                                              doubles.size(), mesh_.size(), name(doubles.front())));
        TriangleMesh kept{mesh_.points, {}, {}};
        for (std::int32_t t = 0; t < mesh_.size(); ++t) {
            if (!std::binary_search(doubles.begin(), doubles.end(), t)) {
                kept.corners.push_back(mesh_.corners[at(t)]);
                kept.faces.push_back(mesh_.faces[at(t)]);
            }
        }
        mesh_ = std::move(kept);
    }

    void look_at_winding() {
        std::size_t count = 0;
        for_each_edge(sides_of(mesh_), [&](std::span<const Side> edge) {
            const auto up = std::count_if(edge.begin(), edge.end(), [](const Side& side) { return side.is_up; });
            const std::int64_t more = 2 * up - static_cast<std::int64_t>(edge.size());
            if (std::abs(more) < 2) {
                return;
            }
            const auto is_more = [more](const Side& side) { return side.is_up == (more > 0); };
            const auto first = std::find_if(edge.begin(), edge.end(), is_more);
            const auto second = std::find_if(first + 1, edge.end(), is_more);
            if (++count <= most_told) {
                problem(
                    second->triangle,
                    fmt::format("{} and {}, which share the edge from {} to {} m, wind opposite ways: one of them "
                                "has its solid on the outer side",
                                name(first->triangle), name(second->triangle), place(first->low), place(first->high)),
                    "faces that wind counter-clockwise seen from outside");
            }
        });
        if (count > most_told) {
            audit_.problems.back().message += fmt::format("; {} edges more are so", count - most_told);
        }
    }

    void look_for_cracks() {
        constexpr double share = 0.1;  // of the shortest edge, which no two of its points are nearer than
        double shortest = std::numeric_limits<double>::infinity();
        for (std::int32_t t = 0; t < mesh_.size(); ++t) {
            for (int k = 0; k < 3; ++k) {
                shortest = std::min(shortest, norm(mesh_.corner(t, (k + 1) % 3) - mesh_.corner(t, k)));
            }
        }
        const std::size_t rims = count_rims(mesh_);
        if (rims == 0 || mesh_.size() < 2) {
            return;
        }
        const std::size_t left = count_rims(welded(mesh_, share * shortest));
        if (left < rims) {
            audit_.warnings.push_back(fmt::format(
                "{} of its {} rims lie within {:.2g} m of others and do not meet them: cracks, at which bodies catch; "
                "join their points in the program that made the mesh",
                rims - left, rims, share * shortest));
        }
    }

    TriangleMesh& mesh_;
    const Surface& surface_;
    MeshAudit audit_;
};

}  // namespace

MeshAudit audit_mesh(TriangleMesh& mesh, const Surface& surface) { return Auditor(mesh, surface).run(); }

}  // namespace riprap::geometry
