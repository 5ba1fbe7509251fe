// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <random>
#include <vector>

#include "riprap/linear/block_csr.hpp"

namespace riprap::linear {

/// Blocks in a chain that also touch `reach` further on, tied by springs of random stiffness: symmetric positive
/// definite, B unknowns each, whose scales differ by up to `contrast`.
template <int B>
BlockCsr<B> spring_chain(std::int32_t rows, std::int32_t reach, double contrast = 1) {
    std::vector<std::array<std::int32_t, 2>> pairs;
    for (std::int32_t i = 0; i < rows; ++i) {
        for (const std::int32_t j : {i + 1, i + reach}) {
            if (j < rows) {
                pairs.push_back({j, i});
            }
        }
    }
    BlockCsr<B> a(symmetric_pattern(rows, pairs));
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto scale = [&](int k) { return std::pow(contrast, static_cast<double>(k) / B); };
    for (std::int32_t i = 0; i < rows; ++i) {
        for (int k = 0; k < B; ++k) {
            a.at(a.pattern().find(i, i), k, k) += 0.01 * scale(k) * scale(k);
        }
    }
    for (const auto& [i, j] : pairs) {
        // energy (w.x_i - u.x_j)^2/2
        double w[B], u[B];
        for (int k = 0; k < B; ++k) {
            w[k] = scale(k) * (1 + number(random));
            u[k] = scale(k) * (1 + number(random));
        }
        for (int r = 0; r < B; ++r) {
            for (int c = 0; c < B; ++c) {
                a.at(a.pattern().find(i, i), r, c) += w[r] * w[c];
                a.at(a.pattern().find(j, j), r, c) += u[r] * u[c];
                a.at(a.pattern().find(i, j), r, c) -= w[r] * u[c];
                a.at(a.pattern().find(j, i), r, c) -= u[r] * w[c];
            }
        }
    }
    return a;
}

/// The five-point Laplacian of a square of n x n cells with p = 0 all around, cell size 1: an M-matrix.
inline BlockCsr<1> laplacian(std::int32_t n) {
    std::vector<std::array<std::int32_t, 2>> pairs;
    for (std::int32_t row = 0; row < n * n; ++row) {
        if (row % n + 1 < n) {
            pairs.push_back({row, row + 1});
        }
        if (row + n < n * n) {
            pairs.push_back({row, row + n});
        }
    }
    BlockCsr<1> a(symmetric_pattern(std::int64_t{n} * n, pairs));
    for (std::int64_t row = 0; row < a.rows(); ++row) {
        for (std::int64_t e = a.pattern().first(row); e < a.pattern().end(row); ++e) {
            a.at(e, 0, 0) = a.pattern().column_of(e) == row ? 4 : -1;
        }
    }
    return a;
}

template <int B>
Eigen::SparseMatrix<double> to_eigen(const BlockCsr<B>& a) {
    std::vector<Eigen::Triplet<double>> numbers;
    for (std::int64_t row = 0; row < a.rows(); ++row) {
        for (std::int64_t e = a.pattern().first(row); e < a.pattern().end(row); ++e) {
            for (int r = 0; r < B; ++r) {
                for (int c = 0; c < B; ++c) {
                    numbers.emplace_back(static_cast<int>(row) * B + r, a.pattern().column_of(e) * B + c,
                                         a.at(e, r, c));
                }
            }
        }
    }
    const auto size = static_cast<int>(a.size());
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(numbers.begin(), numbers.end());
    return matrix;
}

inline std::vector<double> random_vector(std::size_t size, std::uint64_t seed = 3) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<double> v(size);
    for (double& x : v) {
        x = number(random);
    }
    return v;
}

inline Eigen::VectorXd to_eigen(const std::vector<double>& v) {
    return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size()));
}

}  // namespace riprap::linear
