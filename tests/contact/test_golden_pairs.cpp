// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/contact/narrowphase/distance_potential.hpp"
#include "riprap/core/quat.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::contact {
namespace {

Quat turn(const Vec3& axis, double angle) { return from_rotation_vector(angle * normalized(axis)); }

/// One pair of bodies with its energy, force and moment about the centre of A, from exact clipping by other means.
struct Golden {
    const char* name;
    geometry::Polyhedron a, b;
    Pose pose_a;
    double energy;
    Vec3 force, moment;
};

std::array<Golden, 4> golden_pairs() {
    const auto cube = geometry::cube(1);
    return {{
        {"T1",
         cube,
         cube,
         {{0.2, 0.1, 0.9}, {}},
         0.0133,
         {0.0173333333333, 0.0153333333333, 0.2553333333333},
         {-0.0058666666667, 0.0177333333333, -0.0006666666667}},
        {"T2",
         cube,
         cube,
         {{0.1, 0.05, 1.05}, turn({1, 1, 0}, M_PI / 6)},
         0.00391081523410,
         {0.0014100194, 0, 0.0652695015},
         {-0.0082576783, -0.0091733908, 0.0002790609}},
        {"T3",
         geometry::regular_tetrahedron(1),
         geometry::box({2, 1, 0.5}),
         {{0.3, 0.1, 0.45}, turn({1, 2, 3}, 0.7)},
         0.00665091276072,
         {0, 0, 0.0810017635},
         {-0.0015770415, -0.0061905956, 0}},
        {"T4", cube, cube, {{0, 0, 0.99}, {}}, 1.97346666667e-4, {0, 0, 0.0392053333333}, {}},
    }};
}

/// Force on A, its moment about the centre of A, and the energy of one pair with k_n = 1 Pa.
struct Wrench {
    double energy{0};
    Vec3 force{}, moment{};
};

/// f'(0) by Richardson's extrapolation of central differences.
template <class F>
double derivative(const F& f, double h) {
    const double coarse = (f(h) - f(-h)) / (2 * h), fine = (f(0.5 * h) - f(-0.5 * h)) / h;
    return (4 * fine - coarse) / 3;
}

class PairProbe {
 public:
    PairProbe(const geometry::Polyhedron& a, const geometry::Polyhedron& b)
        : a_(shapes_.add_convex(a)), b_(shapes_.add_convex(b)) {}

    Wrench at(const Pose& pose_a) const {
        SeparatingCache cache;
        NormalContact contact{};
        if (!find_contact(shapes_.view(a_), to_frame(pose_a), 1.0, shapes_.view(b_), to_frame(Pose{}), 1.0, {}, cache,
                          contact)) {
            return {};
        }
        return {contact.energy, contact.force, contact.moment + cross(contact.point - pose_a.position, contact.force)};
    }

    /// Largest component of force + dE/dx and moment + dE/dtheta. Central differences of steps h and h/2 are combined
    /// to fourth order: the second-order error, h^2/6 times the third derivative, would itself be 3e-8 for two cubes.
    double gradient_error(const Pose& pose, double h) const {
        const Wrench wrench = at(pose);
        double error = 0;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 unit{};
            unit[axis] = 1;
            const auto along = [&](double s) { return at({pose.position + s * unit, pose.orientation}).energy; };
            const auto about = [&](double s) {
                return at({pose.position, from_rotation_vector(s * unit) * pose.orientation}).energy;
            };
            error = std::max({error, std::abs(derivative(along, h) + wrench.force[axis]),
                              std::abs(derivative(about, h) + wrench.moment[axis])});
        }
        return error;
    }

 private:
    geometry::ShapeSet shapes_;
    ShapeId a_, b_;
};

double largest_difference(const Vec3& a, const Vec3& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

// Tables of ten digits, so 1e-9; and the force is the gradient of the energy.
TEST(GoldenPairs, HaveTheEnergyForceAndMomentOfExactClipping) {
    for (const Golden& golden : golden_pairs()) {
        SCOPED_TRACE(golden.name);
        const PairProbe probe(golden.a, golden.b);
        const Wrench wrench = probe.at(golden.pose_a);
        EXPECT_NEAR(wrench.energy, golden.energy, 1e-9);
        EXPECT_LE(largest_difference(wrench.force, golden.force), 1e-9);
        EXPECT_LE(largest_difference(wrench.moment, golden.moment), 1e-9);
        EXPECT_LE(probe.gradient_error(golden.pose_a, 1e-4), 1e-8);
    }
}

}  // namespace
}  // namespace riprap::contact
