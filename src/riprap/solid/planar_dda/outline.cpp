// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/outline.hpp"

#include <algorithm>
#include <utility>

#include "riprap/core/index.hpp"

namespace riprap::solid::planar_dda {

using geometry::Polygon;
using geometry::Vec2;

namespace {

const body::Part* parts_of(const body::BodySet& bodies, BodyId body) {
    return &bodies.parts[at(bodies.part_begin[at(body.value)])];
}

std::int32_t part_count(const body::BodySet& bodies, BodyId body) {
    return bodies.part_begin[at(body.value) + 1] - bodies.part_begin[at(body.value)];
}

/// Corners of all parts, equal ones once, and the edges between them that only one part has.
struct Edges {
    std::vector<Vec2> corner;
    std::vector<std::pair<std::int32_t, std::int32_t>> edge;

    std::int32_t corner_at(const Vec2& x, double tolerance) {
        for (std::size_t i = 0; i < corner.size(); ++i) {
            if (norm(corner[i] - x) <= tolerance) {
                return static_cast<std::int32_t>(i);
            }
        }
        corner.push_back(x);
        return static_cast<std::int32_t>(corner.size()) - 1;
    }
    void add(std::int32_t from, std::int32_t to) {
        const auto back = std::find(edge.begin(), edge.end(), std::pair{to, from});
        if (back != edge.end()) {
            edge.erase(back);
        } else {
            edge.emplace_back(from, to);
        }
    }
};

}  // namespace

Polygon corners_of_prism(const geometry::ShapeSet& shapes, ShapeId shape) {
    const geometry::Polyhedron prism = shapes.polyhedron(shape);
    for (const auto& face : prism.faces) {
        const bool is_top =
            std::all_of(face.begin(), face.end(), [&prism](std::int32_t v) { return prism.vertices[at(v)].z > 0; });
        if (is_top) {
            Polygon corners;
            for (const std::int32_t v : face) {
                corners.push_back({prism.vertices[at(v)].x, prism.vertices[at(v)].y});
            }
            return corners;
        }
    }
    return {};
}

Polygon outline_of(const SolidScene& scene, BodyId body) {
    const body::Part* parts = parts_of(scene.bodies, body);
    Edges edges;
    for (std::int32_t p = 0; p < part_count(scene.bodies, body); ++p) {
        const Polygon local = corners_of_prism(scene.shapes, parts[p].shape);
        const double tolerance = 1e-9 * scene.shapes.view(parts[p].shape).circumradius;
        std::vector<std::int32_t> ids;
        for (const Vec2& x : local) {
            const Vec3 moved = parts[p].local.position + rotate(parts[p].local.orientation, Vec3{x.x, x.y, 0});
            ids.push_back(edges.corner_at({moved.x, moved.y}, tolerance));
        }
        for (std::size_t k = 0; k < ids.size(); ++k) {
            edges.add(ids[k], ids[(k + 1) % ids.size()]);
        }
    }
    Polygon outline;
    for (std::int32_t here = edges.edge.empty() ? -1 : edges.edge.front().first; here >= 0;) {
        const auto next =
            std::find_if(edges.edge.begin(), edges.edge.end(), [here](const auto& edge) { return edge.first == here; });
        if (next == edges.edge.end()) {
            break;
        }
        outline.push_back(edges.corner[at(here)]);
        here = next->second;
        edges.edge.erase(next);
    }
    return edges.edge.empty() ? outline : Polygon{};
}

Polygon outline_of_half_space(const SolidScene& scene, BodyId body, const Vec2& about, double extent) {
    const body::Part& part = *parts_of(scene.bodies, body);
    const geometry::ConvexView view = scene.shapes.view(part.shape);
    const Vec3 n = rotate(part.local.orientation, view.normal(0));
    const Vec2 normal{n.x, n.y}, along{-n.y, n.x};
    const double offset = view.offset[0] + dot(n, part.local.position);
    const Vec2 foot = about + (offset - dot(normal, about)) * normal;
    return {foot - extent * along, foot - extent * along - extent * normal, foot + extent * along - extent * normal,
            foot + extent * along};
}

}  // namespace riprap::solid::planar_dda
