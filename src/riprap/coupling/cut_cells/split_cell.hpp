// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "riprap/fluid/grid/mesh.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::coupling {

/// Open area on a side of a cell that belongs to a component of it.
struct OpenPart {
    std::int8_t axis;
    bool is_high;  ///< on the side of the cell towards +axis
    std::int32_t component;
    double share;  ///< of the side [-]
    Vec3 middle;   ///< cell coordinates [-]
};

/// A cell that solids cut in two or more, as a wall thinner than the cell does.
struct SplitCell {
    std::int64_t cell;
    std::array<int, 3> place;
    std::vector<double> volume;           ///< share of the cell in each component, the largest first [-]
    std::vector<std::uint8_t> is_closed;  ///< component by component
    std::vector<OpenPart> sides;

    /// Returns the component that a place beside a surface lies in; -1: none.
    std::int32_t component_at(const fluid::grid::Mesh& mesh, const Vec3& x) const;

    /// A convex piece of what is open, in cell coordinates: -1/2 to 1/2 along each axis.
    struct Piece {
        std::vector<geometry::Plane> planes;
        std::int32_t component;
    };
    std::vector<Piece> pieces;
};

/// Splits a cell by the convex parts in it, each given by those of its planes that cross the cell. Returns nothing
/// where what they leave open hangs together.
///
/// The open rest is cut into convex pieces, and pieces that share an area make a component. Of components as large as
/// each other by a hundredth the one nearer to the low corner stays open, so that a wall in the middle of its cells
/// does not change sides with the round-off of its place.
/// @param passage  pieces that share less than this of a side of the cell do not hang together [-]
std::optional<SplitCell> split_cell(const fluid::grid::Mesh& mesh, const std::array<int, 3>& place,
                                    std::span<const std::span<const geometry::Plane>> parts, double passage);

}  // namespace riprap::coupling
