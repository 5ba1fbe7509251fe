// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/explicit_dda/contact_forces.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/affine/bonds.hpp"
#include "riprap/solid/explicit_dda/bond_loss.hpp"
#include "riprap/solid/explicit_dda/critical_step.hpp"
#include "riprap/solid/explicit_dda/pair_mobility.hpp"

namespace riprap::solid::explicit_dda {

using affine::BlockContact, affine::BlockSystem, affine::rows_at;

namespace {

/// S^-1 of every block; nought where loads do not move it. Once a block: it has many contact points.
void find_softness(const BlockSystem& system, const affine::BlockState& state, std::vector<Mat3>& softness) {
    softness.assign(at(system.size()), Mat3{});
    parallel::for_each_uneven(system.size(), 256, [&](std::int64_t i) {
        const auto b = at(i);
        if (system.is_fixed[b] == 0) {
            const Mat3 f = rows_at(state.deformation, b);
            softness[b] = inverse(f * system.inertia[b] * transpose(f));
        }
    });
}

/// One side of a contact point.
struct Side {
    Vec3 arm{}, velocity{};
    double mobility{0};  ///< of a point of a body that may take any affine motion; 0 where loads do not move the block

    Side(const BlockSystem& system, const affine::BlockState& state, const std::vector<Mat3>& softness,
         std::int32_t block, const Vec3& point) {
        const auto b = at(block);
        arm = point - state.position[b];
        velocity = state.velocity[b] + rows_at(state.velocity_gradient, b) * arm;
        if (system.is_fixed[b] == 0) {
            mobility = explicit_dda::mobility(system.mass[b], softness[b], arm);
        }
    }
};

/// Springs and dashpots of a contact point: stiffness of the point or per area, damping as a share of critical.
/// @param damped_mobility  inverse of the mass that the point bears of its pair [1/kg]
contact::PenaltySprings springs_of(const affine::Surface& surface, double area, double damped_mobility) {
    const double factor = surface.factor(area);
    contact::PenaltySprings springs;
    springs.normal_stiffness = factor * surface.normal_stiffness;
    springs.shear_stiffness = factor * surface.shear_stiffness;
    springs.friction = surface.friction;
    springs.cohesion = surface.cohesion * area;
    springs.tension = surface.tension * area;
    springs.normal_damping = 2 * surface.damping_ratio * std::sqrt(springs.normal_stiffness / damped_mobility);
    springs.shear_damping = 2 * surface.damping_ratio * std::sqrt(springs.shear_stiffness / damped_mobility);
    return springs;
}

ContactForce evaluate(const BlockSystem& system, const Settings& settings, const affine::BlockState& state,
                      const std::vector<Mat3>& softness, const affine::BlockContactHistory& history,
                      const BlockContact& contact, double damped_mobility, double time) {
    const Side a(system, state, softness, contact.a, contact.on_a), b(system, state, softness, contact.b, contact.on_b);
    auto springs = springs_of(system.surface_of(contact.a, contact.b), contact.area, damped_mobility);
    const double bond_length = affine::bond_length(system, contact.a, contact.b);
    springs.bond_slip = bond_length;
    contact::PenaltyMotion motion{contact.normal, contact.gap, a.velocity - b.velocity, time, {}, false};
    if (contact.old >= 0) {
        const auto row = at(contact.old);
        motion.slip = affine::turn_with_plane(history.slip[row], history.normal[row], contact.normal);
        motion.is_intact = history.is_intact[row] != 0;
        motion.plastic_slip = history.plastic_slip[row];
    } else {
        motion.is_intact = begins_bonded(history, contact.a, contact.b);
    }
    const bool was_intact = motion.is_intact;
    ContactForce result;
    result.answer = penalty(settings.joint_law, springs, motion);
    result.force = result.answer.force;
    result.velocity = motion.velocity;
    result.was_intact = was_intact;
    const Vec3 along = motion.velocity - dot(motion.velocity, contact.normal) * contact.normal;
    const double slid = motion.plastic_slip + time * norm(along);  // without springs all of the motion is slip
    result.is_apart = result.answer.is_open && was_intact && contact.old >= 0 && springs.tension == 0 &&
                      contact.gap <= bond_length && slid <= bond_length;
    if (result.is_apart) {
        result.answer.is_intact = true;
        result.answer.plastic_slip = slid;
    }
    if (!result.answer.is_open) {
        // Gershgorin: k (W_i + sqrt(W_i W_j)), W the mobility.
        const double stiffness = std::max(springs.normal_stiffness, springs.shear_stiffness);
        const double damping = std::max(springs.normal_damping, springs.shear_damping);
        const double mixed = std::sqrt(a.mobility * b.mobility);
        result.share_a = stiffness * (a.mobility + mixed);
        result.share_b = stiffness * (b.mobility + mixed);
        result.damping_a = damping * (a.mobility + mixed);
        result.damping_b = damping * (b.mobility + mixed);
    }
    return result;
}

/// Adds a contact to the loads of both blocks. The push acts on either surface, the rub halfway: with the offset along
/// the normal the push has the same moment on both, and angular momentum is exact.
void add_loads(const affine::BlockState& state, const BlockContact& contact, const ContactForce& found,
               std::vector<BlockForce>& loads) {
    const Vec3 push = dot(found.force, contact.normal) * contact.normal, rub = found.force - push;
    const Vec3 middle = 0.5 * (contact.on_a + contact.on_b);
    const auto add = [&](std::int32_t block, double sign, const Vec3& point) {
        const auto b = at(block);
        const Vec3& centre = state.position[b];
        loads[b].force += sign * found.force;
        loads[b].dipole = loads[b].dipole + outer(sign * push, point - centre) + outer(sign * rub, middle - centre);
    };
    add(contact.a, 1, contact.on_a);
    add(contact.b, -1, contact.on_b);
}

/// Adds a contact point to what bounds the step of its blocks.
void add_shares(const BlockContact& contact, const ContactForce& found, Scratch& scratch) {
    scratch.squared[at(contact.a)] += found.share_a;
    scratch.squared[at(contact.b)] += found.share_b;
    scratch.damping[at(contact.a)] += found.damping_a;
    scratch.damping[at(contact.b)] += found.damping_b;
}

/// Returns the work that the springs of a contact take in half a step at the velocity before the kick: they push on
/// until halfway to the kick that no longer finds them.
double work_of_half(const ContactForce& found, double dt) {
    return -0.5 * dt * dot(found.force - found.answer.dashpot, found.velocity);
}

}  // namespace

void evaluate_contacts(const BlockSystem& system, const Settings& settings, const affine::BlockState& state,
                       double time, Scratch& scratch) {
    const std::vector<BlockContact>& contacts = scratch.contacts();
    scratch.forces.resize(contacts.size());
    find_softness(system, state, scratch.softness);
    const std::vector<double> mobility = pair_mobility(system, state, contacts);
    parallel::for_each_uneven(static_cast<std::int64_t>(contacts.size()), 64, [&](std::int64_t i) {
        scratch.forces[at(i)] = evaluate(system, settings, state, scratch.softness, scratch.old, contacts[at(i)],
                                         mobility.empty() ? 1 : mobility[at(i)], time);
    });
}

void sum_and_remember(const BlockSystem& system, const affine::BlockState& state, double dt, Scratch& scratch,
                      affine::BlockContactHistory& history, StepReport& report) {
    scratch.loads.assign(state.position.size(), {});
    scratch.squared.assign(state.position.size(), 0);
    scratch.damping.assign(state.position.size(), 0);
    scratch.is_carried.assign(scratch.old.size(), 0);
    history.clear();
    affine::BondChanges bonds;
    const bool has_bonds = !scratch.old.bonded.empty();
    for (std::size_t i = 0; i < scratch.contacts().size(); ++i) {
        const BlockContact& contact = scratch.contacts()[i];
        const ContactForce& found = scratch.forces[i];
        const contact::PenaltyAnswer& answer = found.answer;
        add_loads(state, contact, found, scratch.loads);
        add_shares(contact, found, scratch);
        if (has_bonds) {
            bonds.look_at(contact, found.was_intact, !answer.is_open, answer.is_intact,
                          affine::bond_length(system, contact.a, contact.b));
        }
        if (contact.old >= 0 && (!answer.is_open || has_torn(contact, found))) {
            scratch.is_carried[at(contact.old)] = 1;
        }
        if (answer.is_open && !found.is_apart) {
            continue;
        }
        history.pair.push_back(contact::pair_key({contact.a, contact.b}));
        history.feature.push_back(contact.feature);
        history.plane.push_back(contact.plane);
        history.normal.push_back(contact.normal);
        history.slip.push_back(answer.slip);
        history.mode.push_back(static_cast<std::uint8_t>(answer.is_open      ? affine::ContactMode::open
                                                         : answer.is_sliding ? affine::ContactMode::slide
                                                                             : affine::ContactMode::lock));
        history.is_intact.push_back(answer.is_intact ? 1 : 0);
        history.plastic_slip.push_back(answer.is_intact ? answer.plastic_slip : 0);
        history.energy.push_back(answer.energy + work_of_half(found, dt));
        if (answer.is_open) {
            continue;
        }
        report.contact += answer.energy;
        report.friction_loss += has_sheared(found) ? 0 : answer.friction_loss;
        report.deepest = std::max(report.deepest, -contact.gap);
        report.sliding_count += answer.is_sliding ? 1 : 0;
        ++report.contact_count;
    }
    history.bonded = bonds_left(scratch.old.bonded, bonds);
}

double dashpot_work(const BlockSystem& system, const Scratch& scratch, const affine::BlockState& state, double dt) {
    double work = 0;
    for (std::size_t i = 0; i < scratch.contacts().size(); ++i) {
        const BlockContact& contact = scratch.contacts()[i];
        const ContactForce& found = scratch.forces[i];
        if (!found.answer.is_open) {
            const Side a(system, state, scratch.softness, contact.a, contact.on_a);
            const Side b(system, state, scratch.softness, contact.b, contact.on_b);
            work -= 0.5 * dt * dot(found.answer.dashpot, found.velocity + a.velocity - b.velocity);
        }
    }
    return work;
}

void book_lost_contacts(const Scratch& scratch, const affine::BlockContactHistory& history, double dt,
                        StepReport& report) {
    std::vector<std::uint64_t> pairs_that_lost;  // in order, as the history is
    for (std::size_t row = 0; row < scratch.old.size(); ++row) {
        if (scratch.is_carried[row] == 0 && !has_come_apart(scratch.old, row, history)) {
            report.lost_energy += scratch.old.energy[row];
            pairs_that_lost.push_back(scratch.old.pair[row]);
        }
    }
    // Where a pair names its points anew, the new ones begin pressed: their energy was that of the old ones.
    for (std::size_t i = 0; i < scratch.contacts().size() && !pairs_that_lost.empty(); ++i) {
        const BlockContact& contact = scratch.contacts()[i];
        const contact::PenaltyAnswer& answer = scratch.forces[i].answer;
        if (!answer.is_open && contact.old < 0 &&
            std::binary_search(pairs_that_lost.begin(), pairs_that_lost.end(),
                               contact::pair_key({contact.a, contact.b}))) {
            report.lost_energy -= answer.energy - work_of_half(scratch.forces[i], dt);
        }
    }
}

}  // namespace riprap::solid::explicit_dda
