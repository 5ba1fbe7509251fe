// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/block_wall.hpp"

#include <array>

#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::bench {

BlockWall::BlockWall(double damping_ratio) {
    model.materials.materials.push_back(
        {.name = "rock", .density = 2500, .friction = 0.6, .damping_ratio = damping_ratio});
}

void BlockWall::add(const Vec3& place, ShapeId shape, body::Drive drive) {
    body::NewBody block;
    block.name = "block";
    block.name_index = model.bodies.size();
    block.material = MaterialId{0};
    block.density = model.materials.materials[0].density;
    block.drive = drive;
    block.pose = {place, {}};
    block.parts = {{BodyId{}, shape, Pose{}}};
    body::add_body(model.bodies, bodies, model.shapes, block);
}

namespace {

/// Gives the wall its ratio of tangential to normal stiffness.
void set_shear_ratio(double ratio, BlockWall& wall) {
    wall.model.materials.materials[0].shear_ratio = ratio;
    material::mix_pairs(wall.model.materials, material::Mixing::mean, material::Mixing::mean);
}

}  // namespace

BlockWall wall_of_cubes(int nx, int ny, int nz) {
    BlockWall wall(0);
    set_shear_ratio(1, wall);
    wall.model.gravity.value = {0, 0, -9.81};
    wall.add({}, wall.model.shapes.add_half_space({0, 0, 1}, 0), body::Drive::fixed);
    const ShapeId cube = wall.model.shapes.add_convex(geometry::box({1, 1, 1}));
    const double gap = 0.999;
    for (int k = 0; k < nz; ++k) {
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                wall.add({gap * (i + 0.5 * (k % 2)), gap * j, 0.4995 + gap * k}, cube);
            }
        }
    }
    return wall;
}

BlockWall wall_of_bricks(int columns, int rows) {
    BlockWall wall(0.2);
    set_shear_ratio(0.4, wall);
    wall.model.bodies.is_planar = true;
    wall.model.gravity.value = {0, -9.81, 0};
    const auto brick_of = [&wall](double width, double height) {
        const double x = 0.5 * width, y = 0.5 * height;
        const std::array<geometry::Point2, 4> corners{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
        return wall.model.shapes.add_convex(geometry::planar_prism(corners).value(), true);
    };
    wall.add({0.5 * columns, -0.5, 0}, brick_of(columns + 2, 1), body::Drive::fixed);
    const ShapeId brick = brick_of(1, 0.5);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            wall.add({column + 0.5 * (row % 2) + 0.5, 0.5 * row + 0.25, 0}, brick);
        }
    }
    return wall;
}

}  // namespace riprap::bench
