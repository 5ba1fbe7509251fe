// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/coupling/fill_lattice.hpp"
#include "riprap/coupling/fill_solids.hpp"

// Raises the surface of a region by what the lattice leaves out beside solids. Places keep a quarter of a spacing from
// faces, so water over a slope lacks a quarter of a layer on the average, and beside a wall that no cell follows up to
// three quarters; what is there then settles below the level asked for.

namespace riprap::coupling {

/// Compares the places of a region with the room that it has beside solids.
struct RegionRoom {
    double places{0};    ///< that are filled [spacing^d]
    double shortage{0};  ///< room less places, of cells that are filled or share a face with one that is [spacing^d]
    double top{0};       ///< filled places of the uppermost whole layer
};

/// Measures every region. The room of a cell near solids is the share of 64 points of it, spread evenly over
/// neighbouring cells, that lie in no solid; gaps too narrow for a place take no part, as no particle gets there.
/// @param distance  that places keep from solids [m]
std::vector<RegionRoom> measure_room(std::span<const RegionPlanes> regions, const Lattice& lattice,
                                     const FillSolids& solids, const Vec3& up, double distance, int dimension);

/// Raises or lowers the surfaces of regions until their places stand for the room below the surface asked for; by a
/// layer at most. Moves below a hundredth of a layer are left out and the room is sampled, so a tank of some hundred
/// columns keeps two hundredths of a layer, a lake less. Regions whose lattice fits are left as they are.
/// @param reports  get the room of each region
/// @return  true where a surface has moved
bool raise_to_volume(std::span<RegionPlanes> regions, const fluid::ParticleSettings& settings, const Vec3& corner,
                     const FillSolids& solids, const Vec3& up, double distance, std::span<FillReport> reports);

}  // namespace riprap::coupling
