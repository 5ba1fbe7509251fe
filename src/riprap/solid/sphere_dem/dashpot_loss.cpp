// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/dashpot_loss.hpp"

#include "riprap/core/index.hpp"
#include "riprap/core/sum.hpp"
#include "riprap/solid/sphere_dem/place.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// Fills in how bodies turn after the kick; those that forces do not move go on.
void find_spins(const body::BodyState& bodies, SphereScratch& scratch) {
    const body::BodyKinematics& kinematics = scratch.kinematics;
    scratch.spin_after.resize(kinematics.inverse_mass.size());
    parallel::for_each(static_cast<std::int64_t>(scratch.spin_after.size()), [&](std::int64_t index) {
        const auto b = at(index);
        scratch.spin_after[b] = kinematics.inverse_mass[b] > 0
                                    ? kinematics.inverse_inertia[b] * bodies.angular_momentum[b]
                                    : kinematics.angular_velocity[b];
    });
}

}  // namespace

DashpotLoss dashpot_loss(const SphereModel& model, const body::BodyState& bodies, const SphereState& state,
                         double power, double dt, SphereScratch& scratch) {
    if (power == 0) {  // no dashpot pushes
        return {};
    }
    find_spins(bodies, scratch);
    const auto velocity_at = [&](std::size_t body, const Vec3& point) {
        return bodies.velocity[body] + cross(scratch.spin_after[body], point - bodies.position[body]);
    };
    const double of_spheres = parallel::sum(static_cast<std::int64_t>(state.contacts.size()), [&](std::int64_t i) {
        const std::uint64_t key = state.contacts.pair[at(i)];
        const auto a = static_cast<std::size_t>(key >> 32), b = static_cast<std::size_t>(key & 0xFFFFFFFF);
        const SphereRecord &one = scratch.placed.records[a], &other = scratch.placed.records[b];
        const Vec3 from{one.x, one.y, one.z}, way = Vec3{other.x, other.y, other.z} - from;
        // The arms of both spheres end in one point where they touch, and share the overlap by their radii.
        const double share = 1 / (one.radius + other.radius);
        const Vec3 u = velocity_at(at(model.spheres.body[a]), from + (one.radius * share) * way) -
                       velocity_at(at(model.spheres.body[b]), from + (1 - other.radius * share) * way);
        return dot(scratch.dashpots[at(i)], u);
    });
    const double of_walls = parallel::sum(static_cast<std::int64_t>(scratch.walls.size()), [&](std::int64_t i) {
        const WallContact& contact = scratch.walls[at(i)];
        const Vec3 u = velocity_at(at(model.spheres.body[at(contact.sphere)]), contact.point) -
                       velocity_at(at(wall_body(model, contact.wall)), contact.point);
        return dot(scratch.wall_loads[at(i)].dashpot, u);
    });
    const double half = 0.5 * dt;
    return {half * power, half * (power - of_spheres - of_walls)};
}

}  // namespace riprap::solid::sphere_dem
