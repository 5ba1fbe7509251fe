// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/contact/narrowphase/distance_potential.hpp"
#include "riprap/contact/narrowphase/distance_potential_plain.hpp"
#include "riprap/contact/narrowphase/surface_in_field.hpp"
#include "riprap/geometry/polyhedra/convex_hull.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::contact::testing {

/// A convex part at a place.
struct Block {
    ShapeId shape;
    Pose pose;
    double stiffness{1};  ///< [Pa]
};

/// Shapes of a test and the two ways to look at a pair of them.
class Pairs {
 public:
    geometry::ShapeSet shapes;
    DistancePotentialOptions options{};

    /// The fast kernel; the force is zero where the blocks do not touch.
    NormalContact fast(const Block& a, const Block& b) const {
        SeparatingCache cache;
        NormalContact contact{};
        is_touching = find_contact(shapes.view(a.shape), to_frame(a.pose), a.stiffness, shapes.view(b.shape),
                                   to_frame(b.pose), b.stiffness, options, cache, contact);
        return contact;
    }
    /// The oracle.
    NormalContact plain(const Block& a, const Block& b) const {
        NormalContact contact{};
        const auto outcome =
            plain::find_contact<64>(shapes.view(a.shape), to_frame(a.pose), a.stiffness, shapes.view(b.shape),
                                    to_frame(b.pose), b.stiffness, options, contact);
        EXPECT_NE(outcome, plain::Outcome::overflow);
        is_touching = outcome == plain::Outcome::touching;
        return contact;
    }
    mutable bool is_touching{false};
};

/// Moment of the force on A about `centre` [N m].
inline Vec3 moment_about(const NormalContact& contact, const Vec3& centre) {
    return contact.moment + cross(contact.point - centre, contact.force);
}

inline Pose moved(Pose pose, const Vec3& by) {
    pose.position += by;
    return pose;
}
/// Turned about its own origin by a rotation vector in world axes.
inline Pose turned(Pose pose, const Vec3& rotation) {
    pose.orientation = normalized(from_rotation_vector(rotation) * pose.orientation);
    return pose;
}

/// -dE/dx and -dE/dtheta of A by central differences of fourth order, exact where E is a quartic in the displacement;
/// `energy` maps a pose of A to E.
template <class Energy>
std::pair<Vec3, Vec3> energy_gradient(const Pose& pose, double step, const Energy& energy) {
    const auto slope = [&](auto&& move, const Vec3& direction) {
        const auto difference = [&](double h) {
            return energy(move(pose, h * direction)) - energy(move(pose, -h * direction));
        };
        return (8 * difference(step) - difference(2 * step)) / (12 * step);
    };
    Vec3 force, moment;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 direction;
        direction[axis] = 1;
        force[axis] = -slope(moved, direction);
        moment[axis] = -slope(turned, direction);
    }
    return {force, moment};
}

inline void expect_near_vector(const Vec3& value, const Vec3& expected, double tolerance) {
    EXPECT_LE(norm(value - expected), tolerance);
}

/// Least |w_j n_j - w_l n_l| over max(w_j, w_l) of any two faces: how well the wall between two cells is known. About
/// the angle between the faces where they are nearly parallel.
inline double flattest_wall(const geometry::ConvexView& view, Potential potential) {
    double least = 2;
    for (int j = 0; j < view.face_count; ++j) {
        for (int l = 0; l < j; ++l) {
            const double wj = plain::weight(view, j, potential), wl = plain::weight(view, l, potential);
            least = std::min(least, norm(wj * view.normal(j) - wl * view.normal(l)) / std::max(wj, wl));
        }
    }
    return least;
}

/// Every column of a contact of the fast kernel against the oracle's, to a fraction of the size of that column.
/// The energy has terms on the walls between cells. A wall is the difference of two planes, so that round-off moves
/// it by epsilon over `wall` (see flattest_wall): four corners, four roundings each (gradient, offset, cut, lever).
inline void expect_same(const NormalContact& fast, const NormalContact& plain, double tolerance, double length,
                        double wall = 1) {
    const double force = norm(plain.force);
    const double of_walls = 16 * std::numeric_limits<double>::epsilon() / wall;
    expect_near_vector(fast.force, plain.force, tolerance * force);
    expect_near_vector(fast.point, plain.point, tolerance * length);
    expect_near_vector(fast.moment, plain.moment, tolerance * force * length);
    EXPECT_NEAR(fast.area, plain.area, tolerance * length * length);
    EXPECT_NEAR(fast.stiffness, plain.stiffness, tolerance * (1 + plain.stiffness));
    EXPECT_NEAR(fast.energy, plain.energy, std::max(tolerance, of_walls) * force * length);
    EXPECT_NEAR(fast.depth, plain.depth, tolerance * length);
    EXPECT_NEAR(fast.potential, plain.potential, tolerance);
}

inline void expect_near(const Vec3& value, const Vec3& expected, double tolerance, const char* what) {
    EXPECT_NEAR(value.x, expected.x, tolerance) << what;
    EXPECT_NEAR(value.y, expected.y, tolerance) << what;
    EXPECT_NEAR(value.z, expected.z, tolerance) << what;
}

}  // namespace riprap::contact::testing
