// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/geometry/polyhedra/outcome.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry {

/// Most blocks of one Voronoi pack.
inline constexpr std::int64_t voronoi_maximum_blocks = 1'000'000;

struct VoronoiOptions {
    std::int64_t block_count{100};
    std::uint64_t seed{0};  ///< same seed, same blocks
    /// Times that every point is moved to the centroid of its cell [Lloyd1982]; makes blocks rounder and more alike.
    /// 0: points uniform in the region, 2 to 5: rubble of similar blocks.
    int lloyd_iterations{0};
    double gap{0.0};  ///< width of the open joint between neighbouring blocks [m]
};

/// Points uniform in a convex region, from a counter-based generator: point i is the first of its own sequence of
/// points in the bounding box that falls inside.
std::vector<Vec3> random_points(const Polyhedron& region, std::int64_t count, std::uint64_t seed);

/// Divides a convex region among points: block i holds what is nearer to point i than to any other. voro++
/// [Rycroft2009] finds which points are neighbours; each block is then the region cut by the planes half-way to its
/// neighbours, each moved inwards by gap / 2. The boundary of the region is not moved. Without a gap the volumes add up
/// to that of the region to round-off. Refuses no or too many points, points that coincide or lie outside, and a gap
/// that leaves nothing of a block.
Outcome<std::vector<Polyhedron>> voronoi_cells(const Polyhedron& region, std::span<const Vec3> points, double gap);

/// A pack of blocks around random points; see VoronoiOptions.
Outcome<std::vector<Polyhedron>> voronoi_blocks(const Polyhedron& region, const VoronoiOptions& options);

}  // namespace riprap::geometry
