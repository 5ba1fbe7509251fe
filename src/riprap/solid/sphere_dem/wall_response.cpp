// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/sphere_dem/eight_contacts.hpp"
#include "riprap/solid/sphere_dem/place.hpp"
#include "riprap/solid/sphere_dem/walls.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// Are the contacts of the springs those found now?
bool are_of(const Springs& springs, const std::vector<WallContact>& walls) {
    return springs.size() == walls.size() &&
           std::equal(walls.begin(), walls.end(), springs.pair.begin(), [](const WallContact& c, std::uint64_t pair) {
               return c.sphere == static_cast<std::int32_t>(pair >> 32) &&
                      c.wall == static_cast<std::int32_t>(pair & 0xFFFFFFFF);
           });
}

/// Brings the springs of walls into the rows of the contacts found now. @returns energy of lost springs [J]
double carry_springs(bool has_rolling, const std::vector<WallContact>& walls, Springs& springs) {
    if (are_of(springs, walls) && springs.rolling.size() == (has_rolling ? walls.size() : 0)) {
        return 0;
    }
    const Springs old = springs;
    const std::size_t count = walls.size();
    springs.pair.resize(count);
    springs.force.resize(count);
    springs.stiffness.resize(count);
    springs.normal.resize(count);
    springs.rolling.assign(has_rolling ? count : 0, {});
    ExactSum lost;
    std::size_t from = 0;
    const auto drop = [&] {
        const double stiffness = std::abs(old.stiffness[from]);
        lost.add(stiffness > 0 ? norm_squared(old.force[from]) / (2 * stiffness) : 0);
        ++from;
    };
    for (std::size_t c = 0; c < count; ++c) {
        const std::uint64_t key =
            static_cast<std::uint64_t>(walls[c].sphere) << 32 | static_cast<std::uint64_t>(walls[c].wall);
        while (from < old.size() && old.pair[from] < key) {
            drop();
        }
        const bool is_old = from < old.size() && old.pair[from] == key;
        springs.pair[c] = key;
        springs.force[c] = is_old ? old.force[from] : Vec3{};
        springs.stiffness[c] = is_old ? old.stiffness[from] : 0;
        springs.normal[c] = is_old ? old.normal[from] : walls[c].normal;
        if (has_rolling && is_old && old.rolling.size() == old.size()) {
            springs.rolling[c] = old.rolling[from];
        }
        from += is_old ? 1 : 0;
    }
    while (from < old.size()) {
        drop();
    }
    return lost.value();
}

/// Contacts side by side: a vector of the machine.
constexpr std::int64_t side_by_side = lanes_in<Native>;

/// Contacts of spheres with walls, side by side.
struct WallGroup {
    ContactMotion<Native> motion;
    Native room;  ///< that the overlap is judged against [m]
    RowsOf<Native> material, wall_material;
    Vec3 arm[side_by_side], wall_arm[side_by_side];  ///< from the centres of mass to the contacts [m]
};

/// Everything that stays the same over all contacts with walls.
template <class Law>
struct RespondToWalls {
    const Law& friction;
    const SphereModel& model;
    const body::BodyState& bodies;
    double dt;
    Springs& springs;
    SphereScratch& scratch;
    const Surfaces<Native>& surfaces;

    /// Shear strength of the surface that a sample stands for, c A [N].
    double cohesion_of(const WallContact& contact, std::size_t body, std::size_t wall) const {
        return model.cohesion.empty() ? 0
                                      : model.spheres.area[at(contact.sphere)] *
                                            model.cohesion[at(model.bodies.material[body].value * model.table.size() +
                                                              model.bodies.material[wall].value)];
    }

    WallGroup group_at(std::size_t first, std::int64_t count) const {
        WallGroup g;
        enum {
            normal = 0,
            old_normal = 3,
            velocity = 6,
            spin = 9,
            turn = 12,
            overlap,
            radius,
            room,
            mass,
            weight,
            portion,
            cohesion,
            numbers
        };
        alignas(64) double of[numbers][side_by_side];
        const auto set = [&](int number, std::int64_t lane, const Vec3& v) {
            of[number][lane] = v.x;
            of[number + 1][lane] = v.y;
            of[number + 2][lane] = v.z;
        };
        for (std::int64_t lane = 0; lane < side_by_side; ++lane) {
            const std::size_t c = first + at(std::min(lane, count - 1));
            const WallContact& contact = scratch.walls[c];
            const auto body = at(model.spheres.body[at(contact.sphere)]), wall = at(wall_body(model, contact.wall));
            const Vec3& body_spin = scratch.kinematics.angular_velocity[body];
            const Vec3& wall_spin = scratch.kinematics.angular_velocity[wall];
            const Vec3 arm = contact.point - bodies.position[body], wall_arm = contact.point - bodies.position[wall];
            g.arm[lane] = arm;
            g.wall_arm[lane] = wall_arm;
            g.material.row[lane] = model.bodies.material[body].value;
            g.wall_material.row[lane] = model.bodies.material[wall].value;
            set(normal, lane, contact.normal);
            set(old_normal, lane, springs.normal[c]);
            set(velocity, lane,
                bodies.velocity[body] + cross(body_spin, arm) - bodies.velocity[wall] - cross(wall_spin, wall_arm));
            set(spin, lane, body_spin - wall_spin);
            of[turn][lane] = 0.5 * dt * dot(body_spin + wall_spin, contact.normal);
            of[overlap][lane] = contact.overlap;
            of[radius][lane] = model.spheres.curvature[at(contact.sphere)];
            of[room][lane] = contact.room;
            of[mass][lane] = scratch.kinematics.inverse_mass[body] + scratch.kinematics.inverse_mass[wall];
            of[weight][lane] = contact.weight;
            of[portion][lane] = contact.portion;
            of[cohesion][lane] = cohesion_of(contact, body, wall);
        }
        const auto numbers_of = [&](int number) { return Native::load(of[number]); };
        const auto vectors = [&](int number) {
            return Vec3T<Native>{numbers_of(number), numbers_of(number + 1), numbers_of(number + 2)};
        };
        const Native one(1.0), share = numbers_of(weight), own = numbers_of(portion);
        g.room = numbers_of(room);
        const bool shares_dashpots = model.settings.sharing == contact::Sharing::dashpots;
        g.motion = {.normal = vectors(normal),
                    .old_normal = vectors(old_normal),
                    .velocity = vectors(velocity),
                    .spin = vectors(spin),
                    .mean_turn = numbers_of(turn),
                    .overlap = numbers_of(overlap),
                    .radius = numbers_of(radius),
                    .mass = one / numbers_of(mass),
                    .inverse_mass = numbers_of(mass),
                    .weight = shares_dashpots ? own : share * own,
                    .damping_weight = share * own,
                    .count = shares_dashpots                                      ? one / (share * share * own)
                             : model.settings.sharing == contact::Sharing::divide ? one / (share * own)
                                                                                  : one,
                    .dt = Native(dt),
                    .cohesion = numbers_of(cohesion)};
        return g;
    }

    /// Loads of the contacts [first, first + count), part `p` of a group.
    [[gnu::flatten]] void part(std::size_t first, std::int64_t count, std::size_t p, WideSums& sums) const {
        const WallGroup g = group_at(first, count);
        contact::TangentialSpring<Native> spring;
        Vec3T<Native> rolling{};
        RowsOf<Native> rows;
        for (std::int64_t lane = 0; lane < side_by_side; ++lane) {
            rows.row[lane] = static_cast<std::int32_t>(first) + static_cast<std::int32_t>(std::min(lane, count - 1));
        }
        spring = {gather(springs.force.data(), rows), gather<1>(springs.stiffness.data(), rows)};
        if (!springs.rolling.empty()) {
            rolling = gather(springs.rolling.data(), rows);
        }
        const SurfacePair<Native> pair =
            surfaces.is_uniform() ? surfaces.first() : surfaces.of(g.material, g.wall_material);
        const ContactResponse<Native> response =
            model.cohesion.empty()
                ? respond_to<Native>(ChosenLaws{model.settings}, friction, pair, g.motion, spring, rolling)
                : respond_to<Native>(CohesiveLaws{{model.settings}}, friction, pair, g.motion, spring, rolling);
        for (std::int64_t lane = 0; lane < count; ++lane) {
            const std::size_t c = first + at(lane);
            springs.force[c] = lane_of(spring.force, lane);
            springs.stiffness[c] = spring.stiffness[lane];
            springs.normal[c] = scratch.walls[c].normal;
            if (!springs.rolling.empty()) {
                springs.rolling[c] = lane_of(rolling, lane);
            }
            const Vec3 force = lane_of(response.force, lane), couple = lane_of(response.couple, lane);
            scratch.wall_loads[c] = {force, cross(g.arm[lane], force) + couple,
                                     -cross(g.wall_arm[lane], force) - couple, lane_of(response.dashpot, lane)};
        }
        sums.add(response, g.motion.overlap / g.room, p, count);
    }
};

template <class Law>
ContactSums respond_by(const Law& friction, const SphereModel& model, const body::BodyState& bodies, double dt,
                       Springs& springs, SphereScratch& scratch) {
    const Surfaces<Native> surfaces(model.table, model.settings.normal);
    const RespondToWalls<Law> work{friction, model, bodies, dt, springs, scratch, surfaces};
    // Contacts come in the order of their spheres; those of a block of spheres are one thread's work and one sum.
    const LoadRows& rows = scratch.load_rows;
    const auto first_of = [&](std::int64_t block) {
        return std::ranges::lower_bound(scratch.walls, rows.first_sphere[at(block)], {}, &WallContact::sphere) -
               scratch.walls.begin();
    };
    std::vector<ContactSums> partial(at(rows.block_count()));
    parallel::for_each_uneven(rows.block_count(), 1, [&](std::int64_t block) {
        WideSums sums;
        const std::int64_t end = first_of(block + 1);
        for (std::int64_t c = first_of(block), p = 0; c < end; c += side_by_side, p = p + 1 < parts ? p + 1 : 0) {
            work.part(at(c), std::min(side_by_side, end - c), at(p), sums);
        }
        partial[at(block)] = sums.fold();
    });
    return parallel::total_of(partial);
}

}  // namespace

ContactSums respond_to_walls(const SphereModel& model, const body::BodyState& bodies, double dt, SphereState& state,
                             SphereScratch& scratch) {
    const double lost =
        carry_springs(model.settings.rolling == contact::RollingLaw::spring, scratch.walls, state.walls);
    scratch.wall_loads.resize(scratch.walls.size());
    ContactSums sums = model.settings.tangential.visit(
        [&](const auto& friction) { return respond_by(friction, model, bodies, dt, state.walls, scratch); });
    sums.friction_loss += lost;
    for (std::size_t c = 0; c < scratch.walls.size(); ++c) {
        const WallLoad& load = scratch.wall_loads[c];
        const auto body = at(model.spheres.body[at(scratch.walls[c].sphere)]);
        const auto wall = at(wall_body(model, scratch.walls[c].wall));
        scratch.loads.force[body] += load.force;
        scratch.loads.torque[body] += load.torque;
        scratch.loads.force[wall] -= load.force;
        scratch.loads.torque[wall] += load.wall_torque;
    }
    return sums;
}

}  // namespace riprap::solid::sphere_dem
