// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/geometry/planar/planar_polygon.hpp"

namespace riprap::geometry {

/// A straight joint or a piece of an outline.
struct PlanarJoint {
    Vec2 begin{}, end{};   ///< [m]
    std::int32_t type{0};  ///< of the joint; kept on the edges that it makes
};

struct PlanarCutSettings {
    double snap{0};       ///< points nearer than this are one [m]; 0 = 1e-9 of the extent
    double sliver{1e-4};  ///< a block with an area below this share of its longest extent squared is refused [-]
};

/// Blocks that joints enclose, and a count of what was found on the way.
struct PlanarBlocks {
    std::vector<Polygon> blocks;                        ///< counter-clockwise
    std::vector<std::vector<std::int32_t>> edge_types;  ///< of the edge that begins at each corner
    std::int32_t crossings{0};                          ///< points in which joints cross or meet
    std::int32_t dead_ends{0};                          ///< pieces of joints that end inside a block and cut nothing
    std::int32_t loose_loops{0};  ///< closed joints inside one block that nothing ties to its outline; left out
};

/// Cuts the plane along joints: every region that they enclose becomes a block.
///
/// Joints are split where they cross, meet end on or lie on each other; pieces that lead nowhere (dangling, dead ends)
/// are taken away until none is left; the regions of the rest are walked round counter-clockwise. Corners at which a
/// block's outline goes straight on are dropped. A slope with its outline among the joints gives its blocks; a joint
/// that reaches beyond the outline is trimmed at it.
/// Refused: no closed region, a sliver (the message says where), coordinates that are not finite.
Outcome<PlanarBlocks> cut_by_lines(std::span<const PlanarJoint> joints, const PlanarCutSettings& settings = {});

/// Parallel joints across a region.
struct PlanarJointSet {
    double dip{0};              ///< of the traces, counter-clockwise from +x [rad]
    double spacing{1};          ///< across the traces [m]
    double spacing_scatter{0};  ///< spacings are drawn evenly within this share of their mean, 0 to 1 [-]
    double length{0};           ///< of a trace [m]; 0 = across the whole region
    double bridge{0};           ///< between two traces of one line [m]
    double offset{0};           ///< of the first line from the origin, across the traces [m]
    std::int32_t type{0};
};

/// Traces of a set within a convex or concave region. The same seed gives the same traces.
std::vector<PlanarJoint> traces_of(const PlanarJointSet& set, std::span<const Vec2> region, std::uint64_t seed = 0);

/// The outline of a region as joints.
std::vector<PlanarJoint> outline_of(std::span<const Vec2> region, std::int32_t type = 0);

}  // namespace riprap::geometry
