// SPDX-License-Identifier: Apache-2.0
#include "riprap/linear/pcg.hpp"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <limits>

#include "linear/systems.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/linear/block_csr.hpp"
#include "riprap/linear/block_jacobi.hpp"
#include "riprap/linear/incomplete_cholesky.hpp"

namespace riprap::linear {
namespace {

template <int B, class M>
SolveReport solve(const BlockCsr<B>& a, M& m, const std::vector<double>& b, std::vector<double>& x,
                  const PcgSettings& settings = {}) {
    PcgScratch scratch;
    return solve_pcg(a, m, b, x, settings, scratch);
}

template <class T>
class PcgBlockSizes : public ::testing::Test {};
using AllSizes = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 3>,
                                  std::integral_constant<int, 6>, std::integral_constant<int, 12>>;
TYPED_TEST_SUITE(PcgBlockSizes, AllSizes);

TYPED_TEST(PcgBlockSizes, FindsTheSolutionOfEigensDirectSolver) {
    constexpr int B = TypeParam::value;
    const auto a = spring_chain<B>(150, 12);
    const std::vector<double> b = random_vector(a.size());
    const Eigen::VectorXd expected = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(to_eigen(a)).solve(to_eigen(b));
    const auto check = [&](auto m, const SetUp& set_up) {
        ASSERT_TRUE(set_up.is_ready());
        std::vector<double> x(a.size(), 0.0);
        const SolveReport report = solve(a, m, b, x, {.tolerance = 1e-12, .max_iterations = 5000});
        EXPECT_TRUE(report.is_converged()) << describe(report.status) << " " << report.residual;
        EXPECT_LT(report.residual, 1e-12);
        EXPECT_LT((to_eigen(x) - expected).norm(), 1e-8 * expected.norm());
    };
    check(NoPreconditioner{}, {});
    BlockJacobi<B> jacobi;
    const SetUp jacobi_set_up = jacobi.set_up(a);
    check(jacobi, jacobi_set_up);
    IncompleteCholesky<B> cholesky(64);
    const SetUp cholesky_set_up = cholesky.set_up(a);
    check(cholesky, cholesky_set_up);
}

TYPED_TEST(PcgBlockSizes, HasTheSameBitsWithOneTwoAndFourThreads) {
    constexpr int B = TypeParam::value;
    const auto a = spring_chain<B>(2000, 60);
    const std::vector<double> b = random_vector(a.size());
    const auto solution = [&](int threads) {
        parallel::set_thread_count(threads);
        IncompleteCholesky<B> m(300);
        m.set_up(a);
        std::vector<double> x(a.size(), 0.0);
        solve(a, m, b, x, {.tolerance = 1e-6, .max_iterations = 30});
        parallel::set_thread_count(1);
        return x;
    };
    const std::vector<double> one = solution(1);
    EXPECT_EQ(solution(2), one);
    EXPECT_EQ(solution(4), one);
}

TEST(Pcg, BlockJacobiForgetsTheUnitsOfTheUnknowns) {
    // lengths beside strains: as in the unknowns of deformable blocks
    const auto iterations = [](double contrast) {
        const auto a = spring_chain<12>(60, 5, contrast);
        BlockJacobi<12> m;
        EXPECT_TRUE(m.set_up(a).is_ready());
        std::vector<double> b(a.size()), x(a.size(), 0.0);
        a.multiply(random_vector(a.size()), b);
        return solve(a, m, b, x, {.tolerance = 1e-6}).iterations;
    };
    EXPECT_NEAR(iterations(1e4), iterations(1), 0.3 * iterations(1));
}

TEST(Pcg, IncompleteFactorsNeedAFewTimesFewerIterationsThanTheDiagonal) {
    const auto a = laplacian(100);
    const std::vector<double> b(a.size(), 1.0);
    BlockJacobi<1> jacobi;
    IncompleteCholesky<1> cholesky(a.rows());
    ASSERT_TRUE(jacobi.set_up(a).is_ready());
    ASSERT_TRUE(cholesky.set_up(a).is_ready());
    EXPECT_EQ(cholesky.shifted_ranges(), 0);
    std::vector<double> x(a.size(), 0.0), y(a.size(), 0.0);
    const SolveReport slow = solve(a, jacobi, b, x), fast = solve(a, cholesky, b, y);
    EXPECT_TRUE(slow.is_converged());
    EXPECT_TRUE(fast.is_converged());
    EXPECT_LT(2 * fast.iterations, slow.iterations);
}

TEST(Pcg, FactorsOfOneRangeWithoutFillToLoseAreExact) {
    // a chain has no fill: one application solves it
    const auto a = spring_chain<3>(40, 1);
    IncompleteCholesky<3> m;
    ASSERT_TRUE(m.set_up(a).is_ready());
    const std::vector<double> x = random_vector(a.size());
    std::vector<double> b(a.size()), z(a.size());
    a.multiply(x, b);
    m.apply(b, z);
    EXPECT_LT((to_eigen(z) - to_eigen(x)).norm(), 1e-10 * to_eigen(x).norm());
}

TEST(Pcg, AGuessThatIsTheAnswerTakesNoIteration) {
    const auto a = laplacian(30);
    const std::vector<double> answer = random_vector(a.size());
    std::vector<double> b(a.size()), x = answer;
    a.multiply(answer, b);
    NoPreconditioner m;
    const SolveReport report = solve(a, m, b, x);
    EXPECT_TRUE(report.is_converged());
    EXPECT_EQ(report.iterations, 0);
    EXPECT_EQ(x, answer);
}

TEST(Pcg, ANearGuessTakesFewerIterations) {
    const auto a = laplacian(60);
    const std::vector<double> answer = random_vector(a.size());
    std::vector<double> b(a.size()), near = answer, far(a.size(), 0.0);
    a.multiply(answer, b);
    for (std::size_t i = 0; i < near.size(); ++i) {
        near[i] *= 1 + 1e-5 * std::sin(static_cast<double>(i));
    }
    NoPreconditioner m;
    EXPECT_LT(2 * solve(a, m, b, near).iterations, solve(a, m, b, far).iterations);
}

TEST(Pcg, AGuessOfZerosCostsNoProduct) {
    struct Counting {
        const BlockCsr<1>& a;
        mutable int products{0};
        std::size_t size() const { return a.size(); }
        void multiply(std::span<const double> x, std::span<double> y) const {
            ++products;
            a.multiply(x, y);
        }
    };
    const auto a = laplacian(30);
    const std::vector<double> b = random_vector(a.size());
    std::vector<double> x(a.size(), 0.0);
    NoPreconditioner m;
    PcgScratch scratch;
    const Counting counting{a};
    const SolveReport report = solve_pcg(counting, m, b, x, {}, scratch);
    EXPECT_TRUE(report.is_converged());
    EXPECT_EQ(report.first_residual, 1);
    // one each, and one for the residual of the answer
    EXPECT_EQ(counting.products, report.iterations + 1);
}

TEST(Pcg, NothingOnTheRightGivesNothing) {
    const auto a = laplacian(5);
    std::vector<double> x = random_vector(a.size());
    NoPreconditioner m;
    EXPECT_TRUE(solve(a, m, std::vector<double>(a.size(), 0.0), x).is_converged());
    EXPECT_EQ(x, std::vector<double>(a.size(), 0.0));
}

TEST(Pcg, TooFewIterationsAreToldWithTheResidualOfWhatWasReached) {
    const auto a = laplacian(60);
    const std::vector<double> b(a.size(), 1.0);
    std::vector<double> x(a.size(), 0.0), ax(a.size());
    NoPreconditioner m;
    const SolveReport report = solve(a, m, b, x, {.max_iterations = 7});
    EXPECT_EQ(report.status, SolveStatus::too_many_iterations);
    EXPECT_EQ(report.iterations, 7);
    a.multiply(x, ax);
    EXPECT_NEAR(report.residual, (to_eigen(b) - to_eigen(ax)).norm() / to_eigen(b).norm(), 1e-12);
}

TEST(Pcg, AnIndefiniteMatrixIsTold) {
    auto a = laplacian(10);
    for (std::int64_t row = 0; row < a.rows(); ++row) {
        a.at(a.pattern().find(row, row), 0, 0) = 1;  // below the sum of the others
    }
    std::vector<double> x(a.size(), 0.0);
    NoPreconditioner m;
    const SolveReport report = solve(a, m, random_vector(a.size()), x);
    EXPECT_EQ(report.status, SolveStatus::not_positive_definite);
}

TEST(Pcg, ANumberThatIsNotFiniteIsTold) {
    auto a = laplacian(10);
    std::vector<double> x(a.size(), 0.0), b = random_vector(a.size());
    NoPreconditioner m;
    b[3] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(solve(a, m, b, x).status, SolveStatus::not_finite);
    b[3] = 1;
    a.at(20, 0, 0) = std::numeric_limits<double>::infinity();
    std::ranges::fill(x, 0.0);
    EXPECT_EQ(solve(a, m, b, x).status, SolveStatus::not_finite);
}

TEST(Pcg, AnImpossibleToleranceEndsInStagnationNotForEver) {
    const auto a = laplacian(20);
    std::vector<double> x(a.size(), 0.0);
    NoPreconditioner m;
    const SolveReport report = solve(a, m, random_vector(a.size()), x, {.tolerance = 1e-30, .max_iterations = 100000});
    EXPECT_FALSE(report.is_converged());
    EXPECT_LT(report.residual, 1e-12);
}

TEST(Pcg, APreconditionerNamesTheRowThatItCannotInvert) {
    auto a = spring_chain<3>(20, 4);
    for (int k = 0; k < 3; ++k) {
        a.at(a.pattern().find(9, 9), k, k) = -1;
    }
    EXPECT_EQ(BlockJacobi<3>().set_up(a).bad_row, 9);
    EXPECT_EQ(IncompleteCholesky<3>().set_up(a).bad_row, 9);
}

TEST(Pcg, BlockJacobiUpdatesTheRowsThatHaveChanged) {
    auto a = spring_chain<3>(20, 4);
    BlockJacobi<3> updated, fresh;
    ASSERT_TRUE(updated.set_up(a).is_ready());
    std::vector<std::uint8_t> is_changed(20, 0);
    for (const std::int64_t row : {3, 11}) {
        is_changed[static_cast<std::size_t>(row)] = 1;
        a.at(a.pattern().find(row, row), 1, 1) += 2;
    }
    a.at(a.pattern().find(7, 7), 0, 0) = -1;  // not flagged: not looked at
    ASSERT_TRUE(updated.update(a, is_changed).is_ready());
    a.at(a.pattern().find(7, 7), 0, 0) = spring_chain<3>(20, 4).at(a.pattern().find(7, 7), 0, 0);
    ASSERT_TRUE(fresh.set_up(a).is_ready());
    const std::vector<double> r = random_vector(a.size());
    std::vector<double> z(a.size()), expected(a.size());
    updated.apply(r, z);
    fresh.apply(r, expected);
    EXPECT_EQ(z, expected);
    is_changed[7] = 1;
    a.at(a.pattern().find(7, 7), 0, 0) = -1;
    EXPECT_EQ(updated.update(a, is_changed).bad_row, 7);
}

TEST(Pcg, ARangeWithoutAPositivePivotIsShifted) {
    // Kershaw's matrix: positive definite, and its factors without fill have a negative pivot
    const std::array<std::int32_t, 2> pairs[] = {{0, 1}, {1, 2}, {2, 3}, {0, 3}};
    BlockCsr<1> a(symmetric_pattern(4, pairs));
    const auto set = [&](std::int64_t i, std::int64_t j, double value) {
        a.at(a.pattern().find(i, j), 0, 0) = value;
        a.at(a.pattern().find(j, i), 0, 0) = value;
    };
    for (std::int64_t i = 0; i < 4; ++i) {
        set(i, i, 3);
    }
    set(0, 1, -2);
    set(1, 2, -2);
    set(2, 3, -2);
    set(0, 3, 2);
    IncompleteCholesky<1> m;
    EXPECT_TRUE(m.set_up(a).is_ready());
    EXPECT_EQ(m.shifted_ranges(), 1);
    std::vector<double> x(4, 0.0);
    EXPECT_TRUE(solve(a, m, {1, 2, 3, 4}, x).is_converged());
}

}  // namespace
}  // namespace riprap::linear
