// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sweep/cluster_places.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "riprap/core/bytes.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::fluid {

namespace {

using LongFour [[gnu::vector_size(sizeof(DoubleFour))]] = std::int64_t;

/// Four particles, x y z x y z x y z x y z, as whole numbers: x x x x, y y y y, z z z z.
struct FourPlaces {
    std::array<DoubleFour, 3> origin, per_quantum;

    explicit FourPlaces(const FixedPoint& fixed) {
        for (int k = 0; k < 12; ++k) {
            origin[static_cast<std::size_t>(k / 4)][k % 4] = fixed.origin()[k % 3];
            per_quantum[static_cast<std::size_t>(k / 4)][k % 4] = fixed.per_quantum()[k % 3];
        }
    }
    std::array<IntFour, 3> operator()(const Vec3* four) const {
        std::array<IntFour, 3> v;
        for (std::size_t k = 0; k < 3; ++k) {
            DoubleFour x;
            std::memcpy(&x, reinterpret_cast<const char*>(four) + k * sizeof x, sizeof x);
            // The addend puts the unit into the last place of the mantissa, so that its low bits are the whole
            // number in two's complement, modulo 2^32. Places beyond 2^51 small lengths, and not finite ones, are
            // anywhere.
            const DoubleFour rounded = (x - origin[k]) * per_quantum[k] + 0x1.8p52;
            v[k] = __builtin_convertvector(reinterpret_cast<LongFour>(rounded), IntFour);
        }
        const IntFour x = __builtin_shufflevector(v[0], v[1], 0, 3, 6, 6),
                      y = __builtin_shufflevector(v[0], v[1], 1, 4, 7, 7),
                      z = __builtin_shufflevector(v[0], v[1], 2, 5, 5, 5);
        return {__builtin_shufflevector(x, v[2], 0, 1, 2, 5), __builtin_shufflevector(y, v[2], 0, 1, 2, 6),
                __builtin_shufflevector(z, v[2], 0, 1, 4, 7)};
    }
};

}  // namespace

Motion no_motion() { return Motion{} + std::numeric_limits<float>::infinity(); }

float approach(Motion a, Motion b) {
    float square = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float most = std::max(-a[axis + 4] - b[axis], -b[axis + 4] - a[axis]);
        square += most * most;
    }
    return std::sqrt(square);
}

Motion motion_between(const Travel& then, const Travel& now) {
    Motion motion{};
    for (int axis = 0; axis < 3; ++axis) {
        motion[axis] = static_cast<float>(now.low[axis] - then.low[axis]);
        motion[axis + 4] = static_cast<float>(then.high[axis] - now.high[axis]);
    }
    return motion;
}

template <int Dim>
Motion ClusterPlaces::place_block(std::span<const Vec3> position, std::int64_t block, bool is_comparable) {
    constexpr std::int64_t stride = std::int64_t{Dim} * cluster_size;
    const FourPlaces four_places(fixed_);
    const FloatFour far = FloatFour{} + std::numeric_limits<float>::infinity();
    std::array<FloatFour, Dim> low, high;
    low.fill(far);
    high.fill(-far);
    for (std::int64_t c = block * block_size; c < std::min(cluster_count(), (block + 1) * block_size); ++c) {
        const std::int64_t first = c * cluster_size;
        std::array<IntFour, 3> here;
        if (first + cluster_size <= size_) {
            here = four_places(&position[static_cast<std::size_t>(first)]);
        } else {
            std::array<Vec3, cluster_size> four;
            for (std::int64_t member = 0; member < cluster_size; ++member) {
                four[static_cast<std::size_t>(member)] =
                    position[static_cast<std::size_t>(std::min(first + member, size_ - 1))];
            }
            here = four_places(four.data());
        }
        std::int32_t* const places = &places_[static_cast<std::size_t>(c * stride)];
        if (is_comparable) {
            std::array<IntFour, Dim> then;
            std::memcpy(then.data(), places, sizeof then);
            for (std::size_t axis = 0; axis < Dim; ++axis) {
                const FloatFour way =
                    difference(here[axis], then[axis]) * static_cast<float>(fixed_.quantum()[static_cast<int>(axis)]);
                low[axis] = way < low[axis] ? way : low[axis];
                high[axis] = way > high[axis] ? way : high[axis];
            }
        }
        std::memcpy(places, here.data(), stride * sizeof(std::int32_t));
    }
    Motion motion{};
    for (int axis = 0; axis < Dim; ++axis) {
        const FloatFour l = low[static_cast<std::size_t>(axis)], h = high[static_cast<std::size_t>(axis)];
        motion[axis] = std::min({l[0], l[1], l[2], l[3]});
        motion[axis + 4] = -std::max({h[0], h[1], h[2], h[3]});
    }
    return motion;
}

void ClusterPlaces::update(std::span<const Vec3> position, const FixedPoint& fixed, int dimension) {
    const bool is_comparable = updates_ > 0 && size_ == static_cast<std::int64_t>(position.size()) &&
                               stride_ == std::int64_t{dimension} * cluster_size && fixed_ == fixed;
    ++updates_;
    size_ = static_cast<std::int64_t>(position.size());
    fixed_ = fixed;
    stride_ = std::int64_t{dimension} * cluster_size;
    places_.resize(static_cast<std::size_t>(cluster_count() * stride_));
    if (!is_comparable) {
        known_since_ = updates_;
        travels_.assign(static_cast<std::size_t>(block_count()), {});
    }
    parallel::for_each_uneven(block_count(), 16, [&](std::int64_t b) {
        const Motion step =
            dimension == 2 ? place_block<2>(position, b, is_comparable) : place_block<3>(position, b, is_comparable);
        Travel& travel = travels_[static_cast<std::size_t>(b)];
        for (int axis = 0; is_comparable && axis < dimension; ++axis) {
            travel.low[axis] += static_cast<double>(step[axis]);
            travel.high[axis] -= static_cast<double>(step[axis + 4]);
        }
    });
}

bool ClusterPlaces::is_at(std::span<const Vec3> position) const {
    const std::int64_t dimension = stride_ / cluster_size;
    bool is_there = size_ == static_cast<std::int64_t>(position.size());
    for (const std::int64_t i : {std::int64_t{0}, size_ / 2, size_ - 1}) {
        for (std::int64_t axis = 0; is_there && size_ > 0 && axis < dimension; ++axis) {
            is_there = cluster(i / cluster_size)[axis * cluster_size + i % cluster_size] ==
                       fixed_(position[static_cast<std::size_t>(i)], static_cast<int>(axis));
        }
    }
    return is_there;
}

std::size_t ClusterPlaces::bytes() const { return bytes_of(travels_, places_); }

}  // namespace riprap::fluid
