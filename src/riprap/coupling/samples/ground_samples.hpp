// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/body/ground.hpp"
#include "riprap/coupling/samples/sample_shapes.hpp"

namespace riprap::coupling {

/// A box that samples may lie in [m].
struct SampleBox {
    Vec3 low, high;
};

/// Boundary particles of ground (body/ground.hpp): the cells of the water's lattice that lie in the solid, down to
/// `reach` below the surface. A cell that the surface cuts stands with the share of its volume that is solid, at the
/// middle of that share, so that sums over the samples see the surface where it is, whatever its slope, and a lattice
/// of water over a level bed is continued exactly. Shares are counted at points within the cell, below the plane of the
/// nearest place of the surface; a crease is rounded off within a spacing.
/// @throws CaseError  when more than `limit` samples would be made
void sample_ground(const body::Ground& ground, const Pose& pose, const SampleBox& box, bool is_planar,
                   const SampleSettings& settings, SampleSet& samples);

}  // namespace riprap::coupling
