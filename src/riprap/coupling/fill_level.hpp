// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "riprap/coupling/fill_lattice.hpp"
#include "riprap/coupling/fill_solids.hpp"

// Raises the surface of a region by what the lattice leaves out beside solids. Places keep a quarter of a spacing from
// faces, so water over a slope lacks a quarter of a layer on the average, and beside a wall that no cell follows up to
// three quarters; what is there then settles below the level asked for.

namespace riprap::coupling {

/// 64 points of a cell, spread evenly over neighbouring cells, and which of them lie in no solid.
struct CellPoints {
    CellPoints(const FillSolids& solids, const Lattice& lattice, int dimension, std::int64_t i, std::int64_t j,
               std::int64_t k);
    double free_share() const;  ///< [-]
    /// The share of those that are joined, from point to point, with the one nearest to a place: of a cell that a thin
    /// wall cuts in two, one side [-].
    double share_about(const Vec3& place) const;

    std::array<Vec3, 64> point;
    std::array<bool, 64> is_free{};
    int across, deep;  ///< points along the first two axes, and along the third
};

/// Moves the surfaces of regions until as many cells are filled as there is room below the surface asked for, to one
/// particle; by a layer at most. Cells count that are filled or share a face with one that is, as no particle gets into
/// narrower gaps; of a cell beside solids the share of 64 points counts, spread evenly over neighbouring cells, that
/// lies in no solid, and in the last layer what is below the surface. Regions whose lattice fits are left as they are.
/// @param distance  that places keep from solids [m]
/// @param reports  get the room of each region
/// @return  true where a surface has moved
bool raise_to_volume(std::span<RegionPlanes> regions, const fluid::ParticleSettings& settings, const Vec3& corner,
                     const FillSolids& solids, const Vec3& up, double distance, std::span<FillReport> reports);

/// Writes the room of every region into its report, and moves nothing.
void measure_rooms(std::span<const RegionPlanes> regions, const fluid::ParticleSettings& settings, const Vec3& corner,
                   const FillSolids& solids, const Vec3& up, double distance, std::span<FillReport> reports);

}  // namespace riprap::coupling
