// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "riprap/core/config.hpp"

namespace riprap {

/// Three Cartesian components, by value, on host and device. `T` is `double` in model code.
template <class T>
struct Vec3T {
    T x{}, y{}, z{};

    RIPRAP_HD constexpr T& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    RIPRAP_HD constexpr const T& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

    RIPRAP_HD constexpr Vec3T& operator+=(const Vec3T& b) {
        x += b.x;
        y += b.y;
        z += b.z;
        return *this;
    }
    RIPRAP_HD constexpr Vec3T& operator-=(const Vec3T& b) {
        x -= b.x;
        y -= b.y;
        z -= b.z;
        return *this;
    }
    RIPRAP_HD constexpr Vec3T& operator*=(T s) {
        x *= s;
        y *= s;
        z *= s;
        return *this;
    }
    friend bool operator==(const Vec3T&, const Vec3T&) = default;
};

using Vec3 = Vec3T<double>;

template <class T>
RIPRAP_HD constexpr Vec3T<T> operator+(Vec3T<T> a, const Vec3T<T>& b) {
    return a += b;
}
template <class T>
RIPRAP_HD constexpr Vec3T<T> operator-(Vec3T<T> a, const Vec3T<T>& b) {
    return a -= b;
}
template <class T>
RIPRAP_HD constexpr Vec3T<T> operator-(const Vec3T<T>& a) {
    return {-a.x, -a.y, -a.z};
}
template <class T>
RIPRAP_HD constexpr Vec3T<T> operator*(Vec3T<T> a, T s) {
    return a *= s;
}
template <class T>
RIPRAP_HD constexpr Vec3T<T> operator*(T s, Vec3T<T> a) {
    return a *= s;
}
template <class T>
RIPRAP_HD constexpr Vec3T<T> operator/(const Vec3T<T>& a, T s) {
    return {a.x / s, a.y / s, a.z / s};
}
template <class T>
RIPRAP_HD constexpr T dot(const Vec3T<T>& a, const Vec3T<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
RIPRAP_HD constexpr Vec3T<T> cross(const Vec3T<T>& a, const Vec3T<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
RIPRAP_HD constexpr T norm_squared(const Vec3T<T>& a) {
    return dot(a, a);
}
template <class T>
RIPRAP_HD inline T norm(const Vec3T<T>& a) {
    return std::sqrt(dot(a, a));
}
/// a / |a|. The caller guarantees |a| > 0.
template <class T>
RIPRAP_HD inline Vec3T<T> normalized(const Vec3T<T>& a) {
    return a / norm(a);
}
template <class T>
RIPRAP_HD constexpr Vec3T<T> min(const Vec3T<T>& a, const Vec3T<T>& b) {
    return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z};
}
template <class T>
RIPRAP_HD constexpr Vec3T<T> max(const Vec3T<T>& a, const Vec3T<T>& b) {
    return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z};
}
RIPRAP_HD inline bool is_finite(const Vec3& a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Rounds to single precision, for values that are kept and not computed with.
RIPRAP_HD constexpr Vec3T<float> narrow(const Vec3& a) {
    return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}
RIPRAP_HD constexpr Vec3 widen(const Vec3T<float>& a) { return {a.x, a.y, a.z}; }

}  // namespace riprap
