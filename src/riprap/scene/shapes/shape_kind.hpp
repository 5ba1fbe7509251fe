// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "riprap/geometry/polyhedra/polyhedron.hpp"
#include "riprap/scene/keys/key_table.hpp"

namespace riprap::scene {

class ShapeLibrary;

/// Convex pieces of a shape about its origin; nothing, with problems, where it is refused.
using ShapePieces = std::optional<std::vector<geometry::Polyhedron>>;

/// Bodies that a shape can be of.
enum class ShapeRole {
    solid,  ///< any
    plane,  ///< those that do not follow forces; without volume
    ground  ///< those that do not follow forces; a surface with solid under it
};

/// Kind of a shape, one of shape_kinds(). `shape = { word = ... }`, its checks, schema and manual are made from the
/// row.
struct ShapeKind {
    using Make = ShapePieces (*)(ShapeLibrary& library, const Entry& given);
    Key row;                 ///< of [shape]: word, forms, help
    Make in_space{nullptr};  ///< nullptr: none in a scene with three dimensions
    Make in_plane{nullptr};  ///< nullptr: none in a planar scene; pieces are prisms one metre thick
    ShapeRole role{ShapeRole::solid};
    std::string_view instead{};  ///< of a planar kind: what takes its place in space
};

/// All kinds, in the order of the manual.
const std::vector<ShapeKind>& shape_kinds();
/// The kind of a resolved `shape = { ... }`.
const ShapeKind& kind_of(const Value& shape);

}  // namespace riprap::scene
