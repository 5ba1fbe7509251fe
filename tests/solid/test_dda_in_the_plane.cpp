// SPDX-License-Identifier: Apache-2.0
// Plane scenes of both DDAs in space: nothing moves blocks out of the plane.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "riprap/solid/explicit_dda/advance.hpp"
#include "riprap/solid/implicit_dda/advance.hpp"
#include "solid/block_scene.hpp"

namespace riprap::solid {
namespace {

constexpr double degree = std::numbers::pi / 180, g = 9.81;

/// A slope with prisms on it, in the axes of the slope.
struct PlaneScene {
    affine::BlockScene system;
    affine::BlockState blocks;

    PlaneScene(double angle, double size, double friction) {
        // An overlap of some 1e-4 of the size, whatever it is.
        const double stiffness = 2500 * size * size * g / (1e-4 * size);
        set_material(system, {2500, 1e9, 0.25}, {stiffness, 0.4 * stiffness, false, friction, 0, 0, 0.2});
        system.is_planar = true;
        system.gravity = g * Vec3{std::sin(angle), -std::cos(angle), 0};
        add_box(system, blocks, {40 * size, size, 1}, {.position = {15 * size, -0.5 * size, 0}, .is_fixed = true});
    }
    void add(const std::vector<geometry::Point2>& corners) {
        add_polyhedron(system, blocks, geometry::planar_prism(corners).value(), {});
    }
    void add_box_at(double left, double low, double width, double height) {
        add({{left, low}, {left + width, low}, {left + width, low + height}, {left, low + height}});
    }
    void add_roller(double radius, int corners) {
        std::vector<geometry::Point2> points;
        for (int k = 0; k < corners; ++k) {
            const double turn = 2 * std::numbers::pi * (k + 0.5) / corners;
            points.push_back(
                {radius * std::sin(turn), radius * std::cos(std::numbers::pi / corners) - radius * std::cos(turn)});
        }
        add(points);
    }
    affine::BlockState after(double end, double dt, bool is_explicit) const {
        if (is_explicit) {
            explicit_dda::State state{blocks, {}, 0};
            explicit_dda::Scratch scratch;
            explicit_dda::StepReport report;
            const double stable = 0.5 * explicit_dda::stable_step(system, blocks);
            for (double t = 0; t < end; t += stable) {
                EXPECT_EQ(explicit_dda::advance(system, {}, stable, {}, state, scratch, report).problem, "");
            }
            return state.blocks;
        }
        implicit_dda::State state{blocks, {}};
        implicit_dda::Scratch scratch;
        implicit_dda::StepReport report;
        for (int k = 0; k < static_cast<int>(end / dt + 0.5); ++k) {
            const Outcome outcome = in_pieces(
                dt, [&](double piece) { return implicit_dda::advance(system, {}, piece, {}, state, scratch, report); });
            EXPECT_EQ(outcome.problem, "");
        }
        return state.blocks;
    }
};

void expect_in_plane(const affine::BlockState& blocks, const affine::BlockState& before) {
    for (std::size_t b = 0; b < blocks.position.size(); ++b) {
        EXPECT_EQ(blocks.position[b].z, before.position[b].z) << b;
        EXPECT_EQ(blocks.velocity[b].z, 0) << b;
        for (const auto* rows : {&blocks.deformation, &blocks.velocity_gradient, &blocks.stress}) {
            const Mat3 m = affine::rows_at(*rows, b);
            EXPECT_EQ(std::abs(m(0, 2)) + std::abs(m(1, 2)) + std::abs(m(2, 0)) + std::abs(m(2, 1)), 0) << b;
        }
    }
}

class DdaInThePlane : public ::testing::TestWithParam<bool> {};

TEST_P(DdaInThePlane, RollersRollDownSlopesWithoutLeavingThePlane) {
    // a = g sin(angle)/(1 + 1/2); a polygon starts from a flat side and loses a little at each corner.
    for (const double radius : {0.05, 0.25}) {
        for (const double angle : {10 * degree, 20 * degree, 30 * degree}) {
            SCOPED_TRACE(fmt::format("{} m, {:.0f} degrees", radius, angle / degree));
            PlaneScene scene(angle, radius, 0.6);
            scene.add_roller(radius, 180);
            const double end = std::sqrt(radius), start = scene.blocks.position[1].x;
            const affine::BlockState blocks = scene.after(end, 1e-3 * end, GetParam());
            const double way = g * std::sin(angle) / 3 * end * end;
            EXPECT_NEAR(blocks.position[1].x - start, way, 0.05 * way);
            EXPECT_NEAR(blocks.position[1].y, radius, 0.02 * radius);
            expect_in_plane(blocks, scene.blocks);
        }
    }
}

TEST_P(DdaInThePlane, AStackOnASlopeStaysInThePlane) {
    PlaneScene scene(15 * degree, 0.5, 0.7);
    for (int k = 0; k < 4; ++k) {
        scene.add_box_at(0.01 * k, 0.3 * k, 1, 0.3);
    }
    const affine::BlockState blocks = scene.after(0.5, 1e-3, GetParam());
    for (std::size_t b = 1; b < 5; ++b) {
        EXPECT_NEAR(blocks.position[b].x, scene.blocks.position[b].x, 2e-3) << b;
    }
    expect_in_plane(blocks, scene.blocks);
}

TEST_P(DdaInThePlane, ABoxThatTumblesDownASlopeStaysInThePlane) {
    PlaneScene scene(35 * degree, 0.5, 0.9);
    scene.add_box_at(0, 0.3, 0.3, 0.6);
    const affine::BlockState blocks = scene.after(1, 1e-3, GetParam());
    expect_in_plane(blocks, scene.blocks);
    EXPECT_LT(affine::rows_at(blocks.deformation, 1)(0, 0), 0.7);  // it has turned over its corner
}

INSTANTIATE_TEST_SUITE_P(Methods, DdaInThePlane, ::testing::Bool(),
                         [](const auto& method) { return method.param ? "explicit" : "implicit"; });

}  // namespace
}  // namespace riprap::solid
