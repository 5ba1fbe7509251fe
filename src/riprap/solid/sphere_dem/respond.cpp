// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/sphere_dem/respond.hpp"

#include <algorithm>
#include <type_traits>

#include "riprap/contact/law/closest_pair.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/sphere_dem/eight_contacts.hpp"

namespace riprap::solid::sphere_dem {

namespace {

/// Contacts side by side: a vector of the machine.
constexpr std::int64_t side_by_side = lanes_in<Native>;
using Rows = RowsOf<Native>;
using Vectors = Vec3T<Native>;

/// Side A or B of contacts.
struct Side {
    Vectors x, v, w;
    Native radius, inverse_mass;
};

[[gnu::always_inline]] inline Side load_side(const Placed& placed, const Rows& rows) {
    const double* place[side_by_side];
    for_lanes<Native>([&](std::int64_t lane) { place[lane] = &placed.records[at(rows.row[lane])].x; });
    const auto four_from = [&](std::int64_t first) {
        const double* from[side_by_side];
        for_lanes<Native>([&](std::int64_t lane) { from[lane] = place[lane] + first; });
        return load_four<Native>(from);
    };
    const FourOf<Native> x = four_from(0), v = four_from(4), w = four_from(8);
    return {{x.a, x.b, x.c}, {v.a, v.b, v.c}, {w.a, w.b, w.c}, x.d, v.d};
}

Rows materials_of(const Placed& placed, const Rows& rows) {
    Rows out;
    for (std::int64_t lane = 0; lane < side_by_side; ++lane) {
        out.row[lane] = static_cast<std::int32_t>(placed.records[at(rows.row[lane])].material);
    }
    return out;
}

/// Motion of contacts along the lines of their centres. The normal of the last step is that of r - v dt, which is
/// where the centres were: velocities are constant between two evaluations.
/// @param arm  from A to B over the sum of radii: times its own radius, the arm of each sphere [-]
[[gnu::always_inline]] inline ContactMotion<Native> motion_of(const Side& a, const Side& b, Native dt, Vectors& arm) {
    ContactMotion<Native> m;
    const Vectors r = b.x - a.x, approach = a.v - b.v;
    const Vectors r_old = r + approach * dt;
    // Roots and reciprocals of the squares side by side: 1/r = r/r^2.
    const Native square = dot(r, r), square_old = dot(r_old, r_old), one(1.0);
    const Native distance = sqrt(square), reach = a.radius + b.radius, inverse_reach = one / reach;
    m.normal = r * (distance * (one / square));
    m.old_normal = r_old * (sqrt(square_old) * (one / square_old));
    arm = r * inverse_reach;
    m.velocity = approach + cross(a.w * a.radius + b.w * b.radius, arm);
    m.spin = a.w - b.w;
    m.mean_turn = Native(0.5) * dt * dot(a.w + b.w, m.normal);
    m.overlap = max(reach - distance, Native(0.0));
    m.radius = a.radius * b.radius * inverse_reach;
    m.inverse_mass = a.inverse_mass + b.inverse_mass;
    m.mass = one / m.inverse_mass;
    m.weight = m.damping_weight = m.count = Native(1.0);
    m.dt = dt;
    return m;
}

/// Puts contact normals of faces in place of those along the centres, see contact::closest_pair_normal.
void use_face_normals(const SphereModel& model, const body::BodyState& state, const Rows& a, const Rows& b,
                      const Side& of_a, const Side& of_b, ContactMotion<Native>& m) {
    const auto world = [&](std::int32_t sphere) {
        const Vec3& n = model.spheres.face_normal[at(sphere)];
        return n == Vec3{} ? n : rotate(state.orientation[at(model.spheres.body[at(sphere)])], n);
    };
    for (std::int64_t lane = 0; lane < side_by_side; ++lane) {
        const Vec3 n = contact::closest_pair_normal(world(a.row[lane]), world(b.row[lane]), lane_of(m.normal, lane));
        const Vec3 r = lane_of(of_b.x, lane) - lane_of(of_a.x, lane);
        for (int axis = 0; axis < 3; ++axis) {
            (axis == 0 ? m.normal.x : axis == 1 ? m.normal.y : m.normal.z).set(lane, n[axis]);
        }
        m.overlap.set(lane, std::max(0.0, contact::overlap_along(n, r, of_a.radius[lane], of_b.radius[lane])));
    }
    m.old_normal = m.normal;
}

/// Contacts [first, first + count) side by side.
struct Group {
    std::int64_t first, count;
    Rows a, b;

    Group(const Springs& springs, std::int64_t first_contact, std::int64_t contact_count)
        : first(first_contact), count(contact_count) {
        for_lanes<Native>([&](std::int64_t lane) {
            const std::uint64_t key = springs.pair[contact(lane)];
            a.row[lane] = static_cast<std::int32_t>(key >> 32);
            b.row[lane] = static_cast<std::int32_t>(key & 0xFFFFFFFF);
        });
    }
    bool is_full() const { return count == side_by_side; }
    /// Row of one lane: lanes without a contact repeat the last one.
    std::size_t contact(std::int64_t lane) const { return at(first + std::min(lane, count - 1)); }
    Rows contacts() const {
        Rows rows;
        for_lanes<Native>([&](std::int64_t lane) { rows.row[lane] = static_cast<std::int32_t>(contact(lane)); });
        return rows;
    }
};

/// Everything that stays the same over a range of contacts.
/// @tparam is_plain  the default laws, one material, every contact counts in full along the centres
template <class Law, bool is_plain>
struct Respond {
    using Laws = std::conditional_t<is_plain, DefaultLaws, ChosenLaws>;
    const Law& friction;
    const SphereModel& model;
    const body::BodyState& bodies;
    double dt;
    SphereState& state;
    SphereScratch& scratch;
    const Surfaces<Native>& surfaces;
    bool has_faces, has_rolling;

    /// Holds what the settings change in the motion of contacts.
    void adjust(const Group& g, const Side& a, const Side& b, ContactMotion<Native>& motion) const {
        if (has_faces) {
            use_face_normals(model, bodies, g.a, g.b, a, b, motion);
        }
        if (!scratch.weight.empty()) {
            motion.damping_weight = gather<1>(scratch.weight.data(), g.contacts());
            if (model.settings.sharing == contact::Sharing::dashpots) {
                motion.count = Native(1.0) / (motion.damping_weight * motion.damping_weight);
            } else {
                motion.weight = motion.damping_weight;
                motion.count =
                    model.settings.sharing == contact::Sharing::divide ? Native(1.0) / motion.weight : motion.count;
            }
        }
    }

    contact::TangentialSpring<Native> spring_of(const Group& g) const {
        const Springs& springs = state.contacts;
        if (g.is_full()) {
            return {load_vectors<Native>(&springs.force[at(g.first)]), Native::load(&springs.stiffness[at(g.first)])};
        }
        return {gather(springs.force.data(), g.contacts()), gather<1>(springs.stiffness.data(), g.contacts())};
    }

    void keep(const Group& g, const contact::TangentialSpring<Native>& spring) const {
        Springs& springs = state.contacts;
        if (g.is_full()) {
            store_vectors(spring.force, &springs.force[at(g.first)]);
            spring.stiffness.store(&springs.stiffness[at(g.first)]);
            return;
        }
        for (std::int64_t lane = 0; lane < g.count; ++lane) {
            springs.force[at(g.first + lane)] = lane_of(spring.force, lane);
            springs.stiffness[at(g.first + lane)] = spring.stiffness[lane];
        }
    }

    /// Forces by the laws; springs are advanced.
    [[gnu::always_inline]] ContactResponse<Native> answer(const Group& g, const ContactMotion<Native>& motion) const {
        contact::TangentialSpring<Native> spring = spring_of(g);
        std::vector<Vec3>& couples = state.contacts.rolling;
        const bool has_springs = !is_plain && !couples.empty();
        Vectors rolling{};
        if (has_springs) {
            rolling = gather(couples.data(), g.contacts());
        }
        const auto by_laws = [&](const SurfacePair<Native>& pair) {
            return respond_to<Native>(Laws{model.settings}, friction, pair, motion, spring, rolling);
        };
        const ContactResponse<Native> response =
            is_plain || surfaces.is_uniform()
                ? by_laws(surfaces.first())
                : by_laws(surfaces.of(materials_of(scratch.placed, g.a), materials_of(scratch.placed, g.b)));
        keep(g, spring);
        for (std::int64_t lane = 0; has_springs && lane < g.count; ++lane) {
            couples[at(g.first + lane)] = lane_of(rolling, lane);
        }
        return response;
    }

    /// Adds the loads of the contacts to the rows of both sides.
    [[gnu::always_inline]] void add_loads(const Group& g, const ContactResponse<Native>& response, const Vectors& arm,
                                          Native radius_a, Native radius_b) const {
        const Vectors turn = cross(arm, response.force);
        Vectors torque_a = turn * radius_a, torque_b = turn * radius_b;
        if (!is_plain && has_rolling) {
            torque_a += response.couple;
            torque_b -= response.couple;
        }
        const transposed::SixRows on_a = six_rows(response.force, torque_a), on_b = six_rows(-response.force, torque_b);
        for_lanes<Native>([&](std::int64_t lane) {
            if (lane < g.count) {
                const ContactEnds ends = scratch.ends[at(g.first + lane)];
                on_a.add(lane, &scratch.load_rows.rows[ends.a].force.x);
                on_b.add(lane, &scratch.load_rows.rows[ends.b].force.x);
            }
        });
    }

    /// Keeps the forces for output.
    void keep_forces(const Group& g, const Vectors& force) const {
        for (std::int64_t lane = 0; lane < g.count; ++lane) {
            scratch.forces[at(g.first + lane)] = lane_of(force, lane);
        }
    }

    /// Keeps what dashpots do, for their work once the bodies have been kicked.
    [[gnu::always_inline]] void keep_dashpots(const Group& g, const Vectors& force) const {
        if (g.is_full()) {
            store_vectors(force, &scratch.dashpots[at(g.first)]);
            return;
        }
        for (std::int64_t lane = 0; lane < g.count; ++lane) {
            scratch.dashpots[at(g.first + lane)] = lane_of(force, lane);
        }
    }

    /// Contacts [first, first + count), part `p` of a group of eight.
    [[gnu::always_inline]] void part(std::int64_t first, std::int64_t count, std::int64_t p, WideSums& sums) const {
        const Group g(state.contacts, first, count);
        const Side a = load_side(scratch.placed, g.a), b = load_side(scratch.placed, g.b);
        Vectors arm;
        ContactMotion<Native> motion = motion_of(a, b, Native(dt), arm);
        if (!is_plain) {
            adjust(g, a, b, motion);
        }
        const ContactResponse<Native> response = answer(g, motion);
        add_loads(g, response, arm, a.radius, b.radius);
        keep_dashpots(g, response.dashpot);
        if (scratch.keeps_forces) {
            keep_forces(g, response.force);
        }
        sums.add(response, motion.overlap / min(a.radius, b.radius), at(p), count);
    }
    [[gnu::flatten]] void full_part(std::int64_t first, std::int64_t p, WideSums& sums) const {
        part(first, side_by_side, p, sums);
    }
    [[gnu::noinline]] void last_part(std::int64_t first, std::int64_t count, std::int64_t p, WideSums& sums) const {
        part(first, count, p, sums);
    }

    /// Contacts [begin, end).
    ContactSums range(std::int64_t begin, std::int64_t end) const {
        WideSums sums;
        std::int64_t c = begin, p = 0;
        for (; c + side_by_side <= end; c += side_by_side) {
            full_part(c, p, sums);
            p = p + 1 < parts ? p + 1 : 0;
        }
        if (c < end) {
            last_part(c, end - c, p, sums);
        }
        return sums.fold();
    }
};

template <class Law, bool is_plain>
ContactSums respond_by(const Law& friction, const SphereModel& model, const body::BodyState& bodies, double dt,
                       SphereState& state, SphereScratch& scratch) {
    const bool has_faces = model.settings.normals == contact::SphereNormals::faces;
    const Surfaces<Native> surfaces(model.table, model.settings.normal);
    const Respond<Law, is_plain> work{friction, model,     bodies,
                                      dt,       state,     scratch,
                                      surfaces, has_faces, model.settings.rolling != contact::RollingLaw::none};
    LoadRows& rows = scratch.load_rows;
    std::vector<ContactSums> partial(at(rows.block_count()));
    const auto first_of = [&](std::int64_t block) {
        const auto key = static_cast<std::uint64_t>(rows.first_sphere[at(block)]) << 32;
        return std::ranges::lower_bound(state.contacts.pair, key) - state.contacts.pair.begin();
    };
    parallel::for_each_uneven(rows.block_count(), 1, [&](std::int64_t block) {
        std::fill(rows.rows.begin() + rows.first_row[at(block)], rows.rows.begin() + rows.first_row[at(block + 1)],
                  LoadRow{});
        partial[at(block)] = work.range(first_of(block), first_of(block + 1));
    });
    return parallel::total_of(partial);
}

}  // namespace

ContactSums respond(const SphereModel& model, const body::BodyState& bodies, double dt, SphereState& state,
                    SphereScratch& scratch) {
    const SphereSettings& settings = model.settings;
    scratch.forces.resize(scratch.keeps_forces ? state.contacts.size() : 0);
    scratch.dashpots.resize(state.contacts.size());
    const bool is_plain =
        settings.normal == contact::NormalLaw::hertz && settings.rolling == contact::RollingLaw::none &&
        settings.normals == contact::SphereNormals::centres && scratch.weight.empty() && model.table.size() == 1;
    return settings.tangential.visit([&](const auto& friction) {
        using Law = std::decay_t<decltype(friction)>;
        return is_plain ? respond_by<Law, true>(friction, model, bodies, dt, state, scratch)
                        : respond_by<Law, false>(friction, model, bodies, dt, state, scratch);
    });
}

}  // namespace riprap::solid::sphere_dem
