// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "riprap/solid/explicit_dda/advance.hpp"
#include "riprap/solid/implicit_dda/advance.hpp"
#include "solid/block_scene.hpp"
#include "solid/planar_dda/blocks.hpp"

// One scene of polygons for the three methods of discontinuous deformation analysis.

namespace riprap::solid {

enum class Dda { planar, implicit, explicit_ };

inline std::string name_of(const ::testing::TestParamInfo<Dda>& info) {
    return info.param == Dda::planar ? "planar" : info.param == Dda::implicit ? "implicit" : "explicit";
}

using Corners = std::vector<geometry::Point2>;

inline Corners box(double left, double low, double width, double height) {
    return {{left, low}, {left + width, low}, {left + width, low + height}, {left, low + height}};
}

/// A polygon, one metre thick.
struct Piece {
    Corners corners;
    bool is_fixed{true};
    double speed{0};  ///< along x [m/s]
};

struct Scene {
    std::vector<Piece> pieces;
    double stiffness{1e8}, friction{0};  ///< of a contact point [N/m], [-]
    geometry::Vec2 gravity{0, -9.81};    ///< [m/s^2]
    double dt{1e-3}, end{0.3};           ///< step of the implicit methods, end [s]
    double youngs_modulus{1e9};          ///< [Pa]
};

/// How the last piece ends.
struct Ending {
    geometry::Vec2 moved, velocity;
};

inline Ending slide_in_the_plane(const Scene& scene) {
    planar_dda::Blocks blocks(
        {.normal_stiffness = scene.stiffness, .shear_stiffness = 0.4 * scene.stiffness, .friction = scene.friction},
        {2500, scene.youngs_modulus, 0.25});
    for (const Piece& piece : scene.pieces) {
        std::vector<planar_dda::Vec2> corners;
        for (const geometry::Point2& p : piece.corners) {
            corners.push_back({p[0], p[1]});
        }
        const std::int32_t block = blocks.add(corners, piece.is_fixed);
        blocks.state.rates[6 * static_cast<std::size_t>(block)] = piece.speed;
    }
    blocks.settings.displacement_limit = 0.05;
    blocks.settings.close_tolerance = blocks.settings.open_tolerance = 1e-11;
    const std::size_t last = blocks.state.x.size() - 1;
    const planar_dda::Vec2 start{blocks.state.x[last], blocks.state.y[last]};
    blocks.run(static_cast<int>(scene.end / scene.dt + 0.5), scene.dt, {scene.gravity.x, scene.gravity.y});
    return {{blocks.state.x[last] - start.x, blocks.state.y[last] - start.y},
            {blocks.state.rates[6 * last], blocks.state.rates[6 * last + 1]}};
}

inline Ending slide_in_space(const Scene& scene, bool is_explicit) {
    affine::BlockScene system;
    affine::BlockState blocks;
    set_material(system, {2500, scene.youngs_modulus, 0.25},
                 {scene.stiffness, 0.4 * scene.stiffness, false, scene.friction});
    system.gravity = {scene.gravity.x, scene.gravity.y, 0};
    for (const Piece& piece : scene.pieces) {
        add_polyhedron(system, blocks, geometry::planar_prism(piece.corners).value(),
                       {.velocity = {piece.speed, 0, 0}, .is_fixed = piece.is_fixed});
    }
    const Vec3 start = blocks.position.back();
    Vec3 place = start, velocity{};
    if (is_explicit) {
        explicit_dda::State state{blocks, {}, 0};
        explicit_dda::Scratch scratch;
        explicit_dda::StepReport report;
        const double dt = 0.5 * explicit_dda::stable_step(system, blocks);
        for (double t = 0; t < scene.end; t += dt) {
            EXPECT_EQ(explicit_dda::advance(system, {}, dt, {}, state, scratch, report).problem, "");
        }
        place = state.blocks.position.back();
        velocity = state.blocks.velocity.back();
    } else {
        implicit_dda::State state{blocks, {}};
        implicit_dda::Scratch scratch;
        implicit_dda::StepReport report;
        for (int k = 0; k < static_cast<int>(scene.end / scene.dt + 0.5); ++k) {
            const Outcome outcome = in_pieces(scene.dt, [&](double piece) {
                return implicit_dda::advance(system, {}, piece, {}, state, scratch, report);
            });
            EXPECT_EQ(outcome.problem, "");
        }
        place = state.blocks.position.back();
        velocity = state.blocks.velocity.back();
    }
    return {{place.x - start.x, place.y - start.y}, {velocity.x, velocity.y}};
}

inline Ending slide(Dda method, const Scene& scene) {
    return method == Dda::planar ? slide_in_the_plane(scene) : slide_in_space(scene, method == Dda::explicit_);
}

}  // namespace riprap::solid
