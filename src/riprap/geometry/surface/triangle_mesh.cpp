// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/surface/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "riprap/core/index.hpp"
#include "riprap/geometry/polyhedra/fan.hpp"
#include "riprap/geometry/surface/surface.hpp"

namespace riprap::geometry {

namespace {

/// A triangle with less than this share of the area of a square on its longest edge has none.
constexpr double flat = 1e-9;

bool has_area(const TriangleMesh& mesh, std::int32_t t) {
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
        longest = std::max(longest, norm_squared(mesh.corner(t, (k + 1) % 3) - mesh.corner(t, k)));
    }
    return norm(mesh.area_normal(t)) > flat * longest;
}

}  // namespace

TriangleMesh welded(const TriangleMesh& mesh, double tolerance) {
    // Points in order along a direction in which few are level; each joins the first within the tolerance.
    constexpr Vec3 askew{0.5411961, 0.3826834, 0.7488071};
    const double stretched = tolerance * norm(askew);
    std::vector<double> height(mesh.points.size());
    std::transform(mesh.points.begin(), mesh.points.end(), height.begin(),
                   [&askew](const Vec3& x) { return dot(askew, x); });
    std::vector<std::int32_t> order(mesh.points.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::int32_t a, std::int32_t b) { return height[at(a)] < height[at(b)]; });
    std::vector<std::int32_t> first(mesh.points.size(), -1);
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (first[at(order[i])] >= 0) {
            continue;
        }
        first[at(order[i])] = order[i];
        const Vec3& x = mesh.points[at(order[i])];
        for (std::size_t j = i + 1; j < order.size() && height[at(order[j])] - height[at(order[i])] <= stretched; ++j) {
            if (first[at(order[j])] < 0 && norm(mesh.points[at(order[j])] - x) <= tolerance) {
                first[at(order[j])] = order[i];
            }
        }
    }
    TriangleMesh result;
    std::vector<std::int32_t> number(mesh.points.size(), -1);
    for (std::size_t p = 0; p < mesh.points.size(); ++p) {
        if (first[p] == static_cast<std::int32_t>(p)) {
            number[p] = static_cast<std::int32_t>(result.points.size());
            result.points.push_back(mesh.points[p]);
        }
    }
    for (std::size_t t = 0; t < mesh.corners.size(); ++t) {
        const std::array<std::int32_t, 3>& corners = mesh.corners[t];
        std::array<std::int32_t, 3> joined{};
        std::transform(corners.begin(), corners.end(), joined.begin(),
                       [&](std::int32_t p) { return number[at(first[at(p)])]; });
        result.corners.push_back(joined);
        const bool is_collapsed = joined[0] == joined[1] || joined[1] == joined[2] || joined[2] == joined[0];
        if (is_collapsed || !has_area(result, result.size() - 1)) {
            result.corners.pop_back();
        } else if (!mesh.faces.empty()) {
            result.faces.push_back(mesh.faces[t]);
        }
    }
    return result;
}

TriangleMesh mesh_of(const Surface& surface, double tolerance) {
    TriangleMesh mesh;
    mesh.points = surface.vertices;
    for (std::size_t f = 0; f < surface.face_count(); ++f) {
        for (const auto& triangle : triangles_of(surface.vertices, surface.face(f))) {
            mesh.corners.push_back(triangle);
            mesh.faces.push_back(static_cast<std::int32_t>(f));
        }
    }
    return welded(mesh, tolerance * (mesh.points.empty() ? 1 : length_scale(mesh.points)));
}

Vec3 main_direction(const TriangleMesh& mesh) {
    constexpr double closed = 1e-6;  // of the area
    Vec3 sum{};
    double area = 0;
    for (std::int32_t t = 0; t < mesh.size(); ++t) {
        const Vec3 n = mesh.area_normal(t);
        sum += n;
        area += norm(n);
    }
    return norm(sum) > closed * area ? normalized(sum) : Vec3{0, 0, 1};
}

}  // namespace riprap::geometry
