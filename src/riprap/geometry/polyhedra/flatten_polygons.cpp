// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/flatten_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "riprap/core/index.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/geometry/polyhedra/merge_faces.hpp"

namespace riprap::geometry {

namespace {

constexpr double softness = 1e-8;  ///< e; keeps a corner of nearly parallel planes from going far along them
constexpr int most_rounds = 20;

/// Sums over the planes of one corner.
struct Corner {
    Mat3 normals = softness * Mat3::identity();
    Vec3 gaps{};
};

/// Adds up planes for each corner. @returns how far a corner lies off one of them at most
double gather(const Polyhedron& part, std::vector<Corner>& corners) {
    double most = 0;
    for (const auto& loop : part.faces) {
        if (loop.size() <= 3) {
            continue;
        }
        const Plane plane = face_plane(part.vertices, loop);
        for (const std::int32_t i : loop) {
            const double gap = plane.offset - dot(plane.normal, part.vertices[at(i)]);
            corners[at(i)].normals = corners[at(i)].normals + outer(plane.normal, plane.normal);
            corners[at(i)].gaps += gap * plane.normal;
            most = std::max(most, std::abs(gap));
        }
    }
    return most;
}

}  // namespace

double flatten_polygons(Polyhedron& part) {
    if (part.vertices.empty()) {
        return 0;
    }
    const double enough = 0.5 * coplanar_tolerance * length_scale(part.vertices);
    const std::vector<Vec3> before = part.vertices;
    for (int round = 0; round < most_rounds; ++round) {
        std::vector<Corner> corners(part.vertices.size());
        if (!(gather(part, corners) > enough)) {
            break;
        }
        for (std::size_t i = 0; i < corners.size(); ++i) {
            part.vertices[i] += inverse(corners[i].normals) * corners[i].gaps;
        }
    }
    double way = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        way = std::max(way, norm(part.vertices[i] - before[i]));
    }
    return way;
}

}  // namespace riprap::geometry
