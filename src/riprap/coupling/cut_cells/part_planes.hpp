// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "riprap/coupling/cut_cells/cut_bodies.hpp"

namespace riprap::coupling {

/// Part of a body as half-spaces: of a sphere, the one that touches it nearest to the point asked for.
struct PartPlanes {
    std::vector<geometry::Plane> planes;
    const GridBody::Sphere* sphere{nullptr};
    Vec3 low, high;

    double distance(const Vec3& x) const {
        if (sphere != nullptr) {
            return norm(x - sphere->centre) - sphere->radius;
        }
        double largest = -std::numeric_limits<double>::infinity();
        for (const geometry::Plane& plane : planes) {
            largest = std::max(largest, dot(plane.normal, x) - plane.offset);
        }
        return largest;
    }
    /// Planes that may cut a cell; nothing where the cell lies outside.
    bool planes_across(const Vec3& centre, const Vec3& half, std::vector<geometry::Plane>& across) const {
        across.clear();
        const auto reach = [&half](const Vec3& n) {
            return std::abs(n.x) * half.x + std::abs(n.y) * half.y + std::abs(n.z) * half.z;
        };
        if (sphere != nullptr) {
            const Vec3 r = centre - sphere->centre;
            const double distance = norm(r);
            const Vec3 n = distance > 0 ? r / distance : Vec3{0, 0, 1};
            if (distance - sphere->radius >= reach(n)) {
                return false;
            }
            if (distance - sphere->radius > -reach(n)) {
                across.push_back({n, dot(n, sphere->centre) + sphere->radius});
            }
            return true;
        }
        for (const geometry::Plane& plane : planes) {
            const double gap = dot(plane.normal, centre) - plane.offset, r = reach(plane.normal);
            if (gap >= r) {
                return false;
            }
            if (gap > -r) {
                across.push_back(plane);
            }
        }
        return true;
    }
};

/// In a plane flow (axes = 2) bodies reach through its depth whatever theirs is: a block that strains by a millionth
/// would leave slits along its sides.
inline std::vector<PartPlanes> parts_of(const GridBody& body, int axes) {
    std::vector<PartPlanes> parts;
    for (const geometry::Polyhedron& polyhedron : body.parts) {
        PartPlanes part;
        part.low = part.high = polyhedron.vertices.front();
        for (const Vec3& v : polyhedron.vertices) {
            part.low = min(part.low, v);
            part.high = max(part.high, v);
        }
        for (const auto& face : polyhedron.faces) {
            const geometry::Plane plane = geometry::face_plane(polyhedron.vertices, face);
            if (axes == 3 || std::abs(plane.normal.z) < 0.5) {
                part.planes.push_back(plane);
            }
        }
        parts.push_back(std::move(part));
    }
    for (const GridBody::Sphere& sphere : body.spheres) {
        const Vec3 r{sphere.radius, sphere.radius, sphere.radius};
        parts.push_back({{}, &sphere, sphere.centre - r, sphere.centre + r});
    }
    return parts;
}

}  // namespace riprap::coupling
