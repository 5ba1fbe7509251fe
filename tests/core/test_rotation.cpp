// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "riprap/core/quat.hpp"

namespace riprap {
namespace {

constexpr double pi = std::numbers::pi;
/// Entries of a product of two rotations carry some ten roundings of numbers up to 1.
constexpr double round_off = 16 * std::numeric_limits<double>::epsilon();

double largest(const Mat3& m) {
    double value = 0;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            value = std::max(value, std::abs(m(i, j)));
        }
    }
    return value;
}

class RandomRotations : public ::testing::Test {
 protected:
    Vec3 vector(double size) {
        std::uniform_real_distribution<double> coordinate(-1, 1);
        return size * Vec3{coordinate(random_), coordinate(random_), coordinate(random_)};
    }
    Quat rotation() { return from_rotation_vector(vector(3)); }

 private:
    std::mt19937_64 random_{3};
};

TEST(Rotation, AQuarterTurnAboutZTakesXToY) {
    const Quat q = from_rotation_vector({0, 0, pi / 2});
    EXPECT_NEAR(norm(rotate(q, {1, 0, 0}) - Vec3{0, 1, 0}), 0, 1e-15);
    EXPECT_NEAR(norm(rotate_back(q, {0, 1, 0}) - Vec3{1, 0, 0}), 0, 1e-15);
}

TEST(Rotation, AProductTurnsByItsRightFactorFirst) {
    const Quat about_x = from_rotation_vector({pi / 2, 0, 0}), about_z = from_rotation_vector({0, 0, pi / 2});
    EXPECT_NEAR(norm(rotate(about_z * about_x, {0, 1, 0}) - Vec3{0, 0, 1}), 0, 1e-15);
    EXPECT_NEAR(norm(rotate(about_x * about_z, {0, 1, 0}) - Vec3{-1, 0, 0}), 0, 1e-15);
}

TEST_F(RandomRotations, QuaternionAndMatrixTurnAlike) {
    for (int i = 0; i < 1000; ++i) {
        const Quat q = rotation();
        const Vec3 v = vector(10);
        ASSERT_NEAR(norm(rotate(q, v) - to_matrix(q) * v), 0, 1e-14);
        ASSERT_NEAR(norm(rotate_back(q, v) - transpose_times(to_matrix(q), v)), 0, 1e-14);
    }
}

TEST_F(RandomRotations, TheMatrixIsOrthonormalAndProper) {
    for (int i = 0; i < 1000; ++i) {
        const Mat3 r = to_matrix(rotation());
        ASSERT_LT(largest(r * transpose(r) - Mat3::identity()), round_off);
        ASSERT_NEAR(determinant(r), 1, round_off);
    }
}

TEST_F(RandomRotations, AMatrixGivesItsQuaternionBack) {
    for (int i = 0; i < 1000; ++i) {
        const Mat3 r = to_matrix(rotation());
        ASSERT_LT(largest(to_matrix(from_matrix(r)) - r), round_off);
    }
}

TEST(Rotation, HalfTurnsSurviveTheWayThroughAMatrix) {
    // Where w = 0 the other three components must carry the sign information alone.
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, normalized(Vec3{1, -2, 2})}) {
        const Mat3 r = to_matrix({0, axis.x, axis.y, axis.z});
        EXPECT_LT(largest(to_matrix(from_matrix(r)) - r), 1e-15);
    }
}

TEST(Rotation, ARotationVectorOfAnySizeComesBack) {
    const Vec3 axis = normalized(Vec3{2, -3, 6});
    for (const double angle : {1e-300, 1e-12, 1e-9, 0.999e-3, 1.001e-3, 0.1, 1.0, 3.0}) {
        const Quat q = from_rotation_vector(angle * axis);
        EXPECT_NEAR(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1, 1e-15) << angle;
        EXPECT_NEAR(norm(to_rotation_vector(q) - angle * axis), 0, 4e-16 * std::max(angle, 1.0) + 1e-15 * angle)
            << angle;
    }
}

TEST(Rotation, ATurnByMoreThanHalfAroundIsTheShorterTurnTheOtherWay) {
    const Vec3 back = to_rotation_vector(from_rotation_vector({0, 0, 2 * pi - 0.5}));
    EXPECT_NEAR(norm(back - Vec3{0, 0, -0.5}), 0, 1e-14);
}

TEST_F(RandomRotations, ToBodyUndoesToWorld) {
    for (int i = 0; i < 100; ++i) {
        const Pose pose{vector(5), rotation()};
        const Vec3 x = vector(2);
        ASSERT_NEAR(norm(to_body(pose, to_world(pose, x)) - x), 0, 1e-14);
    }
}

TEST_F(RandomRotations, AnInverseByCofactorsUndoesItsMatrix) {
    for (int i = 0; i < 100; ++i) {
        const Mat3 m = Mat3{{vector(1), vector(1), vector(1)}} + Mat3::diagonal({3, 3, 3});
        ASSERT_LT(largest(inverse(m) * m - Mat3::identity()), 1e-14);
    }
}

TEST_F(RandomRotations, PrincipalAxesRebuildTheTensorAndAreRightHanded) {
    for (int i = 0; i < 1000; ++i) {
        const Mat3 r = to_matrix(rotation());
        const Mat3 tensor = r * Mat3::diagonal({1, i % 2 == 0 ? 1.0 : 2.0, 50}) * transpose(r);  // half of them twofold
        const SymmetricEigen e = symmetric_eigen(tensor);
        ASSERT_LT(largest(e.axes * Mat3::diagonal(e.values) * transpose(e.axes) - tensor), 1e-12);
        ASSERT_LT(largest(e.axes * transpose(e.axes) - Mat3::identity()), 1e-14);
        ASSERT_NEAR(determinant(e.axes), 1, 1e-14);
    }
}

TEST(SymmetricEigen, ADiagonalTensorKeepsItsAxes) {
    const SymmetricEigen e = symmetric_eigen({{{3, 1e-15, 0}, {1e-15, 1, 0}, {0, 0, 2}}});
    EXPECT_EQ(e.axes, Mat3::identity());
    EXPECT_EQ(e.values, (Vec3{3, 1, 2}));
}

}  // namespace
}  // namespace riprap
