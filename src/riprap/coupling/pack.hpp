// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/coupling/fill.hpp"
#include "riprap/coupling/samples/sample_set.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"

namespace riprap::coupling {

/// Distance from the middle of a cell that a face cuts within which particles are packed: 5 dp [m].
double packed_depth(const fluid::ParticleSettings& settings);

/// Tells what packing leaves.
struct Packed {
    /// By how much the count of the neighbours of each particle, sum V W with itself, air and boundary particles, falls
    /// short of that of the lattice, over it [-]; 0 far from what was packed.
    std::vector<double> lack;
    int sweeps{0};         ///< that it took
    double unevenness{0};  ///< largest |sum V grad W| dp in the last of them [-]
};

/// Packs the particles beside faces that the lattice does not follow [Colagrossi2012]: those within packed_depth() of
/// a cell of water that a face cuts move down the gradient of the count of their neighbours,
///
///     d_i <- m d_i - s sum_j V grad W_ij,   |d_i| <= dp/10,   x_i += d_i,
///
/// with m = 0.85, W Wendland's kernel over the support of the scheme and s = 3 times the move that ends the stiffest
/// wave of the lattice at once, until |sum V grad W| dp along faces is below 1e-4
/// everywhere or its mean falls by less than 15 % in 20 sweeps. Where the sum is zero an even pressure holds its
/// particles at rest, in every scheme. Boundary particles count with their volumes and stay. So does the air beside the
/// water (Filling::air), but for what is near both water and such a face, which moves like water: the surface stays
/// where it is. Of a tank that the lattice fits but for its depth the last layer is packed so, under air that stays.
/// Puts back to that distance, in each sweep, what comes nearer to a face than `fill` allows, and in the end what is
/// out of its region to the side where it left: openings are at the edges of regions.
///
/// Differs from the source: the lattice stays where it fits, and moves keep a share of the last one in place of a drag.
Packed pack(const geometry::ShapeSet& shapes, const body::BodySet& bodies, const body::BodyState& initial,
            const fluid::ParticleSettings& settings, const SampleSet& samples, std::span<const FillRegion> regions,
            Filling& filling);

}  // namespace riprap::coupling
