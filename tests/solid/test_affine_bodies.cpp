// SPDX-License-Identifier: Apache-2.0
// Bodies that loads do not move, as both three-dimensional DDAs meet them: half-spaces where their bodies are, and
// blocks that are released.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "riprap/solid/explicit_dda/explicit_dda.hpp"
#include "riprap/solid/implicit_dda/implicit_dda.hpp"
#include "solid/body_scene.hpp"

namespace riprap::solid {
namespace {

template <class Method>
struct Scene : MovedScene<Method> {
    double dt{5e-4};

    SolidReport step() {
        SolidReport report;
        EXPECT_EQ(this->advance(dt, report).problem, "");
        this->time += dt;
        return report;
    }
};

template <class Method>
class AffineBodies : public ::testing::Test {};
using Methods = ::testing::Types<ImplicitDda, ExplicitDda>;
TYPED_TEST_SUITE(AffineBodies, Methods);

TYPED_TEST(AffineBodies, AHalfSpaceIsWhereItsBodyIs) {
    // The same floor by its offset, and by position and orientation of its body; the whole turned by 30 degrees.
    const Quat turn = from_rotation_vector({0, std::numbers::pi / 6, 0});
    Scene<TypeParam> plain, turned;
    plain.add({}, plain.shapes.add_half_space({0, 0, 1}, -0.6), body::Drive::fixed);
    plain.add_cube({});
    turned.add({rotate(turn, {0, 0, -0.6}), turn}, turned.shapes.add_half_space({0, 0, 1}, 0), body::Drive::fixed);
    turned.add_cube({{}, turn});
    turned.gravity = {rotate(turn, {0, 0, -9.81})};
    double lowest = 0;
    for (int i = 0; i < 600; ++i) {
        plain.step();
        turned.step();
        lowest = std::min(lowest, plain.state.position[1].z);
    }
    EXPECT_LT(lowest, -0.1);   // it falls
    EXPECT_GT(lowest, -0.13);  // until the floor throws it back
    EXPECT_LT(norm(turned.state.position[1] - rotate(turn, plain.state.position[1])), 1e-9);
}

TYPED_TEST(AffineBodies, ABodyWithADensityOfItsOwnHasItsMassAndInertia) {
    Scene<TypeParam> scene;
    scene.add({}, scene.shapes.add_convex(geometry::cube(1), false, nullptr), body::Drive::free, INFINITY, 500);
    scene.state.angular_momentum[0] = {0, 0, 500.0 / 6};  // 1 rad/s
    const SolidReport report = scene.step();
    EXPECT_NEAR(report.kick.mass, 500, 1e-9);
    EXPECT_NEAR(scene.state.angular_momentum[0].z, 500.0 / 6, 1e-6);
    const double turned = scene.state.orientation[0].z;
    EXPECT_NEAR(2 * turned, scene.dt, 1e-9);
}

/// A block tips over the edge of a table by 52 parts of its length in a hundred.
/// @returns how far it has turned after the same number of steps
double tipped(double scale) {
    Scene<ImplicitDda> scene;
    scene.bodies.is_planar = true;
    scene.gravity = body::Gravity{{0, -9.81, 0}};
    scene.settings.elasticity = {1e8 * scale, 0.25, 1e7 * scale};
    scene.dt = 2e-4 * std::sqrt(scale);
    const auto prism = [&](double width, double height) {
        const double x = 0.5 * scale * width, y = 0.5 * scale * height;
        const std::array<geometry::Point2, 4> corners{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
        return scene.shapes.add_convex(geometry::planar_prism(corners).value(), true, nullptr);
    };
    scene.add({{-scale, -0.5 * scale, 0}, {}}, prism(2, 1), body::Drive::fixed);
    scene.add({{0.02 * scale, 0.25 * scale, 0}, {}}, prism(1, 0.5), body::Drive::free);
    for (int i = 0; i < 3000; ++i) {
        scene.step();
    }
    return 2 * scene.state.orientation[1].z;
}

TEST(ImplicitDdaMethod, APlanarSceneIsTheSameAtAThousandthOfItsSize) {
    const double turned = tipped(1);
    EXPECT_LT(turned, -0.1);
    EXPECT_NEAR(tipped(1e-3), turned, 1e-2 * -turned);
}

TYPED_TEST(AffineBodies, ABlockIsHeldOnceItIsReleased) {
    Scene<TypeParam> scene;
    scene.add_cube({{0, 0, -0.5}, {}}, body::Drive::fixed);
    scene.add_cube({{0, 0, 0.5}, {}}, body::Drive::fixed, 0.01);
    KickReport sum;
    int count = 0;
    double energy = 0;
    for (int i = 0; i < 400; ++i) {
        const SolidReport report = scene.step();
        sum.released_mass_moment += report.kick.released_mass_moment;
        energy += report.kick.released_energy;
        count += report.kick.released_mass_moment.z != 0 ? 1 : 0;
    }
    EXPECT_EQ(count, 1);
    EXPECT_NEAR(energy, 2000 * 9.81 * 0.5, 5);
    EXPECT_NEAR(sum.released_mass_moment.z, 2000 * 0.5, 1);
    EXPECT_LT(scene.state.position[1].z, 0.5);
    EXPECT_GT(scene.state.position[1].z, 0.49);
}

TYPED_TEST(AffineBodies, ScratchMayBeDroppedAcrossARelease) {
    const auto run = [](bool is_dropped) {
        Scene<TypeParam> scene;
        scene.add_cube({{0, 0, -0.5}, {}}, body::Drive::fixed);
        scene.add_cube({{0.1, 0, 0.5}, {}}, body::Drive::fixed, 0.0101);
        for (int i = 0; i < 60; ++i) {
            if (is_dropped) {
                scene.scratch = {};
            }
            scene.step();
        }
        return scene.fields;
    };
    EXPECT_TRUE(run(false) == run(true));
}

}  // namespace
}  // namespace riprap::solid
