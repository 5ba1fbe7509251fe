// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/assemble/random_stream.hpp"

#include <cmath>
#include <numbers>

#include "riprap/core/fields.hpp"
#include "riprap/geometry/polyhedra/random_bits.hpp"

namespace riprap::scene {

std::uint64_t seed_of(std::uint64_t case_seed, std::string_view name) {
    Hasher hasher;
    hasher.add(name.data(), name.size());
    return geometry::mix_bits(case_seed, hasher.value());
}

RandomStream::RandomStream(std::uint64_t seed, std::string_view name, std::uint64_t number)
    : key_(geometry::mix_bits(seed_of(seed, name), number)) {}

double RandomStream::uniform() { return geometry::unit_interval(geometry::mix_bits(key_, count_++)); }

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
