// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/random_stream.hpp"

#include <cmath>
#include <numbers>

#include "riprap/core/fields.hpp"

namespace riprap::scene {

namespace {
constexpr std::uint64_t golden = 0x9E3779B97F4A7C15ULL;

std::uint64_t scramble(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
}
}  // namespace

std::uint64_t seed_of(std::uint64_t case_seed, std::string_view name) {
    Hasher hasher;
    hasher.add(name.data(), name.size());
    return scramble(case_seed + golden) ^ hasher.value();
}

RandomStream::RandomStream(std::uint64_t seed, std::string_view name, std::uint64_t number)
    : state_(scramble(seed_of(seed, name) + golden * (number + 1))) {}

std::uint64_t RandomStream::next() { return scramble(state_ += golden); }

double RandomStream::uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }

Quat RandomStream::orientation(bool is_planar) {
    constexpr double turn = 2 * std::numbers::pi;
    if (is_planar) {
        return from_rotation_vector({0, 0, uniform(0, turn)});
    }
    // A uniform point of the unit sphere in four dimensions [Shoemake1992].
    const double u = uniform(), a = turn * uniform(), b = turn * uniform();
    const double p = std::sqrt(1 - u), q = std::sqrt(u);
    return normalized({p * std::sin(a), p * std::cos(a), q * std::sin(b), q * std::cos(b)});
}

}  // namespace riprap::scene
