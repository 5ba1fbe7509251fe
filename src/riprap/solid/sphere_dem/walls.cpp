// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/walls.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/contact/narrowphase/sphere_triangle.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/sphere_dem/contact_response.hpp"
#include "riprap/solid/sphere_dem/place.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// A triangle that a sphere reaches.
struct Reached {
    WallContact contact;
    contact::TriangleFeature feature;
    std::array<std::int32_t, 2> vertices;  ///< of the edge, increasing; of a corner twice the same
    std::int32_t triangle;
};

Reached reach(const SphereModel& model, const Placed& placed, const contact::PartPair pair, std::int32_t parts) {
    const std::int32_t t = pair.b - parts;
    const Vec3* corner = &placed.corner[at(3 * t)];
    const std::int32_t* vertex = &model.triangles.vertices[at(3 * t)];
    const Vec3& centre = placed.center[at(pair.a)];
    const contact::TrianglePoint nearest = contact::nearest_on_triangle(corner[0], corner[1], corner[2], centre);
    const Vec3 into = nearest.point - centre;
    const double distance = norm(into);
    const Vec3 face = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const std::int32_t first = vertex[nearest.corner];
    const std::int32_t second =
        nearest.feature == contact::TriangleFeature::edge ? vertex[(nearest.corner + 1) % 3] : first;
    return {{pair.a, pair.b, distance > 0 ? into / distance : -normalized(face), nearest.point,
             placed.radius[at(pair.a)] - distance, 1},
            nearest.feature,
            {std::min(first, second), std::max(first, second)},
            t};
}

/// May a contact at an edge or corner count? Only where it is the nearest feature of every reached triangle that has
/// it, and the triangle is the first of those.
bool counts(const SphereModel& model, const std::vector<Reached>& all, const Reached& one) {
    if (one.feature == contact::TriangleFeature::face) {
        return true;
    }
    for (const Reached& other : all) {
        const std::int32_t* vertex = &model.triangles.vertices[at(3 * other.triangle)];
        const auto has = [&](std::int32_t v) { return vertex[0] == v || vertex[1] == v || vertex[2] == v; };
        if (other.triangle == one.triangle || !has(one.vertices[0]) || !has(one.vertices[1])) {
            continue;
        }
        const bool is_same = other.feature == one.feature && other.vertices == one.vertices;
        if (!is_same || other.triangle < one.triangle) {
            return false;
        }
    }
    return true;
}

/// Contacts of the candidates [begin, end), all of one sphere.
void find_of_sphere(const SphereModel& model, const SphereScratch& scratch, std::size_t begin, std::size_t end,
                    std::vector<Reached>& reached, std::vector<WallContact>& out) {
    const Placed& placed = scratch.placed;
    const std::int32_t parts = model.bodies.part_count();
    reached.clear();
    for (std::size_t p = begin; p < end; ++p) {
        const contact::PartPair pair = scratch.wall_pairs[p];
        if (pair.b >= parts) {
            const Reached one = reach(model, placed, pair, parts);
            if (one.contact.overlap > 0) {
                reached.push_back(one);
            }
            continue;
        }
        const contact::SphereTouch touch =
            contact::touch_convex(model.shapes.view(model.bodies.parts[at(pair.b)].shape),
                                  placed.part_frame[at(pair.b)], placed.center[at(pair.a)], placed.radius[at(pair.a)]);
        if (touch.overlap > 0) {
            out.push_back({pair.a, pair.b, touch.normal, touch.point, touch.overlap, 1});
        }
    }
    for (const Reached& one : reached) {
        if (counts(model, reached, one)) {
            out.push_back(one.contact);
        }
    }
}

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
    double lost = 0;
    std::size_t from = 0;
    const auto drop = [&] {
        const double stiffness = std::abs(old.stiffness[from]);
        lost += stiffness > 0 ? norm_squared(old.force[from]) / (2 * stiffness) : 0;
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
    return lost;
}

/// Loads of one contact.
struct WallLoad {
    Vec3 force, torque, wall_torque;  ///< on the sphere's body, about the centres of mass
    ContactSums sums;
};

WallLoad load_of(const SphereModel& model, const body::BodyState& bodies, const SphereScratch& scratch, double dt,
                 std::size_t c, Springs& springs) {
    const WallContact& contact = scratch.walls[c];
    const auto s = at(contact.sphere), body = at(model.spheres.body[s]), wall = at(wall_body(model, contact.wall));
    const SphereRecord& record = scratch.placed.records[s];
    const Vec3 spin = scratch.kinematics.angular_velocity[body], wall_spin = scratch.kinematics.angular_velocity[wall];
    const Vec3 arm = contact.point - bodies.position[body], wall_arm = contact.point - bodies.position[wall];
    ContactMotion<double> motion;
    motion.normal = contact.normal;
    motion.old_normal = springs.normal[c];
    motion.velocity = bodies.velocity[body] + cross(spin, arm) - bodies.velocity[wall] - cross(wall_spin, wall_arm);
    motion.spin = spin - wall_spin;
    motion.mean_turn = 0.5 * dt * dot(spin + wall_spin, contact.normal);
    motion.overlap = contact.overlap;
    motion.radius = record.radius;
    motion.mass = 1 / (record.inverse_mass + scratch.kinematics.inverse_mass[wall]);
    const bool shares_dashpots = model.settings.sharing == contact::Sharing::dashpots;
    motion.weight = shares_dashpots ? 1 : contact.weight;
    motion.damping_weight = contact.weight;
    motion.count = shares_dashpots                                      ? 1 / (contact.weight * contact.weight)
                   : model.settings.sharing == contact::Sharing::divide ? 1 / contact.weight
                                                                        : 1;
    motion.dt = dt;
    contact::TangentialSpring<double> spring{springs.force[c], springs.stiffness[c]};
    Vec3 rolling = springs.rolling.empty() ? Vec3{} : springs.rolling[c];
    const auto surfaces = surface_pair(model.table.pair(model.bodies.material[body], model.bodies.material[wall]));
    const ContactResponse<double> response = model.settings.tangential.visit([&](const auto& friction) {
        return respond_to<double>(model.settings, friction, surfaces, motion, spring, rolling);
    });
    springs.force[c] = spring.force;
    springs.stiffness[c] = spring.stiffness;
    springs.normal[c] = contact.normal;
    if (!springs.rolling.empty()) {
        springs.rolling[c] = rolling;
    }
    return {response.force,
            cross(arm, response.force) + response.couple,
            -cross(wall_arm, response.force) - response.couple,
            {response.elastic, response.friction_loss, response.damping_loss, response.rolling_loss,
             contact.overlap / record.radius}};
}

}  // namespace

void find_walls(const SphereModel& model, SphereScratch& scratch) {
    const auto count = static_cast<std::int64_t>(scratch.wall_pairs.size());
    constexpr std::int64_t share = 512;
    scratch.wall_chunks.resize(at((count + share - 1) / share));
    parallel::for_ranges(count, share, [&](std::int64_t begin, std::int64_t end) {
        std::vector<WallContact>& out = scratch.wall_chunks[at(begin / share)];
        out.clear();
        std::vector<Reached> reached;
        const auto sphere = [&](std::int64_t p) { return scratch.wall_pairs[at(p)].a; };
        // A sphere belongs to the range in which its first candidate lies.
        while (begin > 0 && begin < end && sphere(begin) == sphere(begin - 1)) {
            ++begin;
        }
        while (end < count && begin < end && sphere(end) == sphere(end - 1)) {
            ++end;
        }
        for (std::int64_t p = begin; p < end;) {
            std::int64_t q = p;
            while (q < end && sphere(q) == sphere(p)) {
                ++q;
            }
            find_of_sphere(model, scratch, at(p), at(q), reached, out);
            p = q;
        }
    });
    scratch.walls.clear();
    for (const auto& chunk : scratch.wall_chunks) {
        scratch.walls.insert(scratch.walls.end(), chunk.begin(), chunk.end());
    }
}

ContactSums respond_to_walls(const SphereModel& model, const body::BodyState& bodies, double dt, SphereState& state,
                             SphereScratch& scratch) {
    ContactSums sums;
    sums.friction_loss =
        carry_springs(model.settings.rolling == contact::RollingLaw::spring, scratch.walls, state.walls);
    std::vector<WallLoad> loads(scratch.walls.size());
    parallel::for_each_uneven(static_cast<std::int64_t>(loads.size()), 256, [&](std::int64_t c) {
        loads[at(c)] = load_of(model, bodies, scratch, dt, at(c), state.walls);
    });
    for (std::size_t c = 0; c < scratch.walls.size(); ++c) {
        const WallLoad& load = loads[c];
        const auto body = at(model.spheres.body[at(scratch.walls[c].sphere)]);
        const auto wall = at(wall_body(model, scratch.walls[c].wall));
        scratch.loads.force[body] += load.force;
        scratch.loads.torque[body] += load.torque;
        scratch.loads.force[wall] -= load.force;
        scratch.loads.torque[wall] += load.wall_torque;
        sums += load.sums;
    }
    return sums;
}

}  // namespace riprap::solid::sphere_dem
