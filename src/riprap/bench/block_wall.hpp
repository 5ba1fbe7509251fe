// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/sim/model.hpp"

namespace riprap::bench {

/// A wall of blocks of one rock on something that is fixed, as a case would have it.
struct BlockWall {
    sim::Model model;
    body::BodyState bodies;

    explicit BlockWall(double damping_ratio);
    void add(const Vec3& place, ShapeId shape, body::Drive drive = body::Drive::free);
};

/// Returns a wall of unit cubes in running bond on a half-space, pressed together by a thousandth, its joints closed.
BlockWall wall_of_cubes(int nx, int ny, int nz);

/// Returns a planar wall of bricks of 1 x 0.5 m in running bond on a fixed base.
BlockWall wall_of_bricks(int columns, int rows);

}  // namespace riprap::bench
