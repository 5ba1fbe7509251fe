// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "riprap/core/wide_floats.hpp"

namespace riprap {
namespace {

template <class Number>
class wide : public testing::Test {
 protected:
    using Lanes = Wide<Number, 16>;
    static constexpr Number infinity = std::numeric_limits<Number>::infinity();
    static constexpr Number nan = std::numeric_limits<Number>::quiet_NaN();
    // every order, equal numbers, zeros of both signs, infinities and no numbers, in every part of the lanes
    std::array<Number, 16> ones{1, -2, 3, 0, Number(-0.0), infinity, nan, 5, -7, 8, -infinity, 2, 1e-20F, 4, 0, 6};
    std::array<Number, 16> others{2, -3, 3, Number(-0.0), 0, 1, 1, nan, -7, -8, 0, infinity, 0, -4, 1, 6};
};
using Numbers = testing::Types<float, double>;
TYPED_TEST_SUITE(wide, Numbers);

// As text, so that NaN is equal to itself and zeros differ by their sign.
template <class Number>
std::string text(Number a) {
    std::array<char, 40> digits{};
    std::snprintf(digits.data(), digits.size(), "%a", static_cast<double>(a));
    return std::isnan(a) ? "nan" : digits.data();
}

TYPED_TEST(wide, does_to_every_lane_what_the_scalar_operation_does) {
    using W = typename TestFixture::Lanes;
    const W a = W::load(this->ones.data()), b = W::load(this->others.data());
    const W sum = a + b, less = a - b, product = a * b, turned = -a, scaled = TypeParam(3) * a;
    const W least = min(a, b), most = max(a, b), chosen = select(a < b, a, b);
    for (int l = 0; l < 16; ++l) {
        const TypeParam x = this->ones[static_cast<std::size_t>(l)], y = this->others[static_cast<std::size_t>(l)];
        EXPECT_EQ(text(sum[l]), text(x + y));
        EXPECT_EQ(text(less[l]), text(x - y));
        EXPECT_EQ(text(product[l]), text(x * y));
        EXPECT_EQ(text(turned[l]), text(-x));
        EXPECT_EQ(text(scaled[l]), text(3 * x));
        EXPECT_EQ(text(least[l]), text(x < y ? x : y)) << l;
        EXPECT_EQ(text(most[l]), text(x > y ? x : y)) << l;
        EXPECT_EQ(text(chosen[l]), text(x < y ? x : y)) << l;
    }
}

TYPED_TEST(wide, compares_every_lane) {
    using W = typename TestFixture::Lanes;
    const W a = W::load(this->ones.data()), b = W::load(this->others.data());
    const auto below = a<b, above = a> b, at_most = a <= b, at_least = a >= b, same = a == b;
    const auto either = below | same, both = below & same;
    const std::uint32_t bits = bits_below(a, b);
    for (int l = 0; l < 16; ++l) {
        const TypeParam x = this->ones[static_cast<std::size_t>(l)], y = this->others[static_cast<std::size_t>(l)];
        EXPECT_EQ(below[l] != 0, x < y);
        EXPECT_EQ(above[l] != 0, x > y);
        EXPECT_EQ(at_most[l] != 0, x <= y);
        EXPECT_EQ(at_least[l] != 0, x >= y);
        EXPECT_EQ(same[l] != 0, x == y);
        EXPECT_EQ(either[l] != 0, x <= y);
        EXPECT_EQ(both[l], 0);
        EXPECT_EQ((bits >> l & 1U) != 0, x < y);
    }
}

TYPED_TEST(wide, keeps_numbers_in_their_lanes) {
    using W = typename TestFixture::Lanes;
    W a(TypeParam(1));
    a.set(3, 7);
    a.set(12, -5);
    std::array<TypeParam, 16> out;
    a.store(out.data());
    for (int l = 0; l < 16; ++l) {
        EXPECT_EQ(out[static_cast<std::size_t>(l)], l == 3 ? 7 : l == 12 ? -5 : 1);
        EXPECT_EQ(a[l], out[static_cast<std::size_t>(l)]);
    }
}

TEST(wide, is_as_long_as_its_numbers_whatever_the_machine_takes_at_once) {
    EXPECT_EQ(sizeof(Wide<double, 4>), 32U);
    EXPECT_EQ(sizeof(Wide<float, 4>), 16U);
    const std::array<double, 4> numbers{1, -2, 3, 4};
    const auto twice = 2.0 * Wide<double, 4>::load(numbers.data());
    for (int l = 0; l < 4; ++l) {
        EXPECT_EQ(twice[l], 2 * numbers[static_cast<std::size_t>(l)]);
    }
    EXPECT_EQ(bits_below(twice, Wide<double, 4>(3)), 0b0011U);
}

TEST(wide_floats, reciprocals_and_roots_are_right_to_two_units_in_the_last_place) {
    for (float x = 1e-12F; x < 1e12F; x *= 1.37F) {
        const Wide<float, 16> a(x);
        const double tolerance = 2.4e-7;
        EXPECT_NEAR(reciprocal(a)[5] * double{x}, 1, tolerance);
        EXPECT_NEAR(reciprocal_sqrt(a)[9] * std::sqrt(double{x}), 1, tolerance);
        EXPECT_NEAR(distance(a)[15] / std::sqrt(double{x}), 1, tolerance);
        EXPECT_NEAR(sqrt(a)[0] / std::sqrt(double{x}), 1, tolerance);
    }
    EXPECT_EQ(sqrt(Wide<float, 16>(0))[3], 0);
}

}  // namespace
}  // namespace riprap
