// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/shapes/shape_library.hpp"

#include <fmt/format.h>

#include <utility>

#include "riprap/geometry/polyhedra/sound_part.hpp"
#include "riprap/scene/keys/bound_keys.hpp"
#include "riprap/scene/shapes/composed_shapes.hpp"

namespace riprap::scene {

using geometry::Polyhedron;

namespace {

/// Two shape tables with the same text are the same shape.
std::string text_of(const Value& shape) {
    Value wrap = Value::table();
    wrap.set("shape", shape);
    return write_json(wrap);
}

/// Adds a problem for the first piece that double precision cannot hold.
bool are_sound(const std::vector<Polyhedron>& pieces, bool is_planar, const SourcePlace& place,
               std::vector<Diagnostic>& problems) {
    for (const Polyhedron& piece : pieces) {
        if (const auto problem = geometry::part_problem(piece, is_planar)) {
            problems.push_back({place, problem->message, problem->allowed});
            return false;
        }
    }
    return true;
}

}  // namespace

ShapePieces ShapeLibrary::accept(geometry::Outcome<Polyhedron> outcome, const SourcePlace& place) {
    for (const geometry::GeometryProblem& problem : outcome.problems()) {
        refuse(place, problem.message, problem.allowed);
    }
    return outcome ? ShapePieces(std::vector{std::move(outcome).value()}) : std::nullopt;
}

ShapePieces ShapeLibrary::make(const Value& shape) {
    const Entry& entry = shape.entries.front();
    const ShapeKind& kind = kind_of(shape);
    if (const ShapeKind::Make work = is_planar_ ? kind.in_plane : kind.in_space) {
        return work(*this, entry);
    }
    if (is_planar_) {
        std::vector<std::string_view> words;
        for (const ShapeKind& other : shape_kinds()) {
            if (other.role == ShapeRole::plane || (other.in_plane != nullptr && other.role != ShapeRole::ground)) {
                words.push_back(other.row.name);
            }
        }
        refuse(entry.place, fmt::format("'{}' is no shape of a planar scene", entry.key),
               fmt::format("{}", fmt::join(words, ", ")));
    } else {
        refuse(entry.place, fmt::format("'{}' cannot stand here", entry.key),
               kind.instead.empty() ? "a shape with a volume"
                                    : fmt::format("{} is for dimension = 2; use {}", entry.key, kind.instead));
    }
    return std::nullopt;
}

std::optional<ShapeLibrary::Pieces> ShapeLibrary::placed_pieces(const Value& shape) {
    const auto [it, is_new] = known_pieces_.try_emplace(text_of(shape));
    if (is_new) {
        auto made = make(shape);
        const Vec3 origin = std::exchange(origin_, Vec3{});
        // Ground is checked where it is made, which knows what makes it thin.
        const bool is_good =
            made && (is_ground(shape) || are_sound(*made, is_planar_, shape.entries.front().place, problems_));
        it->second = is_good ? std::optional(Pieces{std::move(*made), origin}) : std::nullopt;
    }
    return it->second;
}

std::optional<std::vector<Polyhedron>> ShapeLibrary::pieces(const Value& shape) {
    auto placed = placed_pieces(shape);
    if (!placed) {
        return std::nullopt;
    }
    if (norm_squared(placed->origin) > 0) {
        for (Polyhedron& piece : placed->polyhedra) {
            piece = geometry::moved(piece, {placed->origin, Quat{}});
        }
    }
    return std::move(placed->polyhedra);
}

body::Part ShapeLibrary::add(const Polyhedron& polyhedron) {
    Vec3 centroid{};
    const ShapeId id = shapes_.add_convex(polyhedron, is_planar_, &centroid);
    return {BodyId{}, id, Pose{centroid, Quat{}}};
}

std::optional<std::vector<body::Part>> ShapeLibrary::parts(const Value& shape, double scale) {
    const auto [it, is_new] = known_parts_.try_emplace(fmt::format("{} {}", scale, text_of(shape)));
    if (!is_new) {
        return it->second;
    }
    std::vector<body::Part> parts;
    if (is_half_space(shape)) {
        HalfSpaceShape plane;
        read_keys(get(shape, "half_space"), HalfSpaceShape::keys(), plane);
        parts.push_back({BodyId{}, shapes_.add_half_space(plane.normal, plane.offset), Pose{}});
    } else {
        auto placed = placed_pieces(shape);
        if (!placed) {
            return std::nullopt;
        }
        const Vec3& o = placed->origin;
        const Vec3 origin{scale * o.x, scale * o.y, is_planar_ ? o.z : scale * o.z};
        for (Polyhedron& polyhedron : placed->polyhedra) {
            for (Vec3& vertex : polyhedron.vertices) {
                vertex = {scale * vertex.x, scale * vertex.y, is_planar_ ? vertex.z : scale * vertex.z};
            }
        }
        if (scale != 1 && !are_sound(placed->polyhedra, is_planar_, shape.entries.front().place, problems_)) {
            return std::nullopt;
        }
        for (const Polyhedron& polyhedron : placed->polyhedra) {
            parts.push_back(add(polyhedron));
            parts.back().local.position += origin;
        }
    }
    it->second = parts;
    return parts;
}

}  // namespace riprap::scene
