// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "riprap/contact/narrowphase/common_plane.hpp"
#include "riprap/contact/narrowphase/common_plane_contacts.hpp"
#include "riprap/core/quat.hpp"
#include "riprap/geometry/polyhedra/convex_hull.hpp"
#include "riprap/geometry/polyhedra/random_bits.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::contact::testing {

/// A convex polyhedron at a place, with the arrays that a PlacedHull looks at.
struct Hull {
    HullTopology topology;
    std::vector<Vec3> vertices, normals;
    Vec3 centre;

    Hull(const geometry::Polyhedron& shape, const Pose& pose) : topology(hull_topology(shape)) {
        const geometry::Polyhedron moved = geometry::moved(shape, pose);
        vertices = moved.vertices;
        normals.resize(moved.faces.size());
        place_normals(topology, vertices, normals);
        centre = geometry::mass_properties(moved).centroid;
    }
    PlacedHull view() const { return {&topology, vertices, normals, centre, 0}; }
};

/// The largest gap over every face normal and both normals of every pair of edges, without any pruning.
inline double widest_separating_gap(const PlacedHull& a, const PlacedHull& b) {
    double best = -std::numeric_limits<double>::infinity();
    for (const Vec3& n : a.normals) {
        best = std::max(best, plane_gap(a, b, n));
    }
    for (const Vec3& n : b.normals) {
        best = std::max(best, plane_gap(a, b, -n));
    }
    const auto along = [](const PlacedHull& hull, const HullEdge& edge) {
        return hull.vertices[static_cast<std::size_t>(edge.to)] - hull.vertices[static_cast<std::size_t>(edge.from)];
    };
    for (const HullEdge& ea : a.topology->edges) {
        for (const HullEdge& eb : b.topology->edges) {
            const Vec3 n = cross(along(a, ea), along(b, eb));
            if (norm(n) > 1e-9 * norm(along(a, ea)) * norm(along(b, eb))) {
                best = std::max({best, plane_gap(a, b, normalized(n)), plane_gap(a, b, -normalized(n))});
            }
        }
    }
    return best;
}

/// Numbers in [-1, 1), the same on every machine.
class Dice {
 public:
    explicit Dice(std::uint64_t seed) : seed_(seed) {}
    double operator()() { return 2 * geometry::unit_interval(geometry::mix_bits(seed_, count_++)) - 1; }
    Vec3 point() { return {(*this)(), (*this)(), (*this)()}; }

 private:
    std::uint64_t seed_, count_{0};
};

/// A random block of 4 to 20 corners within the unit sphere, or a box.
inline geometry::Polyhedron random_shape(Dice& dice, std::uint64_t number) {
    if (number % 3 == 0) {
        return geometry::box({1 + 0.8 * dice(), 1 + 0.8 * dice(), 1 + 0.8 * dice()});
    }
    return geometry::random_hull(number, 4 + static_cast<int>(number % 17), 1).value();
}

}  // namespace riprap::contact::testing
