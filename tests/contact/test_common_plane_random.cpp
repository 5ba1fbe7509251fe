// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/narrowphase/common_plane.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "riprap/contact/narrowphase/common_plane_contacts.hpp"
#include "riprap/core/index.hpp"
#include "riprap/geometry/polyhedra/convex_hull.hpp"
#include "riprap/geometry/polyhedra/random_bits.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::contact {
namespace {

/// Numbers in [-1, 1), the same on every machine.
class Dice {
 public:
    double operator()() { return 2 * geometry::unit_interval(geometry::mix_bits(2013, count_++)) - 1; }
    Vec3 point() { return {(*this)(), (*this)(), (*this)()}; }

 private:
    std::uint64_t count_{0};
};

/// A shape that is placed anew for every pair.
struct Shape {
    geometry::Polyhedron polyhedron;
    HullTopology topology;
    std::vector<Vec3> vertices, normals;
    Vec3 centre;

    explicit Shape(const geometry::Polyhedron& shape)
        : polyhedron(shape), topology(hull_topology(shape)), vertices(shape.vertices), normals(shape.faces.size()) {}

    PlacedHull place(const Pose& pose) {
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            vertices[v] = to_world(pose, polyhedron.vertices[v]);
        }
        place_normals(topology, vertices, normals);
        centre = pose.position;
        return {&topology, vertices, normals, centre, 0};
    }
};

std::vector<Shape> make_shapes() {
    std::vector<Shape> shapes;
    for (std::uint64_t k = 0; k < 200; ++k) {
        shapes.emplace_back(k % 4 == 0 ? geometry::box({1.0, 0.3 + 0.01 * static_cast<double>(k % 50), 0.7})
                                       : geometry::random_hull(k, 4 + static_cast<int>(k % 17), 0.7).value());
    }
    return shapes;
}

/// Lets no pair of random hulls and boxes keep another plane than the exact search finds.
TEST(CommonPlane, OfRandomPairsIsThatOfTheExactSearch) {
    std::vector<Shape> shapes = make_shapes(), others = make_shapes();
    const int pair_count = std::getenv("RIPRAP_FULL") != nullptr ? 1'000'000 : 5'000;
    Dice dice;
    int apart = 0, overlapping = 0, fallbacks = 0;
    for (int k = 0; k < pair_count; ++k) {
        const auto place = [&](std::vector<Shape>& from, const Vec3& at_point) {
            const auto number = static_cast<std::int64_t>(0.5 * (dice() + 1) * static_cast<double>(from.size()));
            return from[at(number)].place({at_point, from_rotation_vector(3.0 * dice.point())});
        };
        const PlacedHull a = place(shapes, {}), b = place(others, 1.1 * dice.point());
        const CommonPlane exact = common_plane_exact(a, b), used = common_plane(a, b, {}, 10);
        ++(exact.gap <= 0 ? overlapping : apart);
        // A face of each may tie; the plane then lies halfway and its gap a little below.
        const bool is_tie = used.feature.kind == PlaneKind::faces && exact.gap - used.gap < 1e-5;
        EXPECT_TRUE(is_tie || std::abs(used.gap - exact.gap) <= 1e-12) << k << ": " << used.gap - exact.gap;
        fallbacks += used.is_fallback ? 1 : 0;
    }
    EXPECT_GT(apart, pair_count / 3);
    EXPECT_GT(overlapping, pair_count / 3);
    EXPECT_LT(fallbacks, pair_count / 2);  // else the fast search is none
}

}  // namespace
}  // namespace riprap::contact
