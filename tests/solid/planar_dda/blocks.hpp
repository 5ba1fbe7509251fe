// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "riprap/geometry/planar/convex_pieces.hpp"
#include "riprap/solid/planar_dda/make_blocks.hpp"
#include "riprap/solid/planar_dda/step.hpp"
#include "solid/body_scene.hpp"

namespace riprap::solid::planar_dda {

/// Springs and strength of the contacts of a test; see affine::Surface.
struct Joint {
    double normal_stiffness{1e9}, shear_stiffness{4e8};
    double friction{0}, cohesion{0}, tension{0}, damping_ratio{0};
};

/// Rock of a test: density [kg/m^3], Young's modulus [Pa], Poisson's ratio [-].
struct Material {
    double density{2500}, youngs_modulus{5e10}, poisson_ratio{0.25};
};

/// Settings for a scene with the half extent w0 [m] when corners may move by `displacement_ratio` w0 in a step.
inline Settings settings_for(double half_extent, double displacement_ratio = 0.005) {
    Settings settings;
    settings.displacement_limit = displacement_ratio * half_extent;
    settings.close_tolerance = settings.open_tolerance = 1e-11 * half_extent;
    settings.multiplier_tolerance = 1e-10 * half_extent;
    return settings;
}

/// Bodies of a planar scene, the blocks made of them, and what advances them.
struct Blocks {
    BodyScene scene;
    affine::Elasticity rock;
    PlaneState plane{PlaneState::stress};
    Model model;
    State state;
    Settings settings{settings_for(10)};
    Scratch scratch;
    StepReport report;
    std::vector<Unknowns> loads;  ///< per block; empty = none
    std::vector<SceneProblem> problems;

    explicit Blocks(const Joint& joint = {}, const Material& material = {}) {
        scene.bodies.is_planar = true;
        scene.add_material({.name = "rock",
                            .density = material.density,
                            .shear_ratio = 0,
                            .shear_stiffness = joint.shear_stiffness,
                            .friction = joint.friction,
                            .cohesion = joint.cohesion,
                            .tensile_strength = joint.tension,
                            .damping_ratio = joint.damping_ratio});
        rock = {material.youngs_modulus, material.poisson_ratio, joint.normal_stiffness};
    }
    /// Adds a body with its corners in place, of convex parts where it is concave.
    std::int32_t add(const std::vector<Vec2>& corners, bool is_fixed = false) {
        std::vector<body::Part> parts;
        for (const geometry::Polygon& piece : geometry::convex_pieces(geometry::make_polygon(corners).value())) {
            std::vector<geometry::Point2> points;
            for (const Vec2& p : piece) {
                points.push_back({p.x, p.y});
            }
            Vec3 centroid;
            const ShapeId shape = scene.add_prism(points, &centroid);
            parts.push_back({BodyId{}, shape, Pose{centroid, {}}});
        }
        scene.add({}, parts, is_fixed ? body::Drive::fixed : body::Drive::free);
        make();
        return model.block_count() - 1;
    }
    std::int32_t add_box(const Vec2& low, const Vec2& size, bool is_fixed = false) {
        return add({low, {low.x + size.x, low.y}, low + size, {low.x, low.y + size.y}}, is_fixed);
    }
    /// Makes the blocks of all bodies; those that were there before stay as the test has moved them.
    void make() {
        SceneBlocks made = make_blocks(scene.scene(), scene.state, {}, rock, plane);
        model = std::move(made.model);
        problems = std::move(made.problems);
        const auto keep = [](std::vector<double>& before, std::vector<double>& now) {
            now.erase(now.begin(), now.begin() + static_cast<std::ptrdiff_t>(before.size()));
            before.insert(before.end(), now.begin(), now.end());
        };
        keep(state.x, made.state.x);
        keep(state.y, made.state.y);
        keep(state.angle, made.state.angle);
        keep(state.stretch_xx, made.state.stretch_xx);
        keep(state.stretch_yy, made.state.stretch_yy);
        keep(state.stretch_xy, made.state.stretch_xy);
        keep(state.rates, made.state.rates);
        keep(state.stress_x, made.state.stress_x);
        keep(state.stress_y, made.state.stress_y);
        keep(state.stress_xy, made.state.stress_xy);
    }
    Outcome step(double dt, const Vec2& gravity = {}) {
        return advance(model, settings, {dt, gravity, loads, {}}, state, scratch, report);
    }
    /// Takes `count` steps; false when one is refused.
    bool run(int count, double dt, const Vec2& gravity = {}) {
        for (int k = 0; k < count; ++k) {
            if (const Outcome outcome = step(dt, gravity); !outcome.ok()) {
                ADD_FAILURE() << "step " << k << ": " << outcome.problem;
                return false;
            }
        }
        return true;
    }
};

}  // namespace riprap::solid::planar_dda
