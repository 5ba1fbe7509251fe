// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace riprap::geometry {

/// A point or a direction of the x-y plane [m] or [-].
struct Vec2 {
    double x{0}, y{0};

    Vec2& operator+=(const Vec2& b) {
        x += b.x;
        y += b.y;
        return *this;
    }
    friend bool operator==(const Vec2&, const Vec2&) = default;
};

inline Vec2 operator+(const Vec2& a, const Vec2& b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(const Vec2& a, const Vec2& b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator-(const Vec2& a) { return {-a.x, -a.y}; }
inline Vec2 operator*(double s, const Vec2& a) { return {s * a.x, s * a.y}; }
inline double dot(const Vec2& a, const Vec2& b) { return a.x * b.x + a.y * b.y; }
/// The component along z of a x b: positive when b lies counter-clockwise of a.
inline double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }
inline double norm(const Vec2& a) { return std::sqrt(dot(a, a)); }

}  // namespace riprap::geometry
