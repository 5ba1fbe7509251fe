// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/coupling/fill.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"

// The regions of water as planes, and the lattice of places that they share (fill.hpp).

namespace riprap::coupling {

constexpr double lattice_slack = 1e-6;  ///< of a spacing: a lattice that fits is not lost to round-off

/// Distance that places keep from faces [m].
double face_distance(const fluid::ParticleSettings& settings);

struct Bounds {
    Vec3 low, high;
};

/// A region as planes: a place is inside when it is below all planes of one piece, and below the level.
struct RegionPlanes {
    std::vector<std::vector<geometry::Plane>> pieces;
    Bounds bounds;
    double surface;
};

/// Returns the region cut at its level, and writes its volume and surface into `report`.
RegionPlanes planes_of(const FillRegion& region, const fluid::ParticleSettings& settings, const Vec3& up,
                       FillReport& report);

/// Moves the surface of a region along `up` by `height` [m]; faces below the surface stay.
void raise_surface(RegionPlanes& region, const Vec3& up, double height, double spacing);

/// Places (first + spacing (i, j, k)) that all regions share.
struct Lattice {
    Vec3 first;
    std::array<std::int64_t, 3> counts;
    double spacing;
    Vec3 place(std::int64_t i, std::int64_t j, std::int64_t k) const {
        return first + spacing * Vec3{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
    }
    std::int64_t rows() const { return counts[1] * counts[2]; }
};

/// Where the lattice starts: at the low corner of the first region that has any extent, or else of the domain.
Vec3 lattice_corner(std::span<const RegionPlanes> regions, const fluid::Domain& domain);

/// The part of the lattice about `corner` that the regions and the domain span.
/// @throws CaseError  where a period of the domain is not a whole number of spacings, or there are too many of them
Lattice lattice_over(std::span<const RegionPlanes> regions, const fluid::ParticleSettings& settings, const Vec3& corner,
                     const Vec3& up);

/// The share of cell (i, j, k) that lies below the surface of a region; 0 where the cell's place is outside of it, and
/// for shares below a hundredth. Solids are not asked.
double share_of(const RegionPlanes& region, const Lattice& lattice, const Vec3& up, std::int64_t i, std::int64_t j,
                std::int64_t k);

/// The first region that place (i, j, k) is in; -1 = none. Where the spacing does not divide the depth, the last
/// layer, of whose cells a share lies below the surface, gets that share of its places, spread evenly, so that the
/// volume is the one asked for. Solids are not asked.
int region_of(std::span<const RegionPlanes> regions, const Lattice& lattice, const Vec3& up, std::int64_t i,
              std::int64_t j, std::int64_t k);

/// The first region that a particle of cell (i, j, k) is in which stands at `place` beside a solid: the cell is below
/// its surface as region_of() has it, and the place between its other faces; -1 = none.
int region_beside(std::span<const RegionPlanes> regions, const Lattice& lattice, const Vec3& up, std::int64_t i,
                  std::int64_t j, std::int64_t k, const Vec3& place);

}  // namespace riprap::coupling
