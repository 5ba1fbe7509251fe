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

/// Side A or B of eight contacts.
struct Side {
    Vec3x8 x, v, w;
    Eight radius, inverse_mass;
};

[[gnu::always_inline]] inline Side load_side(const Placed& placed, const RowIndex& rows) {
    const double* at_row[lanes];
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        at_row[lane] = &placed.records[at(rows.row[lane])].x;
    }
    const auto four_from = [&](std::int64_t first) {
        const double* places[lanes];
        for (std::int64_t lane = 0; lane < lanes; ++lane) {
            places[lane] = at_row[lane] + first;
        }
        return load_four(places);
    };
    const FourByEight x = four_from(0), v = four_from(4), w = four_from(8);
    return {{x.a, x.b, x.c}, {v.a, v.b, v.c}, {w.a, w.b, w.c}, x.d, v.d};
}

RowIndex materials_of(const Placed& placed, const RowIndex& rows) {
    RowIndex out;
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        out.row[lane] = static_cast<std::int32_t>(placed.records[at(rows.row[lane])].material);
    }
    return out;
}

/// Motion of eight contacts along the lines of their centres. The normal of the last step is that of r - v dt, which is
/// where the centres were: velocities are constant between two evaluations.
/// @param arm  from A to B over the sum of radii: times its own radius, the arm of each sphere [-]
[[gnu::always_inline]] inline ContactMotion<Eight> motion_of(const Side& a, const Side& b, Eight dt, Vec3x8& arm) {
    ContactMotion<Eight> m;
    const Vec3x8 r = b.x - a.x, approach = a.v - b.v;
    const Vec3x8 r_old = r + approach * dt;
    // Roots and reciprocals of the squares side by side: 1/r = r/r^2.
    const Eight square = dot(r, r), square_old = dot(r_old, r_old), one(1.0);
    const Eight distance = sqrt(square), reach = a.radius + b.radius, inverse_reach = one / reach;
    m.normal = r * (distance * (one / square));
    m.old_normal = r_old * (sqrt(square_old) * (one / square_old));
    arm = r * inverse_reach;
    m.velocity = approach + cross(a.w * a.radius + b.w * b.radius, arm);
    m.spin = a.w - b.w;
    m.mean_turn = Eight(0.5) * dt * dot(a.w + b.w, m.normal);
    m.overlap = max(reach - distance, Eight(0.0));
    m.radius = a.radius * b.radius * inverse_reach;
    m.inverse_mass = a.inverse_mass + b.inverse_mass;
    m.mass = one / m.inverse_mass;
    m.weight = m.damping_weight = m.count = Eight(1.0);
    m.dt = dt;
    return m;
}

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

/// Up to eight contacts side by side.
struct Group {
    RowIndex a, b, row;
    std::int64_t first, count;
    ContactMotion<Eight> motion;
    Vec3x8 arm;  ///< see motion_of
    Eight radius_a, radius_b;
    ContactResponse<Eight> response;
};

[[gnu::always_inline]] inline void number(const Springs& springs, std::int64_t first, std::int64_t end, Group& g) {
    g.first = first;
    g.count = std::min(lanes, end - first);
    for (std::int64_t lane = 0; lane < lanes; ++lane) {
        const std::int64_t c = first + std::min(lane, g.count - 1);
        const std::uint64_t key = springs.pair[at(c)];
        g.a.row[lane] = static_cast<std::int32_t>(key >> 32);
        g.b.row[lane] = static_cast<std::int32_t>(key & 0xFFFFFFFF);
        g.row.row[lane] = static_cast<std::int32_t>(c);
    }
}

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
    const Surfaces& surfaces;
    bool has_faces, has_rolling;

    /// Motion of the contacts.
    [[gnu::always_inline]] void measure(Group& g) const {
        const Side a = load_side(scratch.placed, g.a), b = load_side(scratch.placed, g.b);
        ContactMotion<Eight>& motion = g.motion;
        motion = motion_of(a, b, Eight(dt), g.arm);
        g.radius_a = a.radius;
        g.radius_b = b.radius;
        if (is_plain) {
            return;
        }
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
    }

    /// Forces by the laws; springs are advanced.
    [[gnu::always_inline]] void answer(Group& g) const {
        Springs& springs = state.contacts;
        contact::TangentialSpring<Eight> spring;
        if (g.count == lanes) {
            spring = {load_vectors(&springs.force[at(g.first)]), Eight::load(&springs.stiffness[at(g.first)])};
        } else {
            spring = {gather(springs.force.data(), g.row), gather<1>(springs.stiffness.data(), g.row)};
        }
        Vec3x8 rolling{};
        const bool has_springs = !is_plain && !springs.rolling.empty();
        if (has_springs) {
            rolling = gather(springs.rolling.data(), g.row);
        }
        const bool is_uniform = is_plain || surfaces.is_uniform();
        g.response = respond_to<Eight>(
            Laws{model.settings}, friction,
            is_uniform ? surfaces.first()
                       : surfaces.of(materials_of(scratch.placed, g.a), materials_of(scratch.placed, g.b)),
            g.motion, spring, rolling);
        if (g.count == lanes) {
            store_vectors(spring.force, &springs.force[at(g.first)]);
            spring.stiffness.store(&springs.stiffness[at(g.first)]);
        } else {
            for (std::int64_t lane = 0; lane < g.count; ++lane) {
                springs.force[at(g.first + lane)] = lane_of(spring.force, lane);
                springs.stiffness[at(g.first + lane)] = spring.stiffness[lane];
            }
        }
        for (std::int64_t lane = 0; has_springs && lane < g.count; ++lane) {
            springs.rolling[at(g.first + lane)] = lane_of(rolling, lane);
        }
    }

    /// Loads on both sides.
    [[gnu::always_inline]] void add_loads(const Group& g) const {
        double *at_a[lanes], *at_b[lanes];
        for (std::int64_t lane = 0; lane < lanes; ++lane) {
            const ContactEnds ends = scratch.ends[at(g.first + std::min(lane, g.count - 1))];
            at_a[lane] = &scratch.load_rows.rows[ends.a].force.x;
            at_b[lane] = &scratch.load_rows.rows[ends.b].force.x;
        }
        const Vec3x8 turn = cross(g.arm, g.response.force);
        Vec3x8 torque_a = turn * g.radius_a, torque_b = turn * g.radius_b;
        if (!is_plain && has_rolling) {
            torque_a += g.response.couple;
            torque_b -= g.response.couple;
        }
        add_six(g.response.force, torque_a, at_a, g.count);
        add_six(-g.response.force, torque_b, at_b, g.count);
    }

    /// Keeps the forces for output.
    void keep_forces(const Group& g) const {
        for (std::int64_t lane = 0; lane < g.count; ++lane) {
            scratch.forces[at(g.first + lane)] = lane_of(g.response.force, lane);
        }
    }

    /// Contacts [begin, end).
    ContactSums range(std::int64_t begin, std::int64_t end) const {
        WideSums sums;
        for (std::int64_t c = begin; c < end; c += lanes) {
            Group g;
            number(state.contacts, c, end, g);
            measure(g);
            answer(g);
            add_loads(g);
            if (scratch.keeps_forces) {
                keep_forces(g);
            }
            sums.add(g.response, g.motion.overlap / min(g.radius_a, g.radius_b), g.count);
        }
        return sums.fold();
    }
};

template <class Law, bool is_plain>
ContactSums respond_by(const Law& friction, const SphereModel& model, const body::BodyState& bodies, double dt,
                       SphereState& state, SphereScratch& scratch) {
    const bool has_faces = model.settings.normals == contact::SphereNormals::faces;
    const Surfaces surfaces(model.table, model.settings.normal);
    const Respond<Law, is_plain> work{friction, model,     bodies,
                                      dt,       state,     scratch,
                                      surfaces, has_faces, model.settings.rolling != contact::RollingLaw::none};
    LoadRows& rows = scratch.load_rows;
    std::vector<ContactSums> partial(at(rows.block_count()));
    const auto first_of = [&](std::int64_t block) {
        const auto key = static_cast<std::uint64_t>(block * LoadRows::block_spheres) << 32;
        return std::ranges::lower_bound(state.contacts.pair, key) - state.contacts.pair.begin();
    };
    parallel::for_each_uneven(rows.block_count(), 1, [&](std::int64_t block) {
        std::fill(rows.rows.begin() + rows.first_row[at(block)], rows.rows.begin() + rows.first_row[at(block + 1)],
                  LoadRow{});
        partial[at(block)] = work.range(first_of(block), first_of(block + 1));
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
    const SphereSettings& settings = model.settings;
    scratch.forces.resize(scratch.keeps_forces ? state.contacts.size() : 0);
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
