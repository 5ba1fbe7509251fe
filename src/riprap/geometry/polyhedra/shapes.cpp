// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "riprap/geometry/polyhedra/sound_part.hpp"

namespace riprap::geometry {

namespace {

/// Four points whose smallest altitude is below this fraction of their extent lie in one plane.
constexpr double flatness_tolerance = 1e-9;
/// Sine of the turn below which a corner of a polygon is straight.
constexpr double straight_tolerance = 1e-9;

void scale(Polyhedron& shape, double factor) {
    for (Vec3& x : shape.vertices) {
        x *= factor;
    }
}

std::vector<Point2> regular_polygon(int sides, double circumradius) {
    std::vector<Point2> corners;
    for (int k = 0; k < sides; ++k) {
        const double angle = 2 * std::numbers::pi * k / sides;
        corners.push_back({circumradius * std::cos(angle), circumradius * std::sin(angle)});
    }
    return corners;
}

/// Prism over corners already known to be convex and counter-clockwise. Faces: bottom, top, sides.
Polyhedron extrude(std::span<const Point2> corners, double bottom, double top) {
    const auto n = static_cast<std::int32_t>(corners.size());
    Polyhedron shape;
    for (const double z : {bottom, top}) {
        for (const Point2& corner : corners) {
            shape.vertices.push_back({corner[0], corner[1], z});
        }
    }
    std::vector<std::int32_t> below, above;
    for (std::int32_t k = 0; k < n; ++k) {
        below.push_back(n - 1 - k);
        above.push_back(n + k);
    }
    shape.faces = {std::move(below), std::move(above)};
    for (std::int32_t k = 0; k < n; ++k) {
        const std::int32_t next = (k + 1) % n;
        shape.faces.push_back({k, next, n + next, n + k});
    }
    return shape;
}

/// Adds what is wrong with one polygon, corner by corner.
std::vector<GeometryProblem> polygon_problems(std::span<const Point2> corners) {
    std::vector<GeometryProblem> problems;
    const std::size_t n = corners.size();
    if (n < 3) {
        problems.push_back({fmt::format("a polygon of {} corners has no area", n), "give at least 3 corners"});
        return problems;
    }
    for (std::size_t k = 0; k < n; ++k) {
        if (!std::isfinite(corners[k][0]) || !std::isfinite(corners[k][1])) {
            problems.push_back({fmt::format("corner {} of the polygon is not finite", k), "give finite lengths"});
        }
    }
    if (!problems.empty()) {
        return problems;
    }
    double turned = 0;
    std::vector<std::size_t> straight, inward;
    for (std::size_t k = 0; k < n; ++k) {
        const Point2 &a = corners[(k + n - 1) % n], &b = corners[k], &c = corners[(k + 1) % n];
        const double ux = b[0] - a[0], uy = b[1] - a[1], vx = c[0] - b[0], vy = c[1] - b[1];
        const double u = std::hypot(ux, uy), v = std::hypot(vx, vy);
        if (v == 0) {
            problems.push_back({fmt::format("corners {} and {} of the polygon are the same point", k, (k + 1) % n),
                                "list each corner once, the first not repeated at the end"});
            continue;
        }
        if (u == 0) {
            continue;  // reported at the corner before
        }
        // Unit vectors first: products of edges of 1e-200 or 1e200 m leave the range of a double.
        const double ax = ux / u, ay = uy / u, bx = vx / v, by = vy / v;
        const double sine = ax * by - ay * bx, cosine = ax * bx + ay * by;
        turned += std::atan2(sine, cosine);
        if (std::abs(sine) <= straight_tolerance) {
            straight.push_back(k);
        } else if (sine < 0) {
            inward.push_back(k);
        }
    }
    if (!problems.empty()) {
        return problems;
    }
    constexpr double full_turn = 2 * std::numbers::pi;
    if (std::abs(turned + full_turn) < 0.5) {
        problems.push_back({"the polygon winds clockwise", "list the corners counter-clockwise"});
        return problems;
    }
    if (turned > 1.5 * full_turn || turned < 0.5 * full_turn) {
        problems.push_back({"the polygon crosses itself or winds more than once", "give a simple convex polygon"});
        return problems;
    }
    for (const std::size_t k : straight) {
        problems.push_back(
            {fmt::format("corner {} of the polygon lies on a straight line with its neighbours", k), "leave it out"});
    }
    for (const std::size_t k : inward) {
        problems.push_back({fmt::format("the polygon is not convex at corner {}", k),
                            "split it into convex polygons, parts of one body"});
    }
    return problems;
}

Outcome<Polyhedron> too_few_sides(int sides) {
    return GeometryProblem{fmt::format("a regular polygon of {} sides has no area", sides), "give 3 or more sides"};
}

}  // namespace

Polyhedron box(const Vec3& size) {
    const Vec3 h = 0.5 * size;
    const std::array<Point2, 4> corners{{{-h.x, -h.y}, {h.x, -h.y}, {h.x, h.y}, {-h.x, h.y}}};
    return extrude(corners, -h.z, h.z);
}

Polyhedron cube(double edge) { return box({edge, edge, edge}); }

Polyhedron regular_tetrahedron(double edge) {
    Polyhedron shape{
        {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}, {}};
    scale(shape, edge / std::sqrt(8.0));
    return shape;
}

Polyhedron octahedron(double edge) {
    Polyhedron shape{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                     {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}},
                     {}};
    scale(shape, edge / std::numbers::sqrt2);
    return shape;
}

Polyhedron icosahedron(double edge) {
    constexpr double g = std::numbers::phi;  // corners (0, +-1, +-g) and cyclic; edge 2
    Polyhedron shape{{{-1, g, 0},
                      {1, g, 0},
                      {-1, -g, 0},
                      {1, -g, 0},
                      {0, -1, g},
                      {0, 1, g},
                      {0, -1, -g},
                      {0, 1, -g},
                      {g, 0, -1},
                      {g, 0, 1},
                      {-g, 0, -1},
                      {-g, 0, 1}},
                     {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}},
                     {}};
    scale(shape, 0.5 * edge);
    return shape;
}

namespace {

/// Every triangle cut into four, new corners on the unit sphere.
Polyhedron divided(const Polyhedron& shape) {
    Polyhedron finer{shape.vertices, {}, {}};
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
    const auto middle = [&](std::int32_t a, std::int32_t b) {
        const auto [it, is_new] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::int32_t>(finer.vertices.size()));
        if (is_new) {
            const auto at = [&](std::int32_t v) { return finer.vertices[static_cast<std::size_t>(v)]; };
            finer.vertices.push_back(normalized(at(a) + at(b)));
        }
        return it->second;
    };
    for (const auto& face : shape.faces) {
        const std::int32_t a = face[0], b = face[1], c = face[2], ab = middle(a, b), bc = middle(b, c),
                           ca = middle(c, a);
        finer.faces.insert(finer.faces.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return finer;
}

constexpr std::size_t sphere_vertices = 162;

}  // namespace

Polyhedron sphere(double radius) {
    static const Polyhedron unit = [] {
        Polyhedron shape = icosahedron(1);
        scale(shape, 1 / norm(shape.vertices[0]));
        shape = divided(divided(shape));
        scale(shape, std::cbrt(4 * std::numbers::pi / 3 / mass_properties(shape).volume));
        return shape;
    }();
    Polyhedron shape = unit;
    scale(shape, radius);
    return shape;
}

bool is_sphere(const Polyhedron& shape) {
    if (shape.vertices.size() != sphere_vertices) {
        return false;
    }
    Vec3 centre{};
    for (const Vec3& v : shape.vertices) {
        centre += v / static_cast<double>(sphere_vertices);
    }
    const double radius = norm(shape.vertices[0] - centre);
    return std::ranges::all_of(shape.vertices,
                               [&](const Vec3& v) { return std::abs(norm(v - centre) - radius) < 1e-6 * radius; });
}

Polyhedron dodecahedron(double edge) {
    // Corners (+-1, +-1, +-1), (0, +-1/g, +-g) and cyclic; edge 2/g.
    constexpr double g = std::numbers::phi, i = 1 / std::numbers::phi;
    Polyhedron shape{{{1, 1, 1},    {1, 1, -1},  {1, -1, 1}, {1, -1, -1}, {-1, 1, 1},  {-1, 1, -1}, {-1, -1, 1},
                      {-1, -1, -1}, {0, i, g},   {0, i, -g}, {0, -i, g},  {0, -i, -g}, {i, g, 0},   {i, -g, 0},
                      {-i, g, 0},   {-i, -g, 0}, {g, 0, i},  {g, 0, -i},  {-g, 0, i},  {-g, 0, -i}},
                     {{0, 8, 10, 2, 16},
                      {0, 16, 17, 1, 12},
                      {0, 12, 14, 4, 8},
                      {1, 17, 3, 11, 9},
                      {1, 9, 5, 14, 12},
                      {2, 10, 6, 15, 13},
                      {2, 13, 3, 17, 16},
                      {3, 13, 15, 7, 11},
                      {4, 14, 5, 19, 18},
                      {4, 18, 6, 10, 8},
                      {5, 9, 11, 7, 19},
                      {6, 18, 19, 7, 15}},
                     {}};
    scale(shape, 0.5 * g * edge);
    return shape;
}

Outcome<Polyhedron> tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    Polyhedron shape{{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, {}};
    if (!std::all_of(shape.vertices.begin(), shape.vertices.end(), is_finite)) {
        return GeometryProblem{"a corner of the tetrahedron is not finite", "give finite lengths"};
    }
    const double scale = length_scale(shape.vertices);
    if (scale != 0 && !(scale >= least_extent && scale <= most_extent)) {  // equal points lie in one plane
        return extent_problem({scale, scale, scale}, false);
    }
    const double six_volumes = dot(b - a, cross(c - a, d - a));
    double largest_area = 0;
    for (const auto& face : shape.faces) {
        largest_area = std::max(largest_area, norm(vector_area(shape.vertices, face)));
    }
    // Smallest altitude: 3 V / S_max.
    if (std::abs(six_volumes) <= 2 * largest_area * flatness_tolerance * scale) {
        return GeometryProblem{"the four corners of the tetrahedron lie in one plane",
                               "give four points that span a volume"};
    }
    if (six_volumes < 0) {
        std::swap(shape.vertices[2], shape.vertices[3]);
    }
    return shape;
}

Outcome<Polyhedron> prism(int sides, double circumradius, double height) {
    if (sides < 3) {
        return too_few_sides(sides);
    }
    return extrude(regular_polygon(sides, circumradius), -0.5 * height, 0.5 * height);
}

Outcome<Polyhedron> pyramid(int sides, double circumradius, double height) {
    if (sides < 3) {
        return too_few_sides(sides);
    }
    Polyhedron shape;
    std::vector<std::int32_t> base;
    for (const Point2& corner : regular_polygon(sides, circumradius)) {
        shape.vertices.push_back({corner[0], corner[1], 0});
    }
    shape.vertices.push_back({0, 0, height});
    for (std::int32_t k = 0; k < sides; ++k) {
        base.push_back(sides - 1 - k);
        shape.faces.push_back({k, (k + 1) % sides, sides});
    }
    shape.faces.insert(shape.faces.begin(), std::move(base));
    return shape;
}

Outcome<Polyhedron> wedge(const Vec3& size, double top_begin, double top_end) {
    if (top_begin > top_end) {
        return GeometryProblem{
            fmt::format("the top of the wedge ends at {} m, before it begins at {} m", top_end, top_begin),
            "give top_begin <= top_end"};
    }
    // The profile in the x-z plane, extruded along y.
    std::vector<Point2> profile{{0, 0}, {size.x, 0}, {top_end, size.z}};
    if (top_begin < top_end) {
        profile.push_back({top_begin, size.z});
    }
    Outcome<Polyhedron> made = extruded_polygon(profile, -size.y, 0);
    if (!made) {  // its profile is too thin, a thing of its size
        return extent_problem(size, false);
    }
    Polyhedron shape = std::move(made).value();
    for (Vec3& x : shape.vertices) {
        x = {x.x, -x.z, x.y};  // (x, profile height, -y) -> (x, y, z), a turn by +90 degrees about x
    }
    return shape;
}

Polyhedron wedge(const Vec3& size) { return wedge(size, 0, 0).value(); }

Outcome<Polyhedron> extruded_polygon(std::span<const Point2> corners, double bottom, double top) {
    std::vector<GeometryProblem> problems = polygon_problems(corners);
    if (!(top > bottom) || !std::isfinite(top - bottom)) {
        problems.push_back({fmt::format("the prism reaches from {} m up to {} m", bottom, top),
                            "give finite heights, the top above the bottom"});
    }
    if (!problems.empty()) {
        return problems;
    }
    return extrude(corners, bottom, top);
}

Outcome<Polyhedron> planar_prism(std::span<const Point2> corners) {
    Outcome<Polyhedron> made = extruded_polygon(corners, -0.5, 0.5);
    if (!made) {
        return made;
    }
    Polyhedron shape = std::move(made).value();
    shape.is_internal.assign(shape.faces.size(), 0);
    shape.is_internal[0] = shape.is_internal[1] = 1;
    return shape;
}

}  // namespace riprap::geometry
