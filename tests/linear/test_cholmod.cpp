// SPDX-License-Identifier: Apache-2.0
// Our conjugate gradients against the sparse Cholesky factors of CHOLMOD, where CMake finds it (Debian:
// libsuitesparse-dev). Its supernodal part is under the GPL: no program that is handed out links it.
#ifdef RIPRAP_CHOLMOD
#include <gtest/gtest.h>
#include <suitesparse/cholmod.h>

#include <algorithm>
#include <cmath>

#include "riprap/linear/block_jacobi.hpp"
#include "riprap/linear/vector_ops.hpp"
#include "systems.hpp"

namespace riprap::linear {
namespace {

struct Session {
    cholmod_common common{};
    Session() {
        cholmod_start(&common);
        common.print = 0;
        common.final_ll = 1;  // factors L D L^T of small matrices would take negative pivots too
        common.quick_return_if_not_posdef = 1;
    }
    ~Session() { cholmod_finish(&common); }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
};

/// The upper triangle by columns; columns of a symmetric matrix are its rows.
template <int B>
cholmod_sparse* upper_triangle(const BlockCsr<B>& a, cholmod_common& common) {
    const std::size_t n = a.size();
    cholmod_sparse* upper = cholmod_allocate_sparse(n, n, static_cast<std::size_t>(a.pattern().entries()) * B * B, 1, 1,
                                                    1, CHOLMOD_REAL, &common);
    auto* start = static_cast<int*>(upper->p);
    auto* row = static_cast<int*>(upper->i);
    auto* value = static_cast<double*>(upper->x);
    int count = 0;
    for (std::int64_t column = 0; column < a.rows(); ++column) {
        for (int c = 0; c < B; ++c) {
            start[column * B + c] = count;
            for (std::int64_t e = a.pattern().first(column); e < a.pattern().end(column); ++e) {
                const std::int64_t other = a.pattern().column_of(e);
                for (int r = 0; r < B && other * B + r <= column * B + c; ++r) {
                    row[count] = static_cast<int>(other * B + r);
                    value[count++] = a.at(e, c, r);  // A(column, other) is A(other, column) transposed
                }
            }
        }
    }
    start[n] = count;
    return upper;
}

/// Solves A x = b, A symmetric and positive definite: analysis, factors and solution anew in every call.
template <int B>
SolveReport solve_cholmod(const BlockCsr<B>& a, std::span<const double> b, std::span<double> x) {
    Session session;
    cholmod_common& common = session.common;
    SolveReport report;
    cholmod_sparse* matrix = upper_triangle(a, common);
    cholmod_factor* factor = cholmod_analyze(matrix, &common);
    cholmod_factorize(matrix, factor, &common);
    if (common.status != CHOLMOD_OK) {
        report.status = SolveStatus::not_positive_definite;
    } else {
        cholmod_dense* right = cholmod_allocate_dense(a.size(), 1, a.size(), CHOLMOD_REAL, &common);
        std::copy(b.begin(), b.end(), static_cast<double*>(right->x));
        cholmod_dense* solution = cholmod_solve(CHOLMOD_A, factor, right, &common);
        const auto* found = static_cast<const double*>(solution->x);
        std::copy(found, found + a.size(), x.begin());
        cholmod_free_dense(&right, &common);
        cholmod_free_dense(&solution, &common);
        std::vector<double> left(a.size()), rest(a.size());
        a.multiply(x, left);
        const double size = std::sqrt(dot(b, b));
        report.residual = size > 0 ? std::sqrt(subtract(b, left, rest)) / size : 0;
        report.iterations = 1;
    }
    cholmod_free_factor(&factor, &common);
    cholmod_free_sparse(&matrix, &common);
    return report;
}

TEST(Cholmod, conjugate_gradients_find_what_its_factors_find) {
    const BlockCsr<12> a = spring_chain<12>(60, 7);
    std::vector<double> b(a.size()), by_factors(a.size()), by_iteration(a.size(), 0.0);
    for (std::size_t k = 0; k < b.size(); ++k) {
        b[k] = std::sin(static_cast<double>(k));
    }
    EXPECT_LT(solve_cholmod<12>(a, b, by_factors).residual, 1e-12);
    BlockJacobi<12> jacobi;
    ASSERT_TRUE(jacobi.set_up(a).is_ready());
    PcgScratch scratch;
    // Rounding of A x leaves 3e-13 to either: |x| is 138 times as large as |b|, |A| some tens.
    EXPECT_TRUE(solve_pcg(a, jacobi, b, by_iteration, {1e-12, 0, 5000}, scratch).is_converged());
    double size = 0, off = 0;
    for (std::size_t k = 0; k < b.size(); ++k) {
        size = std::max(size, std::abs(by_factors[k]));
        off = std::max(off, std::abs(by_factors[k] - by_iteration[k]));
    }
    EXPECT_LT(off, 1e-8 * size);
}

TEST(Cholmod, a_matrix_that_is_not_positive_definite_is_told) {
    BlockCsr<6> a = spring_chain<6>(5, 2);
    a.at(a.pattern().find(2, 2), 3, 3) = -1;
    std::vector<double> b(a.size(), 1.0), x(a.size());
    EXPECT_EQ(solve_cholmod<6>(a, b, x).status, SolveStatus::not_positive_definite);
}

}  // namespace
}  // namespace riprap::linear
#endif
