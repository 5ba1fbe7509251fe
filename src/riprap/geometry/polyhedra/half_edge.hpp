// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/geometry/polyhedra/outcome.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry {

/// Half-edge topology of a closed surface: every edge is two half-edges, one in the loop of each face beside it. Flat
/// arrays of indices, so that it can be copied to a device. A mesh that half_edges() has returned satisfies
///
///     pair[pair[e]] = e != pair[e],   face[next[e]] = face[e],   vertex[next[e]] = vertex[pair[e]],
///     V - E + F = 2                                                                                  (Euler),
///
/// every vertex has one closed fan of faces, and every face is plane to planarity_tolerance * length_scale.
struct HalfEdgeMesh {
    // One entry per half-edge; those of a face are consecutive, in the order of its loop.
    std::vector<std::int32_t> vertex;       ///< where the half-edge begins
    std::vector<std::int32_t> next;         ///< the half-edge after it in its face
    std::vector<std::int32_t> pair;         ///< the same edge seen from the neighbouring face
    std::vector<std::int32_t> face;         ///< the face whose loop it belongs to
    std::vector<std::int32_t> vertex_edge;  ///< per vertex: one half-edge that begins there
    std::vector<std::int32_t> face_edge;    ///< face_count + 1 entries: the first half-edge of each face

    std::int32_t vertex_count() const { return static_cast<std::int32_t>(vertex_edge.size()); }
    std::int32_t edge_count() const { return static_cast<std::int32_t>(vertex.size() / 2); }
    std::int32_t half_edge_count() const { return static_cast<std::int32_t>(vertex.size()); }
    std::int32_t face_count() const { return static_cast<std::int32_t>(face_edge.size()) - 1; }

    /// Where half-edge e ends.
    std::int32_t end(std::int32_t e) const { return vertex[index(next[index(e)])]; }
    /// The half-edge before e in its face.
    std::int32_t previous(std::int32_t e) const;
    /// The next half-edge that begins at the same vertex, clockwise seen from outside.
    std::int32_t turn(std::int32_t e) const { return next[index(pair[index(e)])]; }

    /// Calls visit(e) for each half-edge that begins at vertex v, once around.
    template <class Visit>
    void for_each_outgoing(std::int32_t v, Visit&& visit) const {
        const std::int32_t first = vertex_edge[index(v)];
        std::int32_t e = first;
        do {
            visit(e);
            e = turn(e);
        } while (e != first);
    }

    static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
};

/// A face is plane if each of its vertices is this close to its plane, as a fraction of length_scale.
inline constexpr double planarity_tolerance = 1e-9;

/// Topology of a polyhedron, or everything that keeps it from being the surface of one solid body without holes:
/// numbers out of range, faces with fewer than three or with repeated corners, faces that are not plane or have no
/// area, open edges, edges used twice in one direction (neighbours that wind against each other, or more than two
/// faces), vertices where two parts of the surface only touch, unused vertices, several pieces, holes through the body
/// (V - E + F not 2). At most problem_limit problems are listed, then their total.
Outcome<HalfEdgeMesh> half_edges(const Polyhedron& polyhedron);
inline constexpr std::size_t problem_limit = 20;

}  // namespace riprap::geometry
