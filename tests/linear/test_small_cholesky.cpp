// SPDX-License-Identifier: Apache-2.0
#include "riprap/linear/small_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <random>

namespace riprap::linear {
namespace {

template <int B>
using Block = Eigen::Matrix<double, B, B>;

/// Positive definite, with unknowns of different units and a condition number of some thousands besides.
template <int B>
Block<B> stiff_block() {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> number(-1, 1);
    Block<B> factor = Block<B>::NullaryExpr([&] { return number(random); });
    Block<B> a = factor * factor.transpose() + 1e-3 * Block<B>::Identity();
    for (int k = 0; k < B; ++k) {
        const double unit = k < 3 ? 1 : 1e3;
        a.row(k) *= unit;
        a.col(k) *= unit;
    }
    return a;
}

template <class T>
class SmallBlocks : public ::testing::Test {};
using AllSizes = ::testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 3>,
                                  std::integral_constant<int, 6>, std::integral_constant<int, 12>>;
TYPED_TEST_SUITE(SmallBlocks, AllSizes);

TYPED_TEST(SmallBlocks, AnInverseIsEigensAndSymmetricToTheBit) {
    constexpr int B = TypeParam::value;
    const Block<B> a = stiff_block<B>();
    Block<B> inverse;
    ASSERT_TRUE(invert_spd<B>(a.data(), inverse.data()));
    const Block<B> expected = a.llt().solve(Block<B>::Identity());
    EXPECT_LT((inverse - expected).norm(), 1e-10 * expected.norm());
    EXPECT_EQ((inverse - inverse.transpose()).norm(), 0);
}

TYPED_TEST(SmallBlocks, ReadsTheLowerTriangleAlone) {
    constexpr int B = TypeParam::value;
    Block<B> a = stiff_block<B>(), whole, lower;
    ASSERT_TRUE(invert_spd<B>(a.data(), whole.data()));
    a.template triangularView<Eigen::StrictlyUpper>().setConstant(7);
    ASSERT_TRUE(invert_spd<B>(a.data(), lower.data()));
    EXPECT_EQ(whole, lower);
}

TYPED_TEST(SmallBlocks, RefusesWhatIsNotPositiveDefinite) {
    constexpr int B = TypeParam::value;
    Block<B> inverse, a = stiff_block<B>();
    a(B - 1, B - 1) = -1;
    EXPECT_FALSE(invert_spd<B>(a.data(), inverse.data()));
    a.row(B - 1).setZero();
    a.col(B - 1).setZero();
    EXPECT_FALSE(invert_spd<B>(a.data(), inverse.data())) << "singular";
    a = stiff_block<B>();
    a(B - 1, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(invert_spd<B>(a.data(), inverse.data())) << "not a number";
}

}  // namespace
}  // namespace riprap::linear
