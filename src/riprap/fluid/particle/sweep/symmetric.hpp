// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "riprap/core/vec3.hpp"

namespace riprap::fluid {

// Symmetric tensors in pair physics are six numbers in the order xx, yy, xy, zz, xz, yz; planar scenes use the first
// three.

inline constexpr int symmetric_numbers = 6;

/// Number of components that a dimension uses.
template <int Dim>
inline constexpr int symmetric_used = Dim == 2 ? 3 : 6;

/// out = (a b^T + b a^T)/2
template <int Dim, class Real>
RIPRAP_HD void symmetric_product(const Real* a, const Real* b, Real* out) {
    const Real half(0.5);
    out[0] = a[0] * b[0];
    out[1] = a[1] * b[1];
    out[2] = half * (a[0] * b[1] + a[1] * b[0]);
    if constexpr (Dim == 3) {
        out[3] = a[2] * b[2];
        out[4] = half * (a[0] * b[2] + a[2] * b[0]);
        out[5] = half * (a[1] * b[2] + a[2] * b[1]);
    }
}

/// out = a a^T
template <int Dim, class Real>
RIPRAP_HD void symmetric_square(const Real* a, Real* out) {
    out[0] = a[0] * a[0];
    out[1] = a[1] * a[1];
    out[2] = a[0] * a[1];
    if constexpr (Dim == 3) {
        out[3] = a[2] * a[2];
        out[4] = a[0] * a[2];
        out[5] = a[1] * a[2];
    }
}

/// out = tensor a
template <int Dim, class Real>
RIPRAP_HD void symmetric_apply(const Real* tensor, const Real* a, Real* out) {
    out[0] = tensor[0] * a[0] + tensor[2] * a[1];
    out[1] = tensor[2] * a[0] + tensor[1] * a[1];
    if constexpr (Dim == 3) {
        out[0] = out[0] + tensor[4] * a[2];
        out[1] = out[1] + tensor[5] * a[2];
        out[2] = tensor[4] * a[0] + tensor[5] * a[1] + tensor[3] * a[2];
    }
}

/// tensor a, of tensors on the host
inline Vec3 symmetric_apply(const std::array<double, symmetric_numbers>& t, const Vec3& a) {
    return {t[0] * a.x + t[2] * a.y + t[4] * a.z, t[2] * a.x + t[1] * a.y + t[5] * a.z,
            t[4] * a.x + t[5] * a.y + t[3] * a.z};
}

}  // namespace riprap::fluid
