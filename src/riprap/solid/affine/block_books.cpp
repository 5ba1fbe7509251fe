// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/block_books.hpp"

#include <algorithm>

namespace riprap::solid::affine {

void book_sums(const BlockSums& sums, KickReport& kick) {
    kick.mass = sums.mass;
    kick.kinetic = sums.kinetic;
    kick.potential = sums.potential;
    kick.momentum = sums.momentum;
    kick.angular_momentum = sums.angular_momentum;
}

void book_outside(const BlockSystem& system, const BlockState& blocks, const body::LoadView& given,
                  const body::Loads& contacts, double dt, double since, KickReport& kick) {
    for (std::size_t b = 0; b < system.mass.size(); ++b) {
        const Vec3 x = blocks.position[b] - since * blocks.velocity[b];
        if (system.is_fixed[b] != 0) {
            const Vec3 spin = spin_of(rows_at(blocks.velocity_gradient, b));
            kick.impulse -= dt * contacts.force[b];
            kick.angular_impulse -= dt * (cross(x, contacts.force[b]) + contacts.torque[b]);
            kick.work_driven -= dt * (dot(contacts.force[b], blocks.velocity[b]) + dot(contacts.torque[b], spin));
            continue;
        }
        const Vec3 outside = system.mass[b] * system.gravity + (given.empty() ? Vec3{} : given.force[b]);
        kick.impulse += dt * outside;
        kick.angular_impulse += dt * (cross(x, outside) + (given.empty() ? Vec3{} : given.torque[b]));
        kick.mass_moment += system.mass[b] * x;
        kick.max_speed = std::max(kick.max_speed, norm(blocks.velocity[b]));
    }
}

}  // namespace riprap::solid::affine
