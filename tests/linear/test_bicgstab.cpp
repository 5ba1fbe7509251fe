// SPDX-License-Identifier: Apache-2.0
#include "riprap/linear/bicgstab.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "linear/systems.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/linear/block_csr.hpp"
#include "riprap/linear/incomplete_cholesky.hpp"

namespace riprap::linear {
namespace {

/// A symmetric matrix and a few large numbers on it that are not: A + c u w^T, u of the first rows and w of the last.
struct WithOutliers {
    const BlockCsr<1>& a;
    double c;
    std::size_t size() const { return a.size(); }
    void multiply(std::span<const double> x, std::span<double> y) const {
        a.multiply(x, y);
        double sum = 0;
        for (std::size_t i = 0; i < 8; ++i) {
            sum += (1 + 0.1 * static_cast<double>(i)) * x[x.size() - 1 - i] + 0.5 * x[i];
        }
        for (std::size_t i = 0; i < 8; ++i) {
            y[i] += c * sum;
        }
    }
};

Eigen::MatrixXd dense(const WithOutliers& a) {
    Eigen::MatrixXd all(a.size(), a.size());
    std::vector<double> unit(a.size(), 0.0), column(a.size());
    for (std::size_t j = 0; j < a.size(); ++j) {
        unit[j] = 1;
        a.multiply(unit, column);
        unit[j] = 0;
        all.col(static_cast<Eigen::Index>(j)) = to_eigen(column);
    }
    return all;
}

TEST(Bicgstab, solves_a_matrix_that_is_not_symmetric_with_the_factors_of_one_that_is) {
    const BlockCsr<1> symmetric = laplacian(12);
    const WithOutliers a{symmetric, 40};
    IncompleteCholesky<1> m(64);
    ASSERT_TRUE(m.set_up(symmetric).is_ready());
    const std::vector<double> b = random_vector(a.size());
    const Eigen::VectorXd expected = dense(a).partialPivLu().solve(to_eigen(b));
    const auto solution = [&](int threads) {
        parallel::set_thread_count(threads);
        std::vector<double> x(a.size(), 7.0);
        BicgstabScratch scratch;
        const SolveReport report = solve_bicgstab(a, m, b, x, {.tolerance = 1e-10, .max_iterations = 200}, scratch);
        parallel::set_thread_count(1);
        EXPECT_TRUE(report.is_converged()) << describe(report.status) << " " << report.residual;
        EXPECT_LT(report.iterations, 60);
        return x;
    };
    const std::vector<double> x = solution(1);
    EXPECT_LT((to_eigen(x) - expected).norm(), 1e-8 * expected.norm());
    EXPECT_EQ(solution(2), x);
}

TEST(Bicgstab, tells_when_it_has_not_come_to_an_end_and_takes_nothing_for_nothing) {
    const BlockCsr<1> symmetric = laplacian(12);
    NoPreconditioner m;
    std::vector<double> b = random_vector(symmetric.size()), x(symmetric.size(), 1.0);
    BicgstabScratch scratch;
    EXPECT_EQ(solve_bicgstab(symmetric, m, b, x, {.tolerance = 1e-12, .max_iterations = 3}, scratch).status,
              SolveStatus::too_many_iterations);
    b.assign(b.size(), 0);
    EXPECT_TRUE(solve_bicgstab(symmetric, m, b, x, {}, scratch).is_converged());
    EXPECT_EQ(x, std::vector<double>(b.size(), 0.0));
}

}  // namespace
}  // namespace riprap::linear
