// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/mat3.hpp"

#include <algorithm>

namespace riprap {

SymmetricEigen symmetric_eigen(const Mat3& m) {
    Mat3 a = m;
    Mat3 axes = Mat3::identity();
    double scale = 0;
    for (const Vec3& row : m.row) {
        scale = std::max({scale, std::abs(row.x), std::abs(row.y), std::abs(row.z)});
    }
    const int max_sweeps = 50;
    for (int sweep = 0; sweep < max_sweeps; ++sweep) {
        const double off = std::max({std::abs(a(0, 1)), std::abs(a(0, 2)), std::abs(a(1, 2))});
        if (off <= 1e-14 * scale) {
            break;
        }
        for (int p = 0; p < 2; ++p) {
            for (int q = p + 1; q < 3; ++q) {
                if (a(p, q) == 0) {
                    continue;
                }
                // Rotation by the smaller angle that annihilates a(p,q): t = tan of it.
                const double theta = 0.5 * (a(q, q) - a(p, p)) / a(p, q);
                const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1));
                const double c = 1 / std::sqrt(t * t + 1), s = t * c;
                Mat3 g = Mat3::identity();
                g(p, p) = g(q, q) = c;
                g(p, q) = s;
                g(q, p) = -s;
                a = transpose(g) * a * g;
                axes = axes * g;
            }
        }
    }
    return {{a(0, 0), a(1, 1), a(2, 2)}, axes};
}

}  // namespace riprap
