// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/released.hpp"

#include "riprap/core/index.hpp"

namespace riprap::solid::affine {

std::vector<ReleasedBlock> released_blocks(const body::BodySet& bodies, const TimeSpan& span, double previous_dt,
                                           const BlockState& blocks) {
    std::vector<ReleasedBlock> released;
    if (previous_dt == 0) {
        return released;
    }
    // The span before began at time - previous_dt but for rounding; a release then was booked then.
    const double before = span.time - (1 - 1e-9) * previous_dt;
    for (std::int32_t b = 0; b < blocks.size(); ++b) {
        if (is_free(bodies, BodyId{b}, span.time) && !is_free(bodies, BodyId{b}, before)) {
            const auto i = at(b);
            released.push_back({b, blocks.position[i], blocks.velocity[i], rows_at(blocks.velocity_gradient, i)});
        }
    }
    return released;
}

namespace {

/// Books a block at `place` with the momenta of `before` and the energy of a velocity and its gradient.
void book(const BlockSystem& system, const BlockState& blocks, const Vec3& place, const ReleasedBlock& before,
          const Vec3& velocity, const Mat3& gradient, KickReport& kick) {
    const auto b = at(before.block);
    const double mass = system.mass[b];
    const Mat3 f = rows_at(blocks.deformation, b);
    const Mat3 inertia = f * system.inertia[b] * transpose(f);
    kick.released_energy += 0.5 * (mass * norm_squared(velocity) + trace(gradient * inertia * transpose(gradient))) -
                            mass * dot(system.gravity, place);
    kick.released_momentum += mass * before.velocity;
    kick.released_angular_momentum += mass * cross(place, before.velocity) + angular_momentum(inertia, before.gradient);
    kick.released_mass_moment += mass * place;
}

}  // namespace

void book_released(const BlockSystem& system, const BlockState& blocks, const ReleasedBlock& released,
                   KickReport& kick) {
    book(system, blocks, released.position, released, released.velocity, released.gradient, kick);
}

void book_released_at_middle(const BlockSystem& system, const BlockState& blocks, double dt,
                             const ReleasedBlock& released, KickReport& kick) {
    const auto b = at(released.block);
    const Vec3 after = blocks.velocity[b];
    book(system, blocks, blocks.position[b] - (0.5 * dt) * after, released, 0.5 * (released.velocity + after),
         0.5 * (released.gradient + rows_at(blocks.velocity_gradient, b)), kick);
}

}  // namespace riprap::solid::affine
