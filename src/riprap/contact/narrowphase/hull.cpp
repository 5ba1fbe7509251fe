// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/hull.hpp"

#include "riprap/core/error.hpp"
#include "riprap/core/index.hpp"
#include "riprap/geometry/polyhedra/half_edge.hpp"

namespace riprap::contact {

HullTopology hull_topology(const geometry::Polyhedron& shape) {
    const auto outcome = geometry::half_edges(shape);
    if (!outcome) {
        throw InternalError("common plane of an open surface: " + outcome.problems().front().message);
    }
    const geometry::HalfEdgeMesh& mesh = outcome.value();
    HullTopology hull;
    hull.face_start = mesh.face_edge;
    hull.face_vertex = mesh.vertex;  // half-edges of a face are consecutive, in the order of its loop
    hull.neighbour_start.push_back(0);
    hull.fan_start.push_back(0);
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
        mesh.for_each_outgoing(v, [&](std::int32_t e) {
            hull.neighbour.push_back(mesh.end(e));
            hull.fan.push_back(mesh.face[at(e)]);
        });
        hull.neighbour_start.push_back(static_cast<std::int32_t>(hull.neighbour.size()));
        hull.fan_start.push_back(static_cast<std::int32_t>(hull.fan.size()));
    }
    for (std::int32_t e = 0; e < mesh.half_edge_count(); ++e) {
        if (e < mesh.pair[at(e)]) {
            hull.edges.push_back({mesh.vertex[at(e)], mesh.end(e), mesh.face[at(e)], mesh.face[at(mesh.pair[at(e)])]});
        }
    }
    return hull;
}

void place_normals(const HullTopology& topology, std::span<const Vec3> vertices, std::span<Vec3> normals) {
    for (std::int32_t f = 0; f < topology.face_count(); ++f) {
        normals[at(f)] = normalized(geometry::vector_area(vertices, topology.loop(f)));
    }
}

}  // namespace riprap::contact
