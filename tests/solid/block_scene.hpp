// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "riprap/solid/affine/make_blocks.hpp"
#include "solid/body_scene.hpp"

// Blocks in space of a scene of bodies, for tests of the engines of both methods.

namespace riprap::solid::affine {

/// A scene of bodies and the blocks made of them.
struct BlockScene : BlockSystem {
    BodyScene scene;
    Elasticity rock;
};

/// Density [kg/m^3], Young's modulus [Pa] and Poisson's ratio [-] of a test.
struct Rock {
    double density{2500}, youngs_modulus{5e10}, poisson_ratio{0.25};
};

/// Where a body is and how it moves. `deformation` may hold a rotation and a stretch.
struct NewBlock {
    Vec3 position{};
    Mat3 deformation{Mat3::identity()};
    Vec3 velocity{}, spin{};  ///< [m/s], [rad/s]
    bool is_fixed{false};
};

/// Makes the blocks of all bodies; what a test has set besides stays.
inline void make(BlockScene& system) {
    const BlockSystem before = system;
    system.scene.bodies.is_planar = before.is_planar;
    EXPECT_EQ(make_blocks(system.scene.scene(), system.rock, system), "");
    system.gravity = before.gravity;
    for (std::size_t k = 0; k < before.surfaces.pairs.size(); ++k) {
        const double found = system.surfaces.pairs[k].least_area, set = before.surfaces.pairs[k].least_area;
        system.surfaces.pairs[k] = before.surfaces.pairs[k];
        system.surfaces.pairs[k].least_area = set > 0 ? set : found;
    }
}

/// Sets the one material of all blocks.
inline void set_material(BlockScene& system, const Rock& rock, const Surface& surface) {
    system.scene.add_material({.name = "rock",
                               .density = rock.density,
                               .shear_ratio = 0,
                               .shear_stiffness = surface.shear_stiffness,
                               .friction = surface.friction,
                               .cohesion = surface.cohesion,
                               .tensile_strength = surface.tension,
                               .damping_ratio = surface.damping_ratio});
    system.rock = {rock.youngs_modulus, rock.poisson_ratio, surface.normal_stiffness};
    if (surface.is_per_area) {
        system.rock.stiffness_per_area = surface.normal_stiffness;
    }
    make(system);
    system.surfaces.pairs[0].least_area = surface.least_area;
}

inline void add_block(BlockScene& system, BlockState& state, ShapeId shape, const NewBlock& block) {
    const body::Drive drive = block.is_fixed ? body::Drive::fixed : body::Drive::free;
    system.scene.add({block.position, normalized(from_matrix(block.deformation))}, shape, drive);
    make(system);
    const Mat3 spin = cross_matrix(block.spin), zero{};
    state.position.push_back(block.position);
    state.velocity.push_back(block.velocity);
    state.deformation.insert(state.deformation.end(), block.deformation.row, block.deformation.row + 3);
    state.velocity_gradient.insert(state.velocity_gradient.end(), spin.row, spin.row + 3);
    state.stress.insert(state.stress.end(), zero.row, zero.row + 3);
}
inline void add_half_space(BlockScene& system, BlockState& state, const Vec3& normal, double offset) {
    add_block(system, state, system.scene.shapes.add_half_space(normal, offset), {.is_fixed = true});
}
inline void add_box(BlockScene& system, BlockState& state, const Vec3& size, const NewBlock& block) {
    add_block(system, state, system.scene.shapes.add_convex(geometry::box(size), false, nullptr), block);
}
/// Adds a polyhedron that is given in world axes.
inline void add_polyhedron(BlockScene& system, BlockState& state, const geometry::Polyhedron& shape, NewBlock block) {
    const ShapeId id = system.scene.shapes.add_convex(shape, system.is_planar, &block.position);
    add_block(system, state, id, block);
}

}  // namespace riprap::solid::affine
