// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/exact_sum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace riprap {

namespace {

constexpr int limb_bits = 32;
constexpr int unit_exponent = -1075;  ///< of the lowest bit of the lowest limb
constexpr std::size_t top = ExactSum::limb_count - 1;

/// Nearest double to the number of limbs that are not negative and have all carries done.
double rounded(const ExactSum::Numbers& a) {
    std::size_t first = top;
    while (first > 0 && a[first] == 0) {
        --first;
    }
    if (first == top && a[top] != 0) {
        return std::numeric_limits<double>::infinity();  // 2^(32 66 - 1075) and more
    }
    // The three highest limbs hold the 53 bits that stay and the first that goes; of the others only whether they are
    // 0.
    using Wide [[gnu::mode(TI)]] = unsigned;
    const auto limb = [&](std::size_t below) { return below <= first ? static_cast<Wide>(a[first - below]) : Wide{0}; };
    const Wide bits = limb(0) << (2 * limb_bits) | limb(1) << limb_bits | limb(2);
    if (bits == 0) {
        return 0;
    }
    const int lowest = limb_bits * (static_cast<int>(first) - 2);  // bit of S that the lowest of `bits` is
    const auto upper = static_cast<std::uint64_t>(bits >> 64);
    const auto length =
        static_cast<int>(upper != 0 ? 64 + std::bit_width(upper) : std::bit_width(static_cast<std::uint64_t>(bits)));
    // Bit 1 of S is 2^-1074, the last place of denormal numbers.
    const int cut = std::max(length - std::numeric_limits<double>::digits, 1 - lowest);
    auto mantissa = static_cast<std::uint64_t>(bits >> cut);
    const Wide rest = bits & ((Wide{1} << cut) - 1), half = Wide{1} << (cut - 1);
    const bool has_more = first > 2 && std::any_of(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(first) - 2,
                                                   [](std::int64_t low) { return low != 0; });
    if (rest > half || (rest == half && (has_more || (mantissa & 1) != 0))) {
        ++mantissa;
    }
    return std::ldexp(static_cast<double>(mantissa), cut + lowest + unit_exponent);
}

}  // namespace

void ExactSum::carry() {
    for (std::size_t k = 0; k < top; ++k) {
        const std::int64_t up = a_[k] >> limb_bits;
        a_[k] -= up << limb_bits;
        a_[k + 1] += up;
    }
    terms_ = 0;
}

void ExactSum::add(const ExactSum& other) {
    carry();
    const Numbers more = other.numbers();
    for (std::size_t k = 0; k < a_.size(); ++k) {
        a_[k] += more[k];
    }
    carry();
}

ExactSum::Numbers ExactSum::numbers() const {
    ExactSum carried = *this;
    carried.carry();
    return carried.a_;
}

double ExactSum::value() const {
    const std::int64_t up = a_[limb_count], down = a_[limb_count + 1], no_number = a_[limb_count + 2];
    if (no_number != 0 || (up != 0 && down != 0)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    if (up != 0 || down != 0) {
        return up != 0 ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
    }
    ExactSum sum = *this;
    sum.carry();
    if (sum.a_[top] >= 0) {
        return rounded(sum.a_);
    }
    for (std::int64_t& limb : sum.a_) {
        limb = -limb;
    }
    sum.carry();
    return -rounded(sum.a_);
}

}  // namespace riprap
