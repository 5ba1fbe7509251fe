// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace riprap::linear {

/// A symmetric block is inverted as positive definite while each pivot is more than this share of its diagonal number.
inline constexpr double least_pivot = 1e-14;

/// Inverts the symmetric positive definite B x B block `a` (columns or rows, it is symmetric; the lower triangle by
/// columns is read) by A = L L^T, A^-1 = L^-T L^-1. Returns false, `inverse` unusable, where a pivot is not positive:
/// below `least_pivot` of its diagonal number.
template <int B>
bool invert_spd(const double* a, double* inverse) {
    double l[B][B]{};  // then L^-1, in place
    for (int j = 0; j < B; ++j) {
        double pivot = a[j * B + j];
        for (int k = 0; k < j; ++k) {
            pivot -= l[j][k] * l[j][k];
        }
        if (!(pivot > least_pivot * a[j * B + j])) {
            return false;
        }
        l[j][j] = std::sqrt(pivot);
        for (int i = j + 1; i < B; ++i) {
            double sum = a[j * B + i];
            for (int k = 0; k < j; ++k) {
                sum -= l[i][k] * l[j][k];
            }
            l[i][j] = sum / l[j][j];
        }
    }
    for (int j = 0; j < B; ++j) {
        l[j][j] = 1 / l[j][j];
        for (int i = j + 1; i < B; ++i) {
            double sum = 0;
            for (int k = j; k < i; ++k) {
                sum -= l[i][k] * l[k][j];
            }
            l[i][j] = sum / l[i][i];
        }
    }
    for (int i = 0; i < B; ++i) {
        for (int j = 0; j <= i; ++j) {
            double sum = 0;
            for (int k = i; k < B; ++k) {
                sum += l[k][i] * l[k][j];
            }
            inverse[i * B + j] = inverse[j * B + i] = sum;
        }
    }
    return std::isfinite(inverse[0]);
}

/// y += sign A x for a block stored by columns.
template <int B>
inline void add_product(double sign, const double* a, const double* x, double* y) {
    for (int c = 0; c < B; ++c) {
        for (int r = 0; r < B; ++r) {
            y[r] += sign * a[c * B + r] * x[c];
        }
    }
}
/// y += sign A^T x
template <int B>
inline void add_transposed_product(double sign, const double* a, const double* x, double* y) {
    for (int c = 0; c < B; ++c) {
        double sum = 0;
        for (int r = 0; r < B; ++r) {
            sum += a[c * B + r] * x[r];
        }
        y[c] += sign * sum;
    }
}

}  // namespace riprap::linear
