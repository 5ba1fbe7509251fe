// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/registry.hpp"

#include <array>

#include "riprap/bench/benches.hpp"

namespace riprap::bench {

std::span<const Bench> all_benches() {
    static constexpr std::array benches{
        Bench{"machine", "Memory bandwidth and peak of fused multiply-add", false, machine},
        Bench{"contact.cube_cube", "Touching pair of cubes, both sides, force and moment", false, contact_cube_cube},
        Bench{"contact.with_energy", "The same with the elastic energy", false, contact_with_energy},
        Bench{"contact.cached_miss", "Candidate pair of cubes that does not touch, seen before", false,
              contact_cached_miss},
        Bench{"pile.735_cubes", "735 cubes at rest in a box", false, pile_735_cubes},
        Bench{"pile.1k", "1000 mixed blocks settling", false, pile_1k},
        Bench{"pile.10k", "10 000 mixed blocks settling", false, pile_10k},
        Bench{"pile.100k", "100 000 mixed blocks settling", true, pile_100k},
        Bench{"pile.voronoi", "Blocks of a Voronoi pack, each of its own shape", false, pile_voronoi},
        Bench{"spheres.10k", "10 000 spheres at rest in a box, Hertz and Mindlin with history", false, spheres_10k},
        Bench{"spheres.100k", "100 000 spheres at rest in a box, Hertz and Mindlin with history", false, spheres_100k},
        Bench{"broadphase.slope", "Search for candidate pairs against the number of bodies", false, broadphase_slope},
        Bench{"grid.dambreak", "Water and air on a grid, dam break over an obstacle", false, grid_dambreak},
        Bench{"sph.h1732", "Water by SPH, smoothing length of 1.732 spacings", false, sph_h1732},
        Bench{"sph.h12", "Water by SPH, smoothing length of 1.2 spacings", false, sph_h12},
        Bench{"water.schemes", "Water by delta_sph, wcmps and mps: a particle-step, a simulated second", false,
              water_schemes},
        Bench{"step.dam_break", "Whole steps: a dam break on a box", false, step_dam_break},
        Bench{"step.floes", "Whole steps: a dam break carries floating blocks", false, step_floes},
        Bench{"step.rubble", "Whole steps: 3000 blocks, a third of them in water", false, step_rubble},
        Bench{"step.slide", "Whole steps: 500 blocks slide into water", false, step_slide},
        Bench{"dda.implicit_3400", "Implicit 3D-DDA: a wall of 3400 blocks", false, dda_implicit_3400},
        Bench{"dda.explicit", "Explicit 3D-DDA: walls of 1000 and 8000 blocks", false, dda_explicit},
        Bench{"dda.explicit_100k", "Explicit 3D-DDA: walls of 8000 and 97336 blocks", true, dda_explicit_100k},
        Bench{"linear.product", "Block-sparse matrix times vector, against the bandwidth", false, linear_product},
        Bench{"linear.pcg", "Conjugate gradients by preconditioner", false, linear_pcg},
        Bench{"dda.planar", "Step of a wall of bricks by planar DDA", false, dda_planar},
    };
    return benches;
}

}  // namespace riprap::bench
