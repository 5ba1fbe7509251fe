// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/build/shape_library.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "riprap/geometry/round_shapes.hpp"
#include "riprap/geometry/sound_part.hpp"
#include "riprap/scene/build/build_case.hpp"
#include "riprap/core/direction.hpp"

namespace riprap::scene {

using geometry::Outcome;
using geometry::Point2;
using geometry::Polyhedron;

namespace {

/// Two shape tables with the same text are the same shape.
std::string text_of(const Value& shape) {
    Value wrap = Value::table();
    wrap.set("shape", shape);
    return write_json(wrap);
}

std::vector<Point2> corners_of(const Value& list) {
    std::vector<Point2> corners;
    for (const Value& corner : list.items) {
        corners.push_back({corner.items[0].as_number(), corner.items[1].as_number()});
    }
    return corners;
}

std::vector<Point2> regular_polygon(std::int64_t sides, double circumradius) {
    std::vector<Point2> corners;
    for (std::int64_t i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(sides);
        corners.push_back({circumradius * std::cos(angle), circumradius * std::sin(angle)});
    }
    return corners;
}

std::vector<Point2> rectangle(double x, double y) {
    return {{-x / 2, -y / 2}, {x / 2, -y / 2}, {x / 2, y / 2}, {-x / 2, y / 2}};
}

/// Edge length of a regular solid given by edge or circumradius; `ratio` is circumradius over edge.
double edge_of(const Value& value, double ratio) {
    if (value.is_number()) {
        return value.as_number();
    }
    const Value* edge = value.find("edge");
    return edge != nullptr ? edge->as_number() : get_number(value, "circumradius") / ratio;
}

/// A prism over corners of a shape that is given by positive sizes: its polygon is bad for their sake alone.
Outcome<Polyhedron> sized_prism(const std::vector<Point2>& corners) {
    Outcome<Polyhedron> prism = geometry::planar_prism(corners);
    if (prism) {
        return prism;
    }
    Vec3 low{corners[0][0], corners[0][1], 0}, high = low;
    for (const Point2& corner : corners) {
        low = min(low, Vec3{corner[0], corner[1], 0});
        high = max(high, Vec3{corner[0], corner[1], 0});
    }
    return geometry::extent_problem(high - low, true);
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

std::optional<Polyhedron> ShapeLibrary::accept(Outcome<Polyhedron> outcome, const SourcePlace& place) {
    for (const geometry::GeometryProblem& problem : outcome.problems()) {
        problems_.push_back({place, problem.message, problem.allowed});
    }
    return outcome ? std::optional(std::move(outcome).value()) : std::nullopt;
}

std::optional<Polyhedron> ShapeLibrary::make_prism(const Value& table) {
    const Value* height = table.find("height");
    const Value* points = table.find("points");
    if (is_planar_ ? height != nullptr && height->as_number() != 1 : height == nullptr) {
        problems_.push_back({table.place,
                             is_planar_ ? "a prism of a planar scene is one metre high" : "a prism lacks 'height'",
                             is_planar_ ? "leave 'height' out" : "a length [m]"});
        return std::nullopt;
    }
    const std::vector<Point2> corners =
        points != nullptr ? corners_of(*points)
                          : regular_polygon(get_integer(table, "sides"), get_number(table, "circumradius"));
    if (is_planar_) {
        return accept(points != nullptr ? geometry::planar_prism(corners) : sized_prism(corners), table.place);
    }
    const double half = height->as_number() / 2;
    return accept(geometry::extruded_polygon(corners, -half, half), table.place);
}

std::optional<Polyhedron> ShapeLibrary::make_planar(const Value& shape) {
    const Entry& entry = shape.entries.front();
    if (entry.key == "box") {
        const Vec3 size = to_vector(entry.value);
        return accept(sized_prism(rectangle(size.x, size.y)), entry.place);
    }
    if (entry.key == "cube") {
        const double edge = entry.value.as_number();
        return accept(sized_prism(rectangle(edge, edge)), entry.place);
    }
    if (entry.key == "sphere" || entry.key == "ellipse") {
        constexpr int sides = 64;
        std::vector<Point2> corners = regular_polygon(sides, geometry::circumradius_of_equal_area(sides));
        const bool is_round = entry.key == "sphere";
        for (Point2& corner : corners) {
            corner[0] *= (is_round ? entry.value : entry.value.items[0]).as_number();
            corner[1] *= (is_round ? entry.value : entry.value.items[1]).as_number();
        }
        return accept(sized_prism(corners), entry.place);
    }
    if (entry.key == "polygon") {
        return accept(geometry::planar_prism(corners_of(entry.value)), entry.place);
    }
    if (entry.key == "prism") {
        return make_prism(entry.value);
    }
    problems_.push_back({entry.place, fmt::format("'{}' is no shape of a planar scene", entry.key),
                         "box, cube, prism, polygon, sphere, ellipse, half_space, or a union of these"});
    return std::nullopt;
}

std::optional<std::vector<Polyhedron>> ShapeLibrary::make(const Value& shape) {
    const Entry& entry = shape.entries.front();
    const std::string& kind = entry.key;
    const Value& value = entry.value;
    std::optional<Polyhedron> one;
    if (kind == "union") {
        return make_union(value);
    }
    if (kind == "armour") {
        return make_armour(value);
    }
    if (kind == "terrain") {
        return make_terrain(value);
    }
    if (kind == "mesh") {
        return make_mesh(value);
    }
    if (is_planar_) {
        one = make_planar(shape);
    } else if (kind == "box") {
        one = geometry::box(to_vector(value));
    } else if (kind == "cube") {
        one = geometry::cube(value.as_number());
    } else if (kind == "wedge") {
        one = accept(geometry::wedge(to_vector(value), 0, 0), entry.place);
    } else if (kind == "tetrahedron") {
        if (value.is_number()) {
            one = geometry::regular_tetrahedron(value.as_number());
        } else {
            const auto& p = value.items;
            one = accept(geometry::tetrahedron(to_vector(p[0]), to_vector(p[1]), to_vector(p[2]), to_vector(p[3])),
                         entry.place);
        }
    } else if (kind == "octahedron") {
        one = geometry::octahedron(edge_of(value, std::numbers::sqrt2 / 2));
    } else if (kind == "dodecahedron") {
        one = geometry::dodecahedron(edge_of(value, std::sqrt(3.0) * std::numbers::phi / 2));
    } else if (kind == "icosahedron") {
        one = geometry::icosahedron(edge_of(value, std::sqrt(std::numbers::phi * std::sqrt(5.0)) / 2));
    } else if (kind == "sphere") {
        one = geometry::sphere(value.as_number());
    } else if (kind == "ellipsoid") {
        one = geometry::ellipsoid(to_vector(value));
    } else if (kind == "cylinder") {
        one = accept(geometry::cylinder(get_number(value, "radius"), get_number(value, "height"),
                                        static_cast<int>(get_integer(value, "sides"))),
                     entry.place);
    } else if (kind == "prism") {
        one = make_prism(value);
    } else if (kind == "hull") {
        one = make_hull(value);
    } else if (kind == "random_hull") {
        one = make_random_hull(value);
    } else if (kind == "stl" || kind == "obj") {
        return make_surface(value, kind == "stl");
    } else {
        problems_.push_back({entry.place, fmt::format("'{}' cannot stand here", kind),
                             kind == "polygon" || kind == "ellipse"
                                 ? fmt::format("{} is for dimension = 2; use {}", kind,
                                               kind == "polygon" ? "prism = { points, height }" : "ellipsoid")
                                 : "a shape with a volume"});
    }
    if (!one) {
        return std::nullopt;
    }
    return std::vector<Polyhedron>{std::move(*one)};
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
        const Value& plane = get(shape, "half_space");
        const Vec3 normal = direction_of(get_vector(plane, "normal"));
        parts.push_back({BodyId{}, shapes_.add_half_space(normal, get_number(plane, "offset")), Pose{}});
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
