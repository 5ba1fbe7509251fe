// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "riprap/geometry/dda_files/dda_files.hpp"
#include "riprap/geometry/planar/planar_polygon.hpp"
#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

/// One block of a section as it stands.
struct SectionBlock {
    geometry::Polygon corners;
    std::vector<geometry::Polygon> pieces;  ///< convex
    /// A point well inside.
    geometry::Vec2 middle() const { return geometry::moments_of(pieces.front()).centroid; }
};

inline geometry::Vec2 to_point(const Value& pair) { return {pair.items[0].as_number(), pair.items[1].as_number()}; }

/// The block that a point lies in; -1 = none.
std::int64_t block_at(const std::vector<SectionBlock>& blocks, const geometry::Vec2& x);

/// Adds forces of an analysis file at the load points of the geometry file, in their order.
/// @param first  number of the body that is the first block
void add_file_loads(CaseBuild& build, const Value& table, const std::vector<SectionBlock>& blocks,
                    std::span<const geometry::Vec2> points, std::span<const geometry::DdaLoadHistory> loads,
                    std::int32_t first);

/// Adds the forces that the table names, on the blocks that their points lie in or on, and notes which these are.
void add_loads_at(CaseBuild& build, const Value& table, const std::vector<SectionBlock>& blocks, std::int32_t first);

}  // namespace riprap::scene
