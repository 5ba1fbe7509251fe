// SPDX-License-Identifier: Apache-2.0
#include "riprap/linear/block_csr.hpp"

#include <gtest/gtest.h>

#include "linear/systems.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/linear/vector_ops.hpp"

namespace riprap::linear {
namespace {

TEST(BlockPattern, HasTheDiagonalAndBothSidesOfEveryPairOnce) {
    const std::array<std::int32_t, 2> pairs[] = {{2, 0}, {0, 2}, {3, 1}, {2, 0}};
    const BlockPattern pattern = symmetric_pattern(4, pairs);
    EXPECT_EQ(pattern.start, (std::vector<std::int64_t>{0, 2, 4, 6, 8}));
    EXPECT_EQ(pattern.column, (std::vector<std::int32_t>{0, 2, 1, 3, 0, 2, 1, 3}));
    EXPECT_EQ(pattern.find(2, 0), 4);
    EXPECT_EQ(pattern.find(2, 1), -1);
    EXPECT_EQ(pattern.find(2, 3), -1);
}

TEST(BlockPattern, OfNoRowsIsEmpty) {
    EXPECT_EQ(symmetric_pattern(0, {}).rows(), 0);
    BlockCsr<3> a(symmetric_pattern(0, {}));
    a.multiply({}, {});
    EXPECT_EQ(a.size(), 0U);
}

TEST(BlockCsr, ABlockTimesAVectorIsAsOnPaper) {
    const std::array<std::int32_t, 2> pairs[] = {{0, 1}};
    BlockCsr<3> a(symmetric_pattern(2, pairs));
    const std::int64_t upper = a.pattern().find(0, 1);
    a.at(upper, 0, 2) = 5;
    a.at(upper, 1, 0) = -2;
    std::vector<double> y(6, 9.0);
    a.multiply(std::vector<double>{0, 0, 0, 1, 10, 100}, y);
    EXPECT_EQ(y, (std::vector<double>{500, -2, 0, 0, 0, 0}));
}

template <class T>
class BlockSizes : public ::testing::Test {};
using AllSizes = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 3>,
                                  std::integral_constant<int, 6>, std::integral_constant<int, 12>>;
TYPED_TEST_SUITE(BlockSizes, AllSizes);

TYPED_TEST(BlockSizes, AProductIsEigensToRoundOff) {
    const auto a = spring_chain<TypeParam::value>(200, 17);
    const std::vector<double> x = random_vector(a.size());
    std::vector<double> y(a.size());
    a.multiply(x, y);
    const Eigen::VectorXd expected = to_eigen(a) * to_eigen(x);
    EXPECT_LT((to_eigen(y) - expected).norm(), 1e-14 * expected.norm());
}

TYPED_TEST(BlockSizes, AProductHasTheSameBitsWithFourThreads) {
    const auto a = spring_chain<TypeParam::value>(7000, 17);
    const std::vector<double> x = random_vector(a.size());
    std::vector<double> one(a.size()), four(a.size());
    a.multiply(x, one);
    parallel::set_thread_count(4);
    a.multiply(x, four);
    parallel::set_thread_count(1);
    EXPECT_EQ(one, four);
}

TYPED_TEST(BlockSizes, AnEmptiedMatrixKeepsItsPatternAndGivesNothing) {
    auto a = spring_chain<TypeParam::value>(50, 7);
    const BlockPattern before = a.pattern();
    a.set_zero();
    std::vector<double> y(a.size(), 1.0);
    a.multiply(random_vector(a.size()), y);
    EXPECT_EQ(a.pattern(), before);
    EXPECT_EQ(dot(y, y), 0);
}

TYPED_TEST(BlockSizes, ANewPatternBeginsWithZeros) {
    const BlockPattern small = spring_chain<TypeParam::value>(40, 7).pattern();
    const BlockPattern large = spring_chain<TypeParam::value>(60, 9).pattern();
    auto a = spring_chain<TypeParam::value>(50, 7);
    for (const BlockPattern& pattern : {large, small}) {
        a.set_pattern(pattern);
        std::vector<double> y(a.size(), 1.0);
        a.multiply(random_vector(a.size()), y);
        EXPECT_EQ(dot(y, y), 0);
        std::fill_n(a.block(0), pattern.entries() * static_cast<std::int64_t>(a.block_numbers), 1.0);
    }
}

TEST(VectorOps, ADotHasTheSameBitsWithFourThreadsAndIsEigensToRoundOff) {
    for (const std::size_t size : {1U, 7U, 4096U, 50'001U}) {
        const std::vector<double> a = random_vector(size), b = random_vector(size, 4);
        const double one = dot(a, b);
        parallel::set_thread_count(4);
        EXPECT_EQ(dot(a, b), one);
        parallel::set_thread_count(1);
        EXPECT_NEAR(one, to_eigen(a).dot(to_eigen(b)), 1e-14 * static_cast<double>(size));
    }
}

TEST(VectorOps, AStepMovesBothVectorsAndTellsTheSquareOfTheResidual) {
    const std::vector<double> p = random_vector(5003), q = random_vector(5003, 4);
    std::vector<double> x = random_vector(5003, 5), r = random_vector(5003, 6);
    const Eigen::VectorXd x_after = to_eigen(x) + 0.3 * to_eigen(p), r_after = to_eigen(r) - 0.3 * to_eigen(q);
    const double square = step_along(0.3, p, q, x, r);
    EXPECT_EQ((to_eigen(x) - x_after).norm(), 0);
    EXPECT_EQ((to_eigen(r) - r_after).norm(), 0);
    EXPECT_NEAR(square, r_after.squaredNorm(), 1e-12 * square);
}

}  // namespace
}  // namespace riprap::linear
