// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "riprap/core/exact_sum.hpp"

namespace riprap {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();

ExactSum sum_of(const std::vector<double>& terms) {
    ExactSum sum;
    for (const double term : terms) {
        sum.add(term);
    }
    return sum;
}

std::uint64_t bits_of(double a) { return std::bit_cast<std::uint64_t>(a); }

/// Terms of all sizes from `first` to `last` powers of two, with both signs.
std::vector<double> random_terms(std::size_t count, int first, int last, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> mantissa(-2, 2);
    std::uniform_int_distribution<int> exponent(first, last);
    std::vector<double> terms(count);
    for (double& term : terms) {
        term = std::ldexp(mantissa(random), exponent(random));
    }
    return terms;
}

TEST(ExactSum, HasTheSameBitsInAnyOrderAndGrouping) {
    std::mt19937_64 random(5);
    for (const int range : {3, 60, 1000}) {
        std::vector<double> terms = random_terms(5000, -range, range, 17);
        const ExactSum whole = sum_of(terms);
        for (int trial = 0; trial < 5; ++trial) {
            std::shuffle(terms.begin(), terms.end(), random);
            std::vector<ExactSum> groups(static_cast<std::size_t>(1 + 6 * trial));
            for (const double term : terms) {
                groups[random() % groups.size()].add(term);
            }
            std::shuffle(groups.begin(), groups.end(), random);
            ExactSum sum;
            for (const ExactSum& group : groups) {
                sum.add(group);
            }
            ASSERT_EQ(bits_of(sum.value()), bits_of(whole.value()));
            ASSERT_EQ(sum, whole);
        }
    }
}

/// Takes the value of a sum out of its parts (s, e) with s + e exact: s has to be the nearest double.
void expect_rounds_to(double expected, const std::vector<double>& terms) {
    EXPECT_EQ(bits_of(sum_of(terms).value()), bits_of(expected));
    std::vector<double> turned = terms;
    for (double& term : turned) {
        term = -term;
    }
    EXPECT_EQ(sum_of(turned).value(), -expected);
}

TEST(ExactSum, OfTwoTermsIsTheirRoundedSum) {
    const std::vector<double> terms = random_terms(20'000, -1074, 1023, 3);
    for (std::size_t i = 0; i + 1 < terms.size(); ++i) {
        // as they are, where mostly one is too small to count, and at nearly the same size
        const double a = terms[i], b = terms[i + 1];
        const double close = std::ldexp(b, std::ilogb(a) - std::ilogb(b) + static_cast<int>(i % 57) - 28);
        ASSERT_EQ(sum_of({a, b}).value(), a + b) << a << " " << b;
        ASSERT_EQ(sum_of({a, close}).value(), a + close) << a << " " << close;
    }
}

TEST(ExactSum, IsTheNearestDoubleOfExpansionsThatTwoSumMakes) {
    const std::vector<double> terms = random_terms(20'000, -40, 40, 9);
    for (std::size_t i = 0; i + 1 < terms.size(); ++i) {
        const double a = terms[i], b = terms[i + 1], s = a + b, t = s - a, error = (a - (s - t)) + (b - t);
        ASSERT_EQ(sum_of({a, b, -s}).value(), error);
        ASSERT_EQ(sum_of({s, error}).value(), s);
        ASSERT_EQ(sum_of({a, b, -s, -error}).value(), 0);
    }
}

TEST(ExactSum, RoundsHalvesToEvenAndSeesTheSmallestTermBesides) {
    const double half = 0x1p-53;  // of the last place of 1
    expect_rounds_to(1, {1, half});
    expect_rounds_to(1 + 0x1p-52, {1, half, least});
    expect_rounds_to(1, {1, half, -least});
    expect_rounds_to(1 + 0x1p-51, {1 + 0x1p-52, half});
    expect_rounds_to(1 + 0x1p-52, {1 + 0x1p-52, half, -least});
    expect_rounds_to(2, {2 - 0x1p-52, half});  // a carry through the whole mantissa
    expect_rounds_to(1e-300, {1e300, 1e-300, -1e300});
    expect_rounds_to(2, {1e16, 1, 1, -1e16});
}

TEST(ExactSum, HoldsDenormalNumbersAndSumsBeyondTheLargest) {
    expect_rounds_to(3 * least, {least, least, least});
    expect_rounds_to(0x1p-1022, {0x1p-1022 - least, least});
    expect_rounds_to(least, {0x1p-1022, least, -0x1p-1022});
    expect_rounds_to(largest, {largest, largest, -largest});
    expect_rounds_to(infinity, {largest, 0x1p970});  // half of the last place of the largest: even is beyond it
    expect_rounds_to(largest, {largest, 0x1p970, -least});
    std::vector<double> many(5000, largest);
    expect_rounds_to(infinity, many);
    many.resize(10'000, -largest);
    many.push_back(-3 * least);
    expect_rounds_to(-3 * least, many);
}

TEST(ExactSum, OfManyEqualTermsLosesNoCarry) {
    for (const double term : {1.0, 1 - 0x1p-53, 0x1.fffffffffffffp31, -0x1.fffffffffffffp30, 0x1p-1060}) {
        const int count = 1 << 17;
        expect_rounds_to(std::ldexp(term, 17), std::vector<double>(count, term));
    }
}

TEST(ExactSum, OfNothingOrOfNegativeZerosIsZero) {
    EXPECT_EQ(bits_of(ExactSum().value()), bits_of(0.0));
    EXPECT_EQ(bits_of(sum_of({-0.0, -0.0}).value()), bits_of(0.0));
    EXPECT_EQ(bits_of(sum_of({3.5, -3.5}).value()), bits_of(0.0));
}

TEST(ExactSum, ReportsWhatIsNotFiniteInAnyOrder) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (const bool is_first : {true, false}) {
        const auto with = [is_first](std::vector<double> odd) {
            odd.insert(is_first ? odd.end() : odd.begin(), {1.0, -largest, -largest});
            return sum_of(odd).value();
        };
        EXPECT_EQ(with({infinity}), infinity);
        EXPECT_EQ(with({-infinity, -infinity}), -infinity);
        EXPECT_TRUE(std::isnan(with({infinity, -infinity})));
        EXPECT_TRUE(std::isnan(with({none})));
        EXPECT_TRUE(std::isnan(with({none, infinity})));
    }
    ExactSum sum;
    sum.add(sum_of({infinity}));
    EXPECT_EQ(sum.value(), infinity);
    sum.add(sum_of({-infinity}));
    EXPECT_TRUE(std::isnan(sum.value()));
}

TEST(ExactSum, SeesAMutationOfAnyLimb) {
    const std::vector<double> terms = random_terms(3000, -1000, 1000, 21);
    const ExactSum whole = sum_of(terms);
    ASSERT_EQ(ExactSum(whole.numbers()), whole);
    for (std::size_t k = 0; k < ExactSum::limb_count; ++k) {
        ExactSum::Numbers numbers = whole.numbers();
        numbers[k] += 2;
        ExactSum changed(numbers);
        EXPECT_NE(changed, whole);
        for (const double term : terms) {
            changed.add(-term);
        }
        EXPECT_EQ(changed.value(), std::ldexp(2.0, 32 * static_cast<int>(k) - 1075)) << k;
    }
}

/// Sums of the numbers of several are the numbers of the sum, which is all that holders of parts exchange.
TEST(ExactSum, IsTheSumOfItsNumbers) {
    const std::vector<double> terms = random_terms(4000, -300, 300, 8);
    ExactSum::Numbers numbers{};
    for (std::size_t first = 0; first < terms.size(); first += 500) {
        const auto begin = terms.begin() + static_cast<std::ptrdiff_t>(first);
        const ExactSum::Numbers part = sum_of({begin, begin + 500}).numbers();
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            numbers[k] += part[k];
        }
    }
    EXPECT_EQ(ExactSum(numbers), sum_of(terms));
}

}  // namespace
}  // namespace riprap
