// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "riprap/coupling/fill_lattice.hpp"
#include "riprap/coupling/fill_solids.hpp"

// Raises the surface of a region by what the lattice leaves out beside solids. Places keep a quarter of a spacing from
// faces, so water over a slope lacks a quarter of a layer on the average, and beside a wall that no cell follows up to
// three quarters; what is there then settles below the level asked for.

namespace riprap::coupling {

/// Moves the surfaces of regions until as many cells are filled as there is room below the surface asked for, to one
/// particle; by a layer at most. Cells count that are filled or share a face with one that is, as no particle gets into
/// narrower gaps; of a cell beside solids the share of 64 points counts, spread evenly over neighbouring cells, that
/// lies in no solid, and in the last layer what is below the surface. Regions whose lattice fits are left as they are.
/// @param distance  that places keep from solids [m]
/// @param reports  get the room of each region
/// @return  true where a surface has moved
bool raise_to_volume(std::span<RegionPlanes> regions, const fluid::ParticleSettings& settings, const Vec3& corner,
                     const FillSolids& solids, const Vec3& up, double distance, std::span<FillReport> reports);

}  // namespace riprap::coupling
