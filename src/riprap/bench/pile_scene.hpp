// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/sim/advance.hpp"

namespace riprap::bench {

/// A scene ready to be timed.
struct Pile {
    sim::Model model;
    sim::State state;
    double dt{0};  ///< time step that a run would choose from its stability bound [s]
};

/// Cubes of 1 mm near rest in a square box: dropped from a lattice of 13/7 mm with random orientations, friction
/// 0.4877, density 2500 kg/m^3, normal stiffness 1 MPa. Settles them with damping and soft contacts, then removes the
/// damping and restores the stiffness; the same bits every time.
Pile drop_cubes(int cubes_x, int cubes_y, int layers);

/// The 735 cubes of [Zhao, 5.5] in their box of 13 x 13 mm: drop_cubes(7, 7, 15), made once and kept.
const Pile& settled_cubes();

/// Blocks of 18 shared shapes (tetrahedron, cube, hexagonal prism, octahedron, dodecahedron, random hull, each with
/// circumradius 0.5, 1 and 2 mm) at rest in a box. One bed of 1000 blocks is settled as above between walls, once;
/// its copies are set side by side without the walls between them, tiles_x by tiles_y of them.
Pile mixed_bed(int tiles_x, int tiles_y);

/// A Voronoi pack of blocks that fills a box, joints closed, each block of its own shape, under gravity.
Pile voronoi_pack(std::int64_t block_count);

/// Steps `pile` on; throws InternalError with the reason when a step is refused.
sim::StepReport advance(Pile& pile, sim::Scratch& scratch, int steps);

}  // namespace riprap::bench
