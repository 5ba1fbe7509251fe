// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/polyhedra/fan.hpp"

#include <algorithm>

#include "riprap/core/index.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry {

namespace {

using Triangle = std::array<std::int32_t, 3>;

// Bounds of the time that a hostile file may cost.
constexpr std::size_t most_corners = 1000;
constexpr std::size_t tries_per_corner = 20;

class EarCutter {
 public:
    EarCutter(std::span<const Vec3> vertices, std::span<const std::int32_t> face)
        : vertices_(vertices), normal_(vector_area(vertices, face)), left_(face.begin(), face.end()) {}

    std::vector<Triangle> cut() {
        std::vector<Triangle> triangles;
        std::size_t k = 0, tried = 0;
        std::size_t tries = left_.size() <= most_corners ? tries_per_corner * left_.size() : 0;
        while (left_.size() > 3 && tried < left_.size() && tries-- > 0) {
            if (is_ear(k)) {
                triangles.push_back(corner(k));
                left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(k));
                k = k % left_.size();
                tried = 0;
            } else {
                k = (k + 1) % left_.size();
                ++tried;
            }
        }
        for (std::size_t i = 2; i < left_.size(); ++i) {
            triangles.push_back({left_[0], left_[i - 1], left_[i]});
        }
        return triangles;
    }

 private:
    Triangle corner(std::size_t k) const {
        const std::size_t n = left_.size();
        return {left_[(k + n - 1) % n], left_[k], left_[(k + 1) % n]};
    }
    /// Twice the area of a triangle, seen along the normal of the polygon; below zero where it turns against it.
    double turn(std::int32_t a, std::int32_t b, std::int32_t c) const {
        const Vec3& x = vertices_[at(a)];
        return dot(normal_, cross(vertices_[at(b)] - x, vertices_[at(c)] - x));
    }
    bool is_ear(std::size_t k) const {
        const auto [a, b, c] = corner(k);
        if (!(turn(a, b, c) > 0)) {
            return false;
        }
        return std::none_of(left_.begin(), left_.end(), [&, a = a, b = b, c = c](std::int32_t p) {
            return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        });
    }

    std::span<const Vec3> vertices_;
    Vec3 normal_;
    std::vector<std::int32_t> left_;
};

}  // namespace

std::vector<std::array<std::int32_t, 3>> triangles_of(std::span<const Vec3> vertices,
                                                      std::span<const std::int32_t> face) {
    std::vector<Triangle> fan;
    for (std::size_t k = 2; k < face.size(); ++k) {
        fan.push_back({face[0], face[k - 1], face[k]});
    }
    if (fan.size() < 2) {
        return fan;
    }
    const Vec3 normal = vector_area(vertices, face);
    const bool is_plain = std::all_of(fan.begin(), fan.end(), [&](const Triangle& t) {
        const Vec3& x = vertices[at(t[0])];
        return dot(normal, cross(vertices[at(t[1])] - x, vertices[at(t[2])] - x)) >= 0;
    });
    return is_plain ? fan : EarCutter(vertices, face).cut();
}

}  // namespace riprap::geometry
