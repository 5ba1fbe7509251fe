// SPDX-License-Identifier: Apache-2.0
// Shapes that need a hull or a file.
#include <fmt/format.h>

#include "riprap/scene/limits.hpp"
#include "riprap/scene/shape_library.hpp"

namespace riprap::scene {

using geometry::Polyhedron;

std::optional<Polyhedron> ShapeLibrary::make_hull(const Value& table) {
    problems_.push_back({table.place, "convex hulls are not implemented in this version", ""});
    return std::nullopt;
}

std::optional<std::vector<Polyhedron>> ShapeLibrary::make_surface(const Value& table, bool /*is_stl*/) {
    problems_.push_back({table.place, "surfaces from files are not implemented in this version", ""});
    return std::nullopt;
}

}  // namespace riprap::scene
