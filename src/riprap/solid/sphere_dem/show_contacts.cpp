// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/show_contacts.hpp"

#include "riprap/core/index.hpp"
#include "riprap/solid/sphere_dem/place.hpp"

namespace riprap::solid::sphere_dem {

namespace {

void show_spheres(const SphereModel& model, const SphereState& state, const SphereScratch& scratch,
                  std::vector<contact::ShownContact>& shown) {
    for (std::size_t c = 0; c < scratch.forces.size(); ++c) {
        const auto a = at(static_cast<std::int64_t>(state.contacts.pair[c] >> 32)),
                   b = at(static_cast<std::int64_t>(state.contacts.pair[c] & 0xFFFFFFFF));
        const SphereRecord &one = scratch.placed.records[a], &other = scratch.placed.records[b];
        const Vec3 center{one.x, one.y, one.z}, apart = Vec3{other.x, other.y, other.z} - center;
        const double distance = norm(apart), overlap = one.radius + other.radius - distance;
        const Vec3 normal = apart / distance;
        shown.push_back(contact::shown_contact(BodyId{model.spheres.body[a]}, BodyId{model.spheres.body[b]},
                                               center + (one.radius - 0.5 * overlap) * normal, scratch.forces[c],
                                               normal));
        shown.back().overlap = overlap;
        shown.back().is_sliding = state.contacts.stiffness[c] < 0;
    }
}

void show_walls(const SphereModel& model, const SphereState& state, const SphereScratch& scratch,
                std::vector<contact::ShownContact>& shown) {
    for (std::size_t c = 0; c < scratch.wall_loads.size() && c < scratch.walls.size(); ++c) {
        const WallContact& wall = scratch.walls[c];
        shown.push_back(contact::shown_contact(BodyId{model.spheres.body[at(wall.sphere)]},
                                               BodyId{wall_body(model, wall.wall)}, wall.point,
                                               scratch.wall_loads[c].force, wall.normal));
        shown.back().overlap = wall.overlap;
        shown.back().is_sliding = state.walls.stiffness[c] < 0;
    }
}

}  // namespace

void show_contacts(const SphereModel& model, const SphereState& state, const SphereScratch& scratch,
                   std::vector<contact::ShownContact>& shown) {
    if (scratch.evaluations == state.evaluations) {  // else the buffers belong to another State
        show_spheres(model, state, scratch, shown);
        show_walls(model, state, scratch, shown);
    }
}

}  // namespace riprap::solid::sphere_dem
