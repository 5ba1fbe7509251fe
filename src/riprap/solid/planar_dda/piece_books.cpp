// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/piece_books.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/solid/planar_dda/assemble.hpp"
#include "riprap/solid/planar_dda/plane.hpp"
#include "riprap/solid/planar_dda/submatrices.hpp"

namespace riprap::solid {

std::span<const Account> PlanarDda::accounts() {
    static constexpr std::array table{
        Account{"strain", Balance::stored, Booking::at_kick, "stored in strained blocks"},
        Account{"bonds", Balance::lost, Booking::since_kick, "lost by bonds that broke, since time 0"},
        Account{"numerical_damping", Balance::lost, Booking::since_kick,
                "lost by the integration of motion and strain since time 0", true},
        Account{"static_damping", Balance::lost, Booking::since_kick, "lost to dynamic_factor since time 0"},
        Account{"linearization", Balance::lost, Booking::since_kick,
                "lost where exact turns replace the linear displacements of steps, since time 0", true},
        Account{"multipliers", Balance::lost, Booking::since_kick, "lost to the multipliers of contacts since time 0",
                true}};
    return table;
}

}  // namespace riprap::solid

namespace riprap::solid::planar_dda {

namespace {

void add_load(std::int32_t block, double size, const Unknowns& direction, body::Loads& loads) {
    loads.force[at(block)] += size * Vec3{direction[0], direction[1], 0};
    loads.torque[at(block)] += size * Vec3{0, 0, direction[2]};
}

/// One block as the sums of a kick see it.
struct BlockMotion {
    Vec3 place, velocity;
    double mass, kinetic, spin;  ///< spin: angular momentum about the centroid
};
BlockMotion motion_of(const Model& model, const State& state, std::int32_t b) {
    const Unknowns rates = rates_of(state, b);
    const Unknowns momentum = multiply(mass_block(model.mass[at(b)], spread_of(model, state, b)), rates);
    return {{state.x[at(b)], state.y[at(b)], 0},
            {rates[0], rates[1], 0},
            model.mass[at(b)],
            0.5 * dot(rates, momentum),
            momentum[2]};
}

}  // namespace

double shear_of(const Contact& contact, const Trial& trial) {
    return trial.mode == Mode::locked ? -contact.joint.shear_stiffness * trial.slip : -trial.friction;
}

void sum_contacts(const Scratch& engine, body::Loads& loads) {
    const auto add = [&loads](std::int32_t block, double size, const Unknowns& direction) {
        add_load(block, size, direction, loads);
    };
    for (std::size_t k = 0; k < engine.contacts.size(); ++k) {
        const Contact& contact = engine.contacts[k];
        const Trial& trial = engine.trials[k];
        if (trial.mode == Mode::open) {
            continue;
        }
        const double shear = shear_of(contact, trial);
        add(contact.a, trial.normal, contact.gap.a);
        add(contact.b, trial.normal, contact.gap.b);
        add(contact.a, shear, contact.slip.a);
        add(contact.b, shear, contact.slip.b);
    }
}

void sum_supports(const Model& model, const State& start, const Scratch& engine, double dt, body::Loads& loads,
                  KickReport& impulses) {
    for (const body::FixedPoint& p : model.fixed_points) {
        const std::int32_t block = p.body.value;
        if (model.is_fixed[at(block)] != 0) {
            continue;
        }
        const Vec2 r = offset_of(start, block, flat(p.point)), center{start.x[at(block)], start.y[at(block)]};
        const Vec2 off = flat(p.place) - (center + r) - displacement_at(r, engine.motion[at(block)]);
        const Unknowns force = force_at(r, off);
        add_load(block, p.stiffness, force, loads);
        impulses.impulse += dt * p.stiffness * Vec3{force[0], force[1], 0};
        impulses.angular_impulse += dt * p.stiffness * Vec3{0, 0, force[2] + cross(center, off)};
    }
    for (const body::Bolt& bolt : model.bolts) {
        const Linear length = bolt_length(start, bolt);
        const double stretched =
            length.after(engine.motion[at(bolt.first.value)], engine.motion[at(bolt.second.value)]) - bolt.rest_length;
        add_load(bolt.first.value, -bolt.stiffness * stretched, length.a, loads);
        add_load(bolt.second.value, -bolt.stiffness * stretched, length.b, loads);
    }
}

void book_released(const Model& model, const PlanarDda::Fields& fields, const Vec3& gravity, KickReport& kick) {
    for (std::int32_t b = 0; b < model.block_count(); ++b) {
        if (fields.was_held[at(b)] == 0 || model.is_fixed[at(b)] != 0) {
            continue;
        }
        const BlockMotion m = motion_of(model, fields.blocks, b);
        kick.released_energy += m.kinetic - m.mass * dot(gravity, m.place);
        kick.released_momentum += m.mass * m.velocity;
        kick.released_angular_momentum += m.mass * cross(m.place, m.velocity) + Vec3{0, 0, m.spin};
        kick.released_mass_moment += m.mass * m.place;
    }
}

void book_blocks(const Model& model, const State& state, const Vec3& gravity, const std::vector<Unknowns>& given,
                 const body::Loads& contacts, double dt, KickReport& kick) {
    for (std::int32_t b = 0; b < model.block_count(); ++b) {
        const BlockMotion m = motion_of(model, state, b);
        if (model.is_fixed[at(b)] != 0) {
            kick.impulse -= dt * contacts.force[at(b)];
            kick.angular_impulse -= dt * (cross(m.place, contacts.force[at(b)]) + contacts.torque[at(b)]);
            continue;
        }
        const Unknowns load = given.empty() ? Unknowns{} : given[at(b)];
        const Vec3 outside = m.mass * gravity + Vec3{load[0], load[1], 0};
        kick.mass += m.mass;
        kick.kinetic += m.kinetic;
        kick.potential -= m.mass * dot(gravity, m.place);
        kick.momentum += m.mass * m.velocity;
        kick.angular_momentum += m.mass * cross(m.place, m.velocity) + Vec3{0, 0, m.spin};
        kick.impulse += dt * outside;
        kick.angular_impulse += dt * (cross(m.place, outside) + Vec3{0, 0, load[2]});
        kick.mass_moment += m.mass * m.place;
        kick.max_speed = std::max(kick.max_speed, m.mass > 0 ? std::sqrt(2 * m.kinetic / m.mass) : 0);
    }
}

void book_accounts(const Accounts& before, const Accounts& after, const Energies& energies, SolidReport& report) {
    report.elastic = energies.contact + energies.fixed_points + energies.bolts;
    report.kick.external_work = after.work_loads - before.work_loads;
    report.kick.work_driven = after.work_driven - before.work_driven;
    report.friction_loss = after.friction_loss - before.friction_loss;
    report.damping_loss = after.dashpot_loss - before.dashpot_loss;
    report.own = {energies.strain,
                  after.bond_loss - before.bond_loss,
                  after.newmark_loss - before.newmark_loss,
                  after.static_loss - before.static_loss,
                  before.linearization - after.linearization,
                  before.constraint_work - after.constraint_work};
}

}  // namespace riprap::solid::planar_dda
