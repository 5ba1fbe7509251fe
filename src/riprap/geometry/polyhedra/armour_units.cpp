// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/armour_units.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "riprap/geometry/polyhedra/clip.hpp"
#include "riprap/geometry/polyhedra/shapes.hpp"

namespace riprap::geometry {

namespace {

/// A box, or an arm that narrows along an axis from a square of `base` to one of `tip`.
Polyhedron arm(const Vec3& foot, int axis, double sign, double base, double tip, double length) {
    Vec3 size{base, base, base};
    size[axis] = length;
    Polyhedron part = box(size);
    for (Vec3& x : part.vertices) {
        if (sign * x[axis] > 0) {
            for (int a = 0; a < 3; ++a) {
                x[a] *= a == axis ? 1 : tip / base;
            }
        }
        x[axis] += 0.5 * sign * length;
        x += foot;
    }
    return part;
}

Polyhedron block(const Vec3& centre, double edge) {
    Polyhedron part = cube(edge);
    for (Vec3& x : part.vertices) {
        x += centre;
    }
    return part;
}

/// A cube with two arms along an axis.
void add_fluke(std::vector<Polyhedron>& parts, const Vec3& centre, int axis, double base, double tip, double length) {
    parts.push_back(block(centre, base));
    for (const double sign : {1.0, -1.0}) {
        Vec3 foot = centre;
        foot[axis] += 0.5 * sign * base;
        parts.push_back(arm(foot, axis, sign, base, tip, length));
    }
}

/// A frustum with twelve sides about a unit vector, from `begin` to `end` along it.
Polyhedron frustum(const Vec3& along, const Vec3& first, double begin, double end, double radius, double taper) {
    constexpr int sides = 12;
    const Vec3 second = cross(along, first);
    Polyhedron part;
    std::vector<std::int32_t> low, high;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / sides;
        const Vec3 out = std::cos(angle) * first + std::sin(angle) * second;
        part.vertices.push_back(begin * along + (radius - taper * begin) * out);
        part.vertices.push_back(end * along + (radius - taper * end) * out);
        low.insert(low.begin(), 2 * i);
        high.push_back(2 * i + 1);
    }
    part.faces.push_back(low);
    part.faces.push_back(high);
    for (int i = 0; i < sides; ++i) {
        const int next = (i + 1) % sides;
        part.faces.push_back({2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    }
    return part;
}

/// Every leg keeps the points that lie nearer to its direction than to any other.
std::vector<Polyhedron> tetrapod() {
    const double s = 1 / std::sqrt(3.0);
    const std::array<Vec3, 4> legs{Vec3{s, s, s}, Vec3{s, -s, -s}, Vec3{-s, s, -s}, Vec3{-s, -s, s}};
    constexpr double radius = 0.40, taper = 0.17;  // at the middle, and its loss along a leg of length 1
    std::vector<Polyhedron> parts;
    for (std::size_t i = 0; i < legs.size(); ++i) {
        const Vec3& other = legs[(i + 1) % 4];
        Polyhedron leg = frustum(legs[i], normalized(other - dot(other, legs[i]) * legs[i]), -0.3, 1, radius, taper);
        for (std::size_t j = 0; j < legs.size(); ++j) {
            if (j != i) {
                leg = clip_convex(leg, {normalized(legs[j] - legs[i]), 0});
            }
        }
        parts.push_back(std::move(leg));
    }
    return parts;
}

std::vector<Polyhedron> make_unit(ArmourUnit unit) {
    std::vector<Polyhedron> parts;
    switch (unit) {
        case ArmourUnit::cube:
            parts.push_back(cube(1));
            break;
        case ArmourUnit::tetrapod:
            return tetrapod();
        case ArmourUnit::accropode:
            add_fluke(parts, {}, 2, 1, 0.62, 0.62);
            for (const double sign : {1.0, -1.0}) {
                parts.push_back(arm({0.5 * sign, 0, 0}, 0, sign, 1, 0.62, 0.62));
                parts.push_back(arm({0, 0.5 * sign, 0}, 1, sign, 1, 0.45, 0.40));
            }
            break;
        case ArmourUnit::dolos:
            parts.push_back(arm({-0.5, 0, 0}, 0, 1, 1, 1, 1));
            add_fluke(parts, {-1, 0, 0}, 1, 1, 0.7, 1.05);
            add_fluke(parts, {1, 0, 0}, 2, 1, 0.7, 1.05);
            break;
        case ArmourUnit::core_loc:
            add_fluke(parts, {}, 1, 1, 0.65, 0.95);
            for (const double sign : {1.0, -1.0}) {
                parts.push_back(arm({0.5 * sign, 0, 0}, 0, sign, 1, 1, 0.35));
                add_fluke(parts, {1.35 * sign, 0, 0}, 2, 1, 0.65, 0.75);
            }
            break;
    }
    return parts;
}

using Corners = std::vector<Point2>;

Corners square(double x, double y, double edge) {
    const double h = 0.5 * edge;
    return {{x - h, y - h}, {x + h, y - h}, {x + h, y + h}, {x - h, y + h}};
}

/// An arm that narrows from `base` at a foot to `tip` at `length`, turned by quarters.
Corners planar_arm(double x, double y, int quarter, double base, double tip, double length) {
    constexpr std::array<int, 4> cosine{1, 0, -1, 0}, sine{0, 1, 0, -1};
    const int c = cosine[static_cast<std::size_t>(quarter)], s = sine[static_cast<std::size_t>(quarter)];
    Corners corners;
    for (const Point2& p :
         {Point2{0, -0.5 * base}, Point2{length, -0.5 * tip}, Point2{length, 0.5 * tip}, Point2{0, 0.5 * base}}) {
        corners.push_back({x + c * p[0] - s * p[1], y + s * p[0] + c * p[1]});
    }
    return corners;
}

void add_planar_fluke(std::vector<Corners>& parts, double x, double tip, double length) {
    parts.push_back(square(x, 0, 1));
    parts.push_back(planar_arm(x, 0.5, 1, 1, tip, length));
    parts.push_back(planar_arm(x, -0.5, 3, 1, tip, length));
}

/// Three legs that meet along the lines half way between them.
std::vector<Corners> planar_tetrapod() {
    constexpr double root = 0.36, tip = 0.22;  // half widths
    const double along = root / std::tan(std::numbers::pi / 3);
    std::vector<Corners> parts;
    for (int leg = 0; leg < 3; ++leg) {
        const double angle = std::numbers::pi * (0.5 + 2.0 * leg / 3), c = std::cos(angle), s = std::sin(angle);
        Corners corners;
        for (const Point2& p :
             {Point2{0, 0}, Point2{along, -root}, Point2{1, -tip}, Point2{1, tip}, Point2{along, root}}) {
            corners.push_back({c * p[0] - s * p[1], s * p[0] + c * p[1]});
        }
        parts.push_back(std::move(corners));
    }
    return parts;
}

std::vector<Corners> make_planar_unit(ArmourUnit unit) {
    std::vector<Corners> parts;
    switch (unit) {
        case ArmourUnit::cube:
            parts.push_back(square(0, 0, 1));
            break;
        case ArmourUnit::tetrapod:
            return planar_tetrapod();
        case ArmourUnit::accropode:
            add_planar_fluke(parts, 0, 0.62, 0.62);
            parts.push_back(planar_arm(0.5, 0, 0, 1, 0.45, 0.40));
            parts.push_back(planar_arm(-0.5, 0, 2, 1, 0.45, 0.40));
            break;
        case ArmourUnit::dolos:
            parts.push_back(square(0, 0, 1));
            add_planar_fluke(parts, -1, 0.7, 1.05);
            add_planar_fluke(parts, 1, 0.7, 1.05);
            break;
        case ArmourUnit::core_loc:
            add_planar_fluke(parts, 0, 0.65, 0.45);
            for (const double sign : {1.0, -1.0}) {
                parts.push_back(square(sign, 0, 1));
                add_planar_fluke(parts, 2 * sign, 0.65, 0.75);
            }
            break;
    }
    return parts;
}

}  // namespace

std::vector<Polyhedron> armour_unit(ArmourUnit unit, double nominal_diameter) {
    std::vector<Polyhedron> parts = make_unit(unit);
    double volume = 0;
    for (const Polyhedron& part : parts) {
        volume += mass_properties(part).volume;
    }
    const double scale = nominal_diameter / std::cbrt(volume);
    for (Polyhedron& part : parts) {
        for (Vec3& x : part.vertices) {
            x *= scale;
        }
    }
    return parts;
}

std::vector<Polyhedron> planar_armour_unit(ArmourUnit unit, double nominal_diameter) {
    std::vector<Corners> parts = make_planar_unit(unit);
    double area = 0;
    for (const Corners& part : parts) {
        for (std::size_t i = 0; i < part.size(); ++i) {
            const Point2 &p = part[i], &q = part[(i + 1) % part.size()];
            area += 0.5 * (p[0] * q[1] - p[1] * q[0]);
        }
    }
    const double scale = nominal_diameter / std::sqrt(area);
    std::vector<Polyhedron> prisms;
    for (Corners& part : parts) {
        for (Point2& p : part) {
            p[0] *= scale;
            p[1] *= scale;
        }
        prisms.push_back(planar_prism(part).value());
    }
    return prisms;
}

}  // namespace riprap::geometry
