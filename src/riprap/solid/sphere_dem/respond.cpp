// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/respond.hpp"

#include <algorithm>

#include "riprap/contact/law/closest_pair.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/lanes.hpp"
#include "riprap/solid/sphere_dem/contact_response.hpp"

namespace riprap::solid::sphere_dem {

namespace {

constexpr std::int64_t range_contacts = 1024;  ///< contacts that one thread takes at a time; part of the sums

SurfacePair<Eight> spread(const contact::ContactPair& p) {
    return {Eight(p.modulus),          Eight(p.shear_modulus),    Eight(p.ratio),
            Eight(p.static_friction),  Eight(p.kinetic_friction), Eight(p.rolling_friction),
            Eight(p.normal_stiffness), Eight(p.shear_ratio)};
}

/// Constants of the pairs of eight contacts.
SurfacePair<Eight> surfaces_of(const SphereModel& model, const Placed& placed, const RowIndex& a, const RowIndex& b) {
    SurfacePair<Eight> out = spread(model.table.pair(MaterialId{0}, MaterialId{0}));
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        const MaterialId of_a{static_cast<std::int32_t>(placed.records[at(a.row[lane])].material)};
        const MaterialId of_b{static_cast<std::int32_t>(placed.records[at(b.row[lane])].material)};
        const contact::ContactPair& p = model.table.pair(of_a, of_b);
        out.modulus.set(lane, p.modulus);
        out.shear_modulus.set(lane, p.shear_modulus);
        out.ratio.set(lane, p.ratio);
        out.static_friction.set(lane, p.static_friction);
        out.kinetic_friction.set(lane, p.kinetic_friction);
        out.rolling_friction.set(lane, p.rolling_friction);
        out.normal_stiffness.set(lane, p.normal_stiffness);
        out.shear_ratio.set(lane, p.shear_ratio);
    }
    return out;
}

/// Side A or B of eight contacts.
struct Side {
    Vec3x8 x, v, w;
    Eight radius, inverse_mass;
};

Side load_side(const Placed& placed, const RowIndex& rows) {
    const double* r = &placed.records[0].x;
    const FourByEight x = load_four<12>(r, rows), v = load_four<12>(r + 4, rows), w = load_four<12>(r + 8, rows);
    return {{x.a, x.b, x.c}, {v.a, v.b, v.c}, {w.a, w.b, w.c}, x.d, v.d};
}

/// Motion of eight contacts along the lines of their centres. The normal of the last step is that of r - v dt, which is
/// where the centres were: velocities are constant between two evaluations.
/// @param arm  from A to B over the sum of radii: times its own radius, the arm of each sphere [-]
ContactMotion<Eight> motion_of(const Side& a, const Side& b, Eight dt, Vec3x8& arm) {
    ContactMotion<Eight> m;
    const Vec3x8 r = b.x - a.x, approach = a.v - b.v;
    const Eight distance = sqrt(dot(r, r)), reach = a.radius + b.radius;
    m.normal = r * (Eight(1.0) / distance);
    const Vec3x8 r_old = r + approach * dt;
    m.old_normal = r_old * (Eight(1.0) / sqrt(dot(r_old, r_old)));
    arm = r * (Eight(1.0) / reach);
    m.velocity = approach + cross(a.w * a.radius + b.w * b.radius, arm);
    m.spin = a.w - b.w;
    m.mean_turn = Eight(0.5) * dt * dot(a.w + b.w, m.normal);
    m.overlap = max(reach - distance, Eight(0.0));
    m.radius = a.radius * b.radius / reach;
    m.mass = Eight(1.0) / (a.inverse_mass + b.inverse_mass);
    m.weight = m.damping_weight = m.count = Eight(1.0);
    m.dt = dt;
    return m;
}

/// Sums of eight contacts at a time, folded in the order of the lanes.
struct WideSums {
    Eight elastic{}, friction{}, damping{}, rolling{}, deepest{};
    ContactSums fold() const {
        ContactSums sums;
        for (std::int64_t lane = 0; lane < lanes; ++lane) {
            sums += {elastic[lane], friction[lane], damping[lane], rolling[lane], deepest[lane]};
        }
        return sums;
    }
};

/// Puts contact normals of faces in place of those along the centres, see contact::closest_pair_normal.
void use_face_normals(const SphereModel& model, const body::BodyState& state, const RowIndex& a, const RowIndex& b,
                      const Side& of_a, const Side& of_b, ContactMotion<Eight>& m) {
    const auto world = [&](std::int32_t sphere) {
        const Vec3& n = model.spheres.face_normal[at(sphere)];
        return n == Vec3{} ? n : rotate(state.orientation[at(model.spheres.body[at(sphere)])], n);
    };
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        const Vec3 n = contact::closest_pair_normal(world(a.row[lane]), world(b.row[lane]), lane_of(m.normal, lane));
        const Vec3 r = lane_of(of_b.x, lane) - lane_of(of_a.x, lane);
        for (int axis = 0; axis < 3; ++axis) {
            (axis == 0 ? m.normal.x : axis == 1 ? m.normal.y : m.normal.z).set(lane, n[axis]);
        }
        m.overlap.set(lane, std::max(0.0, contact::overlap_along(n, r, of_a.radius[lane], of_b.radius[lane])));
    }
    m.old_normal = m.normal;
}

/// Input and output of one group of up to eight contacts.
struct Group {
    RowIndex a, b, row;
    std::int64_t first, count;
};

Group group_at(const Springs& springs, std::int64_t first, std::int64_t end) {
    Group g{};
    g.first = first;
    g.count = std::min(lanes, end - first);
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        const std::int64_t c = first + std::min(lane, g.count - 1);
        const std::uint64_t key = springs.pair[at(c)];
        g.a.row[lane] = static_cast<std::int32_t>(key >> 32);
        g.b.row[lane] = static_cast<std::int32_t>(key & 0xFFFFFFFF);
        g.row.row[lane] = static_cast<std::int32_t>(c);
    }
    return g;
}

void add_to(const ContactResponse<Eight>& response, const ContactMotion<Eight>& m, const Side& a, const Side& b,
            std::int64_t count, WideSums& sums) {
    Eight depth = m.overlap / min(a.radius, b.radius), elastic = response.elastic, friction = response.friction_loss,
          damping = response.damping_loss, rolling = response.rolling_loss;
    for (std::int64_t lane = count; lane < lanes; ++lane) {  // of the last group only
        for (Eight* value : {&depth, &elastic, &friction, &damping, &rolling}) {
            value->set(lane, 0);
        }
    }
    sums.elastic += elastic;
    sums.friction += friction;
    sums.damping += damping;
    sums.rolling += rolling;
    sums.deepest = max(sums.deepest, depth);
}

/// Everything that stays the same over a range of contacts.
template <class Law>
struct Respond {
    const Law& friction;
    const SphereModel& model;
    const body::BodyState& bodies;
    double dt;
    SphereState& state;
    SphereScratch& scratch;
    bool is_uniform, has_faces;
    SurfacePair<Eight> surfaces;

    /// Springs and loads of a group to their places.
    void store(const Group& g, const contact::TangentialSpring<Eight>& spring, const Vec3x8& rolling,
               const ContactResponse<Eight>& response, const Vec3x8& turn) const {
        Springs& springs = state.contacts;
        if (g.count == lanes) {
            store_vectors(spring.force, &springs.force[at(g.first)]);
            spring.stiffness.store(&springs.stiffness[at(g.first)]);
        } else {
            for (std::int64_t lane = 0; lane < g.count; ++lane) {
                springs.force[at(g.first + lane)] = lane_of(spring.force, lane);
                springs.stiffness[at(g.first + lane)] = spring.stiffness[lane];
            }
        }
        alignas(64) double turn_y[lanes], turn_z[lanes];
        turn.y.store(turn_y);
        turn.z.store(turn_z);
        double* rows[lanes];
        for (std::int64_t lane = 0; lane < g.count; ++lane) {
            ContactLoad& load = scratch.slots.load[scratch.contact_slot[at(g.first + lane)]];
            rows[lane] = &load.force.x;
            load.turn.y = turn_y[lane];
            load.turn.z = turn_z[lane];
        }
        store_four({response.force.x, response.force.y, response.force.z, turn.x}, rows, g.count);
        for (std::int64_t lane = 0; lane < g.count && !scratch.couple.empty(); ++lane) {
            const auto c = at(g.first + lane);
            if (!springs.rolling.empty()) {
                springs.rolling[c] = lane_of(rolling, lane);
            }
            scratch.couple[scratch.contact_slot[c]] = lane_of(response.couple, lane);
        }
    }

    void group(std::int64_t first, std::int64_t end, WideSums& sums) const {
        Springs& springs = state.contacts;
        const Group g = group_at(springs, first, end);
        const Side a = load_side(scratch.placed, g.a), b = load_side(scratch.placed, g.b);
        Vec3x8 arm;
        ContactMotion<Eight> motion = motion_of(a, b, Eight(dt), arm);
        if (has_faces) {
            use_face_normals(model, bodies, g.a, g.b, a, b, motion);
        }
        if (!scratch.weight.empty()) {
            motion.damping_weight = gather<1>(scratch.weight.data(), g.row);
            if (model.settings.sharing == contact::Sharing::dashpots) {
                motion.count = Eight(1.0) / (motion.damping_weight * motion.damping_weight);
            } else {
                motion.weight = motion.damping_weight;
                motion.count =
                    model.settings.sharing == contact::Sharing::divide ? Eight(1.0) / motion.weight : motion.count;
            }
        }
        contact::TangentialSpring<Eight> spring;
        if (g.count == lanes) {
            spring = {load_vectors(&springs.force[at(first)]), Eight::load(&springs.stiffness[at(first)])};
        } else {
            spring = {gather(springs.force.data(), g.row), gather<1>(springs.stiffness.data(), g.row)};
        }
        Vec3x8 rolling{};
        if (!springs.rolling.empty()) {
            rolling = gather(springs.rolling.data(), g.row);
        }
        const ContactResponse<Eight> response = respond_to<Eight>(
            model.settings, friction, is_uniform ? surfaces : surfaces_of(model, scratch.placed, g.a, g.b), motion,
            spring, rolling);
        store(g, spring, rolling, response, cross(arm, response.force));
        add_to(response, motion, a, b, g.count, sums);
    }
};

template <class Law>
ContactSums respond_by(const Law& friction, const SphereModel& model, const body::BodyState& bodies, double dt,
                       SphereState& state, SphereScratch& scratch) {
    const bool has_faces = model.settings.normals == contact::SphereNormals::faces;
    const Respond<Law> work{friction,
                            model,
                            bodies,
                            dt,
                            state,
                            scratch,
                            model.table.size() == 1,
                            has_faces,
                            spread(model.table.pair(MaterialId{0}, MaterialId{0}))};
    if (model.settings.rolling != contact::RollingLaw::none) {
        scratch.couple.assign(at(scratch.slots.count), {});
    }
    const auto count = static_cast<std::int64_t>(state.contacts.size());
    std::vector<ContactSums> partial(at((count + range_contacts - 1) / range_contacts));
    parallel::for_ranges(count, range_contacts, [&](std::int64_t begin, std::int64_t end) {
        WideSums sums;
        for (std::int64_t c = begin; c < end; c += lanes) {
            work.group(c, end, sums);
        }
        partial[at(begin / range_contacts)] = sums.fold();
    });
    ContactSums total;
    for (const ContactSums& p : partial) {
        total += p;
    }
    return total;
}

}  // namespace

ContactSums respond(const SphereModel& model, const body::BodyState& bodies, double dt, SphereState& state,
                    SphereScratch& scratch) {
    return model.settings.tangential.visit(
        [&](const auto& friction) { return respond_by(friction, model, bodies, dt, state, scratch); });
}

namespace {

/// Sum of the rolling couples on a sphere.
Vec3 couple_on(const Slots& slots, const std::vector<Vec3>& couples, std::size_t sphere) {
    Vec3 sum{};
    for (std::uint32_t p = slots.begin[sphere]; p < slots.begin[sphere + 1]; ++p) {
        sum += couples[p];
    }
    for (std::uint32_t k = slots.incoming_begin[sphere]; k < slots.incoming_begin[sphere + 1]; ++k) {
        sum -= couples[slots.incoming[k]];
    }
    return sum;
}

}  // namespace

void gather_loads(const SphereModel& model, const body::BodyState& state, SphereScratch& scratch) {
    const Slots& slots = scratch.slots;
    const auto bodies = at(model.bodies.size());
    scratch.loads.force.resize(bodies);
    scratch.loads.torque.resize(bodies);
    const bool has_couples = !scratch.couple.empty();
    constexpr double signs[lanes] = {-1, -1, -1, 1, 1, 1, 1, 1};
    const Eight sign_on_b = Eight::load(signs);
    parallel::for_each_uneven(model.bodies.size(), 256, [&](std::int64_t index) {
        const auto body = at(index);
        Vec3 force{}, torque{};
        for (std::int32_t s = model.spheres.begin[body]; s < model.spheres.begin[body + 1]; ++s) {
            // Force and turn side by side; the two lanes behind them read the next slot and mean nothing.
            Eight load{};
            for (std::uint32_t p = slots.begin[at(s)]; p < slots.begin[at(s) + 1]; ++p) {
                load += Eight::load(&slots.load[p].force.x);
            }
            for (std::uint32_t k = slots.incoming_begin[at(s)]; k < slots.incoming_begin[at(s) + 1]; ++k) {
                load += Eight::load(&slots.load[slots.incoming[k]].force.x) * sign_on_b;
            }
            alignas(64) double sums[lanes];
            load.store(sums);
            const Vec3 on_sphere{sums[0], sums[1], sums[2]}, turn{sums[3], sums[4], sums[5]};
            const Vec3 couple = has_couples ? couple_on(slots, scratch.couple, at(s)) : Vec3{};
            force += on_sphere;
            torque += model.spheres.radius[at(s)] * turn + couple;
            if (!(model.spheres.local[at(s)] == Vec3{})) {
                torque += cross(scratch.placed.center[at(s)] - state.position[body], on_sphere);
            }
        }
        scratch.loads.force[body] = force;
        scratch.loads.torque[body] = torque;
    });
}

}  // namespace riprap::solid::sphere_dem
