// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/shapes/convex_shapes.hpp"

#include <cmath>
#include <numbers>

#include "riprap/geometry/polyhedra/convex_hull.hpp"
#include "riprap/geometry/polyhedra/round_shapes.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"
#include "riprap/geometry/polyhedra/sound_part.hpp"
#include "riprap/scene/keys/bound_keys.hpp"
#include "riprap/scene/shapes/shape_library.hpp"

namespace riprap::scene {

using geometry::Outcome;
using geometry::Point2;
using geometry::Polyhedron;
using namespace form;

namespace {

const Form length = number(dimension::length, positive());
const Form sizes = vector(dimension::length, positive());

ShapePieces one(Polyhedron piece) { return std::vector{std::move(piece)}; }

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

/// A prism over an ellipse about the origin.
Outcome<Polyhedron> round_prism(double x, double y) {
    constexpr int sides = 64;
    std::vector<Point2> corners = regular_polygon(sides, geometry::circumradius_of_equal_area(sides));
    for (Point2& corner : corners) {
        corner[0] *= x;
        corner[1] *= y;
    }
    return sized_prism(corners);
}

/// A regular solid by its edge or the distance of its corners from the centre [m].
struct RegularShape {
    std::optional<double> edge{}, circumradius{};
    static KeyList<RegularShape> keys() {
        using S = RegularShape;
        return {key::number(&S::edge, "edge", dimension::length, positive(), "Length of an edge."),
                key::number(&S::circumradius, "circumradius", dimension::length, positive(),
                            "Distance of the corners from the centre.")};
    }
};
const Table& regular_table() {
    static const Table table{"shape.regular",
                             "shape = { octahedron = { ... } }",
                             "A regular solid about its centre.",
                             rows_of(RegularShape::keys()),
                             {{GroupRule::exactly_one, {"edge", "circumradius"}}}};
    return table;
}

/// A regular solid in a length or a table; `ratio` is circumradius over edge.
template <class Make>
ShapePieces regular(const Value& given, double ratio, const Make& make) {
    if (given.is_number()) {
        return one(make(given.as_number()));
    }
    RegularShape shape;
    read_keys(given, RegularShape::keys(), shape);
    return one(make(shape.edge ? *shape.edge : *shape.circumradius / ratio));
}

Key regular_row(std::string_view word) {
    return {word, {length, form::table(regular_table)}, "Edge length of a regular one, or a table.", {}};
}

const Table& prism_table() {
    static const Table table{
        "shape.prism",
        "shape = { prism = { ... } }",
        "A right prism along z, about its centre: a regular polygon, or any convex one.",
        {optional_key("sides", {integer(3, 64)}, "Corners of a regular polygon."),
         optional_key("circumradius", {length}, "Circumradius of the regular polygon."),
         optional_key("points", {list(list(number(dimension::length), 2, 2), 3, 256)},
                      "Corners x, y of a convex polygon, in order."),
         optional_key(
             "height", {length},
             "Along z; the prism reaches half of it to either side. Not given in a planar scene, where it is 1 m.")},
        {{GroupRule::exactly_one, {"sides", "points"}}, {GroupRule::all_or_none, {"sides", "circumradius"}}}};
    return table;
}

ShapePieces make_prism(ShapeLibrary& library, const Entry& given) {
    const Value& table = given.value;
    const Value* height = table.find("height");
    const Value* points = table.find("points");
    const bool is_planar = library.is_planar();
    if (is_planar ? height != nullptr && height->as_number() != 1 : height == nullptr) {
        library.refuse(table.place,
                       is_planar ? "a prism of a planar scene is one metre high" : "a prism lacks 'height'",
                       is_planar ? "leave 'height' out" : "a length [m]");
        return std::nullopt;
    }
    const std::vector<Point2> corners =
        points != nullptr ? corners_of(*points)
                          : regular_polygon(get_integer(table, "sides"), get_number(table, "circumradius"));
    if (is_planar) {
        return library.accept(points != nullptr ? geometry::planar_prism(corners) : sized_prism(corners), table.place);
    }
    const double half = height->as_number() / 2;
    return library.accept(geometry::extruded_polygon(corners, -half, half), table.place);
}

struct CylinderShape {
    double radius{0};  ///< [m]
    double height{0};  ///< [m]
    int sides{32};
    static KeyList<CylinderShape> keys() {
        using S = CylinderShape;
        return {key::number(&S::radius, "radius", dimension::length, positive(), "Radius of the circle.").required(),
                key::number(&S::height, "height", dimension::length, positive(), "Along z; half of it to either side.")
                    .required(),
                key::integer(&S::sides, "sides", 8, 64, "Sides of the prism.")};
    }
};

const Table& cylinder_table() {
    static const Table table{"shape.cylinder", "shape = { cylinder = { ... } }",
                             "A cylinder along z, about its centre, as a prism with its volume.",
                             rows_of(CylinderShape::keys())};
    return table;
}

struct RandomHullShape {
    int corners{12};
    double circumradius{0};  ///< [m]
    std::uint64_t seed{1};
    static KeyList<RandomHullShape> keys() {
        using S = RandomHullShape;
        return {key::integer(&S::corners, "corners", 4, 200, "Number of points."),
                key::number(&S::circumradius, "circumradius", dimension::length, positive(), "Radius of the sphere.")
                    .required(),
                key::integer(&S::seed, "seed", 0, 9e15, "Seed of the stone.")};
    }
};

const Table& random_hull_table() {
    static const Table table{"shape.random_hull", "shape = { random_hull = { ... } }",
                             "Convex hull of random points on a sphere: an irregular stone.",
                             rows_of(RandomHullShape::keys())};
    return table;
}

}  // namespace

ShapeKind box_shape() {
    return {optional_key("box", {sizes}, "Edge lengths along x, y, z, about the centre."),
            [](ShapeLibrary&, const Entry& given) { return one(geometry::box(to_vector(given.value))); },
            [](ShapeLibrary& library, const Entry& given) {
                const Vec3 size = to_vector(given.value);
                return library.accept(sized_prism(rectangle(size.x, size.y)), given.place);
            }};
}

ShapeKind cube_shape() {
    return {optional_key("cube", {length}, "Edge length, about the centre."),
            [](ShapeLibrary&, const Entry& given) { return one(geometry::cube(given.value.as_number())); },
            [](ShapeLibrary& library, const Entry& given) {
                const double edge = given.value.as_number();
                return library.accept(sized_prism(rectangle(edge, edge)), given.place);
            }};
}

ShapeKind prism_shape() {
    return {optional_key("prism", {form::table(prism_table)}, "A right prism."), make_prism, make_prism};
}

ShapeKind tetrahedron_shape() {
    return {optional_key("tetrahedron", {length, list(vector(dimension::length), 4, 4)},
                         "Edge length of a regular one about its centre, or its four corners."),
            [](ShapeLibrary& library, const Entry& given) {
                if (given.value.is_number()) {
                    return one(geometry::regular_tetrahedron(given.value.as_number()));
                }
                const auto& p = given.value.items;
                return library.accept(
                    geometry::tetrahedron(to_vector(p[0]), to_vector(p[1]), to_vector(p[2]), to_vector(p[3])),
                    given.place);
            }};
}

ShapeKind wedge_shape() {
    return {optional_key("wedge", {sizes},
                         "Half a box [0, x] by [0, y] by [0, z], upright face in x = 0, upper edge along y."),
            [](ShapeLibrary& library, const Entry& given) {
                return library.accept(geometry::wedge(to_vector(given.value), 0, 0), given.place);
            }};
}

ShapeKind octahedron_shape() {
    return {regular_row("octahedron"), [](ShapeLibrary&, const Entry& given) {
                return regular(given.value, std::numbers::sqrt2 / 2, geometry::octahedron);
            }};
}

ShapeKind dodecahedron_shape() {
    return {regular_row("dodecahedron"), [](ShapeLibrary&, const Entry& given) {
                return regular(given.value, std::sqrt(3.0) * std::numbers::phi / 2, geometry::dodecahedron);
            }};
}

ShapeKind icosahedron_shape() {
    return {regular_row("icosahedron"), [](ShapeLibrary&, const Entry& given) {
                return regular(given.value, std::sqrt(std::numbers::phi * std::sqrt(5.0)) / 2, geometry::icosahedron);
            }};
}

ShapeKind sphere_shape() {
    return {optional_key(
                "sphere", {length},
                "Radius of a ball, in a planar scene of a disc. Others meet it as a ball or a disc; by solid.method "
                "\"planar_dda\", and on ground by \"distance_potential_dem\", as a polyhedron of 320 triangles (a "
                "prism of 64 "
                "sides) with its volume, which is what is shown."),
            [](ShapeLibrary&, const Entry& given) { return one(geometry::sphere(given.value.as_number())); },
            [](ShapeLibrary& library, const Entry& given) {
                const double radius = given.value.as_number();
                return library.accept(round_prism(radius, radius), given.place);
            }};
}

ShapeKind ellipsoid_shape() {
    return {optional_key(
                "ellipsoid", {sizes},
                "Semi-axes along x, y and z, as a polyhedron of 320 triangles with its volume; not in a planar scene."),
            [](ShapeLibrary&, const Entry& given) { return one(geometry::ellipsoid(to_vector(given.value))); }};
}

ShapeKind ellipse_shape() {
    ShapeKind kind{optional_key("ellipse", {list(number(dimension::length, positive()), 2, 2)},
                                "Semi-axes along x and y, as a prism of 64 sides with its area; planar scenes only.")};
    kind.in_plane = [](ShapeLibrary& library, const Entry& given) {
        const auto& axes = given.value.items;
        return library.accept(round_prism(axes[0].as_number(), axes[1].as_number()), given.place);
    };
    kind.instead = "ellipsoid";
    return kind;
}

ShapeKind cylinder_shape() {
    return {optional_key("cylinder", {form::table(cylinder_table)},
                         "A round cylinder along z; in a planar scene sphere is a disc."),
            [](ShapeLibrary& library, const Entry& given) {
                CylinderShape shape;
                read_keys(given.value, CylinderShape::keys(), shape);
                return library.accept(geometry::cylinder(shape.radius, shape.height, shape.sides), given.place);
            }};
}

ShapeKind random_hull_shape() {
    return {optional_key("random_hull", {form::table(random_hull_table)}, "An irregular stone."),
            [](ShapeLibrary& library, const Entry& given) {
                RandomHullShape shape;
                read_keys(given.value, RandomHullShape::keys(), shape);
                return library.accept(geometry::random_hull(shape.seed, shape.corners, shape.circumradius),
                                      given.value.place);
            }};
}

ShapeKind polygon_shape() {
    ShapeKind kind{optional_key("polygon", {list(list(number(dimension::length), 2, 2), 3, 256)},
                                "Corners x, y of a convex polygon, in order; planar scenes only.")};
    kind.in_plane = [](ShapeLibrary& library, const Entry& given) {
        return library.accept(geometry::planar_prism(corners_of(given.value)), given.place);
    };
    kind.instead = "prism = { points, height }";
    return kind;
}

}  // namespace riprap::scene
