// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/explicit_dda/pair_mobility.hpp"

#include <algorithm>

#include "riprap/core/index.hpp"

namespace riprap::solid::explicit_dda {

using affine::BlockContact, affine::BlockSystem;

namespace {

/// Inverse mass and inverse moments of a block; nought where loads do not move it.
struct Lightness {
    double mass{0};
    Mat3 turn;
};

Lightness lightness_of(const BlockSystem& system, const affine::BlockState& state, std::int32_t block) {
    const auto b = at(block);
    if (system.is_fixed[b] != 0) {
        return {};
    }
    const Mat3 f = affine::rows_at(state.deformation, b);
    const Mat3 second = f * system.inertia[b] * transpose(f);
    const double t = trace(second);
    return {1 / system.mass[b], inverse(Mat3::diagonal({t, t, t}) - second)};
}

/// Acceleration of gap i by a unit force at j, of one of the two blocks.
double acceleration(const Lightness& block, const Vec3& centre, const Vec3& at_i, const Vec3& normal_i,
                    const Vec3& at_j, const Vec3& normal_j) {
    return block.mass * dot(normal_i, normal_j) +
           dot(cross(at_i - centre, normal_i), block.turn * cross(at_j - centre, normal_j));
}

}  // namespace

std::vector<double> pair_mobility(const BlockSystem& system, const affine::BlockState& state,
                                  const std::vector<BlockContact>& contacts) {
    std::vector<double> mobility;
    if (!system.surfaces.are_damped()) {
        return mobility;
    }
    mobility.resize(contacts.size());
    for (std::size_t begin = 0, end = 0; begin < contacts.size(); begin = end) {
        const BlockContact& first = contacts[begin];
        while (end < contacts.size() && contacts[end].a == first.a && contacts[end].b == first.b) {
            ++end;
        }
        const Lightness a = lightness_of(system, state, first.a), b = lightness_of(system, state, first.b);
        const Vec3 &at_a = state.position[at(first.a)], &at_b = state.position[at(first.b)];
        const affine::Surface& surface = system.surface_of(first.a, first.b);
        for (std::size_t i = begin; i < end; ++i) {
            const BlockContact& point = contacts[i];
            double sum = 0;
            for (std::size_t j = begin; j < end; ++j) {
                const BlockContact& other = contacts[j];
                if (j == i || other.gap < 0) {
                    sum += surface.factor(other.area) / surface.factor(point.area) *
                           (acceleration(a, at_a, point.on_a, point.normal, other.on_a, other.normal) +
                            acceleration(b, at_b, point.on_b, point.normal, other.on_b, other.normal));
                }
            }
            mobility[i] = std::max(sum, a.mass + b.mass);
        }
    }
    return mobility;
}

}  // namespace riprap::solid::explicit_dda
