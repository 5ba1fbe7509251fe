// SPDX-License-Identifier: Apache-2.0
#include "riprap/body/multisphere.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "riprap/core/index.hpp"
#include "riprap/geometry/text/number_table.hpp"

namespace riprap::body {

namespace {

constexpr double most_spheres = 8e6;  ///< of one body, or points of the lattice that they are taken from

std::string number(double x) {
    std::ostringstream out;
    out << x;
    return out.str();
}

/// Length, first and second integral over z of the merged intervals on one line.
struct LineIntegrals {
    double length{0}, first{0}, second{0};
};

LineIntegrals integrate(std::vector<std::array<double, 2>>& intervals) {
    std::ranges::sort(intervals);
    LineIntegrals sum;
    const auto add = [&sum](double low, double high) {
        sum.length += high - low;
        sum.first += 0.5 * (high * high - low * low);
        sum.second += (high * high * high - low * low * low) / 3;
    };
    double low = 0, high = 0;
    for (std::size_t k = 0; k < intervals.size(); ++k) {
        if (k == 0 || intervals[k][0] > high) {
            add(low, high);
            low = intervals[k][0];
            high = intervals[k][1];
        }
        high = std::max(high, intervals[k][1]);
    }
    add(low, high);
    return sum;
}

/// Solid angle of the triangle (a, b, c) seen from the origin [sr] [VanOosterom1983].
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double la = norm(a), lb = norm(b), lc = norm(c);
    return 2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

bool is_inside(const geometry::Polyhedron& surface, const Vec3& x) {
    double angle = 0;
    for (const auto& face : surface.faces) {
        for (std::size_t k = 2; k < face.size(); ++k) {
            angle += solid_angle(surface.vertices[at(face[0])] - x, surface.vertices[at(face[k - 1])] - x,
                                 surface.vertices[at(face[k])] - x);
        }
    }
    return angle > 2 * M_PI;
}

geometry::MassProperties box_integrals(const Vec3& size) {
    const double volume = size.x * size.y * size.z;
    return {volume, {}, (volume / 12) * Mat3::diagonal({size.x * size.x, size.y * size.y, size.z * size.z})};
}

/// Shell of a grid of counts[0] x counts[1] x counts[2] spheres.
Multisphere shell(const Vec3& size, double radius, const std::array<int, 3>& counts) {
    Multisphere shape;
    shape.shape = box_integrals(size);
    const auto place = [&](int axis, int i) {
        const double room = size[axis] - 2 * radius;
        return counts[at(axis)] > 1 ? room * (static_cast<double>(i) / (counts[at(axis)] - 1) - 0.5) : 0;
    };
    for (int i = 0; i < counts[0]; ++i) {
        for (int j = 0; j < counts[1]; ++j) {
            for (int k = 0; k < counts[2]; ++k) {
                const std::array<int, 3> index{i, j, k};
                Vec3 normal{};
                int sides = 0;
                for (int axis = 0; axis < 3; ++axis) {
                    const int side = index[at(axis)] == 0 ? -1 : index[at(axis)] == counts[at(axis)] - 1 ? 1 : 0;
                    normal[axis] += side;
                    sides += side != 0 ? 1 : 0;
                }
                if (sides > 0) {
                    shape.spheres.push_back(
                        {{place(0, i), place(1, j), place(2, k)}, radius, sides == 1 ? normal : Vec3{}});
                }
            }
        }
    }
    return shape;
}

}  // namespace

geometry::MassProperties union_of_spheres(const std::vector<ShapeSphere>& spheres, int rays) {
    if (spheres.empty()) {
        return {};
    }
    Vec3 low = spheres[0].centre, high = low;
    for (const ShapeSphere& s : spheres) {
        const Vec3 r{s.radius, s.radius, s.radius};
        low = min(low, s.centre - r);
        high = max(high, s.centre + r);
    }
    const Vec3 origin = 0.5 * (low + high), step = (high - low) / static_cast<double>(rays);
    double volume = 0;
    Vec3 first{};
    Mat3 second{};
    std::vector<std::array<double, 2>> intervals;
    for (int i = 0; i < rays; ++i) {
        for (int j = 0; j < rays; ++j) {
            const double x = low.x + (i + 0.5) * step.x - origin.x, y = low.y + (j + 0.5) * step.y - origin.y;
            intervals.clear();
            for (const ShapeSphere& s : spheres) {
                const Vec3 c = s.centre - origin;
                const double square = s.radius * s.radius - (x - c.x) * (x - c.x) - (y - c.y) * (y - c.y);
                if (square > 0) {
                    intervals.push_back({c.z - std::sqrt(square), c.z + std::sqrt(square)});
                }
            }
            const LineIntegrals line = integrate(intervals);
            volume += line.length;
            first += Vec3{x * line.length, y * line.length, line.first};
            second = second + Mat3{{{x * x * line.length, x * y * line.length, x * line.first},
                                    {x * y * line.length, y * y * line.length, y * line.first},
                                    {x * line.first, y * line.first, line.second}}};
        }
    }
    const Vec3 centroid = first / volume;
    const double area = step.x * step.y;
    return {area * volume, origin + centroid, area * (second - volume * outer(centroid, centroid))};
}

geometry::Outcome<Multisphere> box_shell(const Vec3& size, double radius) {
    const double shortest = std::min({size.x, size.y, size.z});
    if (!(radius > 0) || 2 * radius > shortest * (1 + 1e-12)) {
        return geometry::GeometryProblem{
            "spheres of radius " + number(radius) + " m do not fit into a box of " + number(shortest) + " m",
            "a radius of at most half the shortest edge"};
    }
    std::array<int, 3> counts{};
    double all = 1, inside = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double room = size[axis] - 2 * radius;
        const double count = room < 1e-9 * shortest ? 1 : 1 + std::ceil(room / (2 * radius) - 1e-9);
        counts[at(axis)] = static_cast<int>(std::min(count, 1e9));
        all *= count;
        inside *= std::max(0.0, count - 2);
    }
    if (all - inside > most_spheres || all > 1e9) {
        return geometry::GeometryProblem{
            "a shell of " + number(all - inside) + " spheres of radius " + number(radius) + " m",
            "larger spheres, at most 8 million of them"};
    }
    return shell(size, radius, counts);
}

geometry::Outcome<Multisphere> box_shell(const Vec3& size, int count) {
    if (count < 1) {
        return geometry::GeometryProblem{"no sphere along the shortest edge", "a count of at least 1"};
    }
    return box_shell(size, std::min({size.x, size.y, size.z}) / (2 * count));
}

geometry::Outcome<Multisphere> rectangle_shell(const Vec3& size, double radius) {
    auto box = box_shell({size.x, size.y, 2 * radius}, radius);
    if (!box) {
        return box;
    }
    Multisphere shape = std::move(box).value();
    std::erase_if(shape.spheres, [&](ShapeSphere& s) {
        const auto side = [&](int axis) {
            const bool is_outermost = std::abs(s.centre[axis]) + radius >= 0.5 * size[axis] * (1 - 1e-9);
            return !is_outermost ? 0 : s.centre[axis] > 0 ? 1 : -1;
        };
        const int x = side(0), y = side(1);
        s.face_normal = x == 0 || y == 0 ? Vec3{static_cast<double>(x), static_cast<double>(y), 0} : Vec3{};
        return x == 0 && y == 0;
    });
    return shape;
}

geometry::Outcome<Multisphere> ring(double outer_radius, double sphere_radius, int count, double length) {
    if (count < 3 || !(sphere_radius > 0) || !(outer_radius > sphere_radius) || !(length > 0)) {
        return geometry::GeometryProblem{"a ring of " + std::to_string(count) + " spheres of radius " +
                                             number(sphere_radius) + " m in a circle of " + number(outer_radius) + " m",
                                         "three spheres or more, smaller than the circle, and a length above zero"};
    }
    Multisphere shape;
    const double volume = M_PI * outer_radius * outer_radius * length, square = outer_radius * outer_radius / 4;
    shape.shape = {volume, {}, volume * Mat3::diagonal({square, square, length * length / 12})};
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * M_PI * k / count;
        const Vec3 outward{std::cos(angle), std::sin(angle), 0};
        shape.spheres.push_back({(outer_radius - sphere_radius) * outward, sphere_radius, outward});
    }
    return shape;
}

geometry::Outcome<Multisphere> fill_surface(const geometry::Polyhedron& surface, double spacing) {
    Multisphere shape;
    shape.shape = mass_properties(surface);
    if (!(shape.shape.volume > 0) || !(spacing > 0)) {
        return geometry::GeometryProblem{"the surface encloses no volume, or the spacing is not above zero",
                                         "a closed surface with outward faces"};
    }
    Vec3 low = surface.vertices[0], high = low;
    for (const Vec3& v : surface.vertices) {
        low = min(low, v);
        high = max(high, v);
    }
    std::array<std::int64_t, 3> count{};
    Vec3 first{};
    double all = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double extent = high[axis] - low[axis];
        count[at(axis)] = std::max<std::int64_t>(1, std::llround(std::min(extent / spacing, 1e9)));
        all *= static_cast<double>(count[at(axis)]);
        first[axis] = 0.5 * (low[axis] + high[axis]) - 0.5 * spacing * static_cast<double>(count[at(axis)] - 1);
    }
    if (all > most_spheres) {
        return geometry::GeometryProblem{number(all) + " lattice points", "a spacing with at most 8 million"};
    }
    const std::int64_t total = count[0] * count[1] * count[2];
    std::vector<std::uint8_t> inside(at(total), 0);
    const auto place = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
        return first + spacing * Vec3{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
    };
    const auto number_of = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
        return at((i * count[1] + j) * count[2] + k);
    };
    const auto has = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
        return i >= 0 && j >= 0 && k >= 0 && i < count[0] && j < count[1] && k < count[2] &&
               inside[number_of(i, j, k)] != 0;
    };
    const auto each = [&](const auto& f) {
        for (std::int64_t i = 0; i < count[0]; ++i) {
            for (std::int64_t j = 0; j < count[1]; ++j) {
                for (std::int64_t k = 0; k < count[2]; ++k) {
                    f(i, j, k);
                }
            }
        }
    };
    each([&](auto i, auto j, auto k) { inside[number_of(i, j, k)] = is_inside(surface, place(i, j, k)) ? 1 : 0; });
    each([&](auto i, auto j, auto k) {
        const bool is_deep = has(i - 1, j, k) && has(i + 1, j, k) && has(i, j - 1, k) && has(i, j + 1, k) &&
                             has(i, j, k - 1) && has(i, j, k + 1);
        if (has(i, j, k) && !is_deep) {
            shape.spheres.push_back({place(i, j, k), 0.5 * spacing, {}});
        }
    });
    return checked(std::move(shape));
}

geometry::Outcome<Multisphere> read_sphere_list(const std::string& text, const std::string& name) {
    geometry::TableForm form = geometry::table_of_places(static_cast<std::int64_t>(most_spheres));
    form.columns.push_back({"radius", {"radius", "r"}});
    Multisphere shape;
    try {
        const geometry::NumberTable table = geometry::read_number_table(text, name, form);
        for (std::size_t i = 0; i < table.row_count(); ++i) {
            shape.spheres.push_back({{table.at(i, 0), table.at(i, 1), table.at(i, 2)}, table.at(i, 3), {}});
        }
    } catch (const CaseError& error) {
        std::vector<geometry::GeometryProblem> problems;
        for (Diagnostic problem : error.problems()) {
            std::string allowed = std::exchange(problem.allowed, {});
            problems.push_back({to_string(problem), std::move(allowed)});
        }
        return problems;
    }
    if (shape.spheres.empty()) {
        return geometry::GeometryProblem{name + " lists no sphere", "lines x y z radius in metres"};
    }
    return checked(std::move(shape));
}

geometry::Outcome<Multisphere> checked(Multisphere shape) {
    std::vector<geometry::GeometryProblem> problems;
    if (shape.spheres.empty()) {
        problems.push_back({"no sphere lies in the shape", "smaller spheres"});
    }
    double reach = 0;  // of the largest sphere or of the farthest centre
    for (const ShapeSphere& s : shape.spheres) {
        reach = std::max({reach, s.radius, norm(s.centre)});
    }
    constexpr double resolution = 1e-8;  // of the reach: overlaps are small shares of a radius
    for (std::size_t i = 0; i < shape.spheres.size(); ++i) {
        const ShapeSphere& s = shape.spheres[i];
        const bool is_lost = s.radius < resolution * reach || !std::isnormal(s.radius * s.radius * s.radius);
        if (!(s.radius > 0) || !is_finite(s.centre)) {
            problems.push_back({"sphere " + std::to_string(i + 1) + " has radius " + number(s.radius) + " m",
                                "a radius above zero and finite coordinates"});
        } else if (is_lost) {
            problems.push_back({"sphere " + std::to_string(i + 1) + " has radius " + number(s.radius) +
                                    " m in a body of " + number(reach) + " m",
                                "at least " + number(resolution) + " of the body"});
        }
    }
    // Sorted by x, a sphere inside another one lies within the larger radius of it.
    std::vector<std::size_t> order(shape.spheres.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = i;
    }
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return shape.spheres[i].centre.x; });
    double largest = 0;
    for (const ShapeSphere& s : shape.spheres) {
        largest = std::max(largest, s.radius);
    }
    for (std::size_t k = 0; k < order.size() && problems.empty(); ++k) {
        const ShapeSphere& a = shape.spheres[order[k]];
        for (std::size_t l = k + 1; l < order.size(); ++l) {
            const ShapeSphere& b = shape.spheres[order[l]];
            if (b.centre.x - a.centre.x > largest) {
                break;
            }
            if (norm(b.centre - a.centre) <= std::abs(a.radius - b.radius) * (1 + 1e-12)) {
                problems.push_back({"spheres " + std::to_string(order[k] + 1) + " and " + std::to_string(order[l] + 1) +
                                        " are equal, or one lies inside the other",
                                    "each sphere once"});
            }
        }
    }
    if (!problems.empty()) {
        return problems;
    }
    return shape;
}

}  // namespace riprap::body
