// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "riprap/linear/block_jacobi.hpp"
#include "riprap/linear/cholmod.hpp"
#include "systems.hpp"

namespace riprap::linear {
namespace {

TEST(Cholmod, conjugate_gradients_find_what_its_factors_find) {
    if (!has_cholmod()) {
        GTEST_SKIP() << "built without RIPRAP_CHOLMOD";
    }
    const BlockCsr<12> a = spring_chain<12>(60, 7);
    std::vector<double> b(a.size()), by_factors(a.size()), by_iteration(a.size(), 0.0);
    for (std::size_t k = 0; k < b.size(); ++k) {
        b[k] = std::sin(static_cast<double>(k));
    }
    EXPECT_LT(solve_cholmod(a, b, by_factors).residual, 1e-12);
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
    EXPECT_EQ(solve_cholmod(a, b, x).status, SolveStatus::not_positive_definite);
}

}  // namespace
}  // namespace riprap::linear
