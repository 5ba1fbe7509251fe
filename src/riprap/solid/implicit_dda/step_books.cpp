// SPDX-License-Identifier: Apache-2.0
// Energies, losses and works of one step, and the contacts that outlive it.
#include <algorithm>

#include "riprap/core/index.hpp"
#include "riprap/solid/affine/bonds.hpp"
#include "riprap/solid/affine/step_update.hpp"
#include "riprap/solid/implicit_dda/bond_loss.hpp"
#include "riprap/solid/implicit_dda/stages.hpp"

namespace riprap::solid::implicit_dda {

using affine::BlockSystem, affine::rows_at;

namespace {

void reserve(affine::BlockContactHistory& history, std::size_t count) {
    const auto grow = [count](auto&... arrays) { (arrays.reserve(count), ...); };
    grow(history.pair, history.feature, history.plane, history.normal, history.slip, history.mode, history.is_intact,
         history.plastic_slip, history.energy);
}

}  // namespace

void remember(Scratch& scratch, affine::BlockContactHistory& history, StepReport& report) {
    std::swap(scratch.old, history);
    history.clear();
    reserve(history, scratch.contacts.size());
    affine::BondChanges bonds;
    const bool has_bonds = !scratch.old.bonded.empty();
    for (std::size_t i = 0; i < scratch.contacts.size(); ++i) {
        const ContactTerm& c = scratch.contacts[i];
        const affine::BlockContact& found = scratch.found()[i];
        const ContactTrial& trial = c.trial;
        const bool was_kept =
            found.old >= 0 && scratch.old.mode[at(found.old)] != static_cast<std::uint8_t>(ContactMode::open);
        const bool was_closed = was_kept || found.gap < 0;
        const Vec3 slip = slip_kept(found, c);
        const double lost_bond = bond_loss(found, c);
        const double sheared = trial.mode == ContactMode::slide && lost_bond == 0
                                   ? trial.friction * dot(slip - trial.slip_before, trial.direction)
                                   : 0;
        if (trial.mode == ContactMode::slide) {
            report.friction_loss += trial.friction * dot(trial.step_slip, trial.direction) - sheared;
        }
        const double stored = trial.mode == ContactMode::open ? 0 : spring_energy(c.springs, trial.gap, slip);
        const double held = was_closed ? spring_energy(c.springs, found.gap, trial.slip_before) : 0;
        // Work done by the blocks against the springs, as the equations count it, less the energy stored.
        double work = trial.mode == ContactMode::open ? 0 : c.springs.normal * trial.gap * (trial.gap - found.gap);
        work += trial.mode == ContactMode::lock ? c.springs.shear * dot(trial.slip, trial.step_slip) : sheared;
        report.numerical_loss += work - (stored - held) - lost_bond;
        report.lost_energy -= held;
        report.contact += stored;
        const bool is_closed = trial.mode != ContactMode::open;
        const bool is_intact = stays_intact(found, c);
        if (has_bonds) {
            bonds.look_at(found, trial.is_intact, is_closed, is_intact, c.springs.bond_length);
        }
        if (!is_closed && !is_intact) {
            continue;
        }
        history.pair.push_back(contact::pair_key({found.a, found.b}));
        history.feature.push_back(found.feature);
        history.plane.push_back(found.plane);
        history.normal.push_back(found.normal);
        history.slip.push_back(is_closed ? slip : Vec3{});
        history.mode.push_back(static_cast<std::uint8_t>(trial.mode));
        history.is_intact.push_back(is_intact ? 1 : 0);
        history.plastic_slip.push_back(is_intact ? plastic_slip(c) : 0);
        history.energy.push_back(stored);
        if (!is_closed) {
            continue;
        }
        report.deepest = std::max(report.deepest, -trial.gap);
        report.sliding_count += trial.mode == ContactMode::slide ? 1 : 0;
        ++report.contact_count;
    }
    for (const double energy : scratch.old.energy) {
        report.lost_energy += energy;
    }
    history.bonded = bonds_left(scratch.old.bonded, bonds);
}

void book_blocks(const BlockSystem& system, const affine::BlockLoads& external, const affine::BlockState& state,
                 Scratch& scratch, StepReport& report) {
    for (std::size_t row = 0; row < scratch.block.size(); ++row) {
        const std::int32_t block = scratch.block[row];
        const auto b = at(block);
        const double* d = &scratch.equations.solution[row * 12];
        const Mat3 strain = affine::symmetric_part(gradient_of(d));
        const affine::Elasticity& material = system.elasticity;
        const double volume = system.shape_of(block).volume * determinant(rows_at(state.deformation, b));
        const Mat3 before = affine::elastic_strain(material, rows_at(state.stress, b));
        report.strain += volume * elastic_energy(material, before + strain);
        report.numerical_loss += volume * elastic_energy(material, strain);
        const Vec3 force = external.force.empty() ? Vec3{} : external.force[b];
        const Vector12 load = load_vector(force, dipole(external, b));
        for (std::size_t i = 0; i < 12; ++i) {
            report.external_work += load[i] * d[i];
        }
    }
    scratch.point_forces.assign(system.fixed_points.size(), std::pair<Vec3, Vec3>{});
    for (std::size_t i = 0; i < system.fixed_points.size(); ++i) {
        const body::FixedPoint& point = system.fixed_points[i];
        const auto block = at(point.body.value);
        const std::int32_t row = scratch.row[block];
        if (row >= 0) {
            const Vec3 arm = rows_at(state.deformation, block) * point.point;
            const Vec3 moved = displacement(displacement_matrix(arm), &scratch.equations.solution[at(row) * 12]);
            const Vec3 off = state.position[block] + arm - point.place;
            scratch.point_forces[i] = {arm, -point.stiffness * (off + moved)};
            report.contact += 0.5 * point.stiffness * norm_squared(off + moved);
            report.numerical_loss += 0.5 * point.stiffness * norm_squared(moved);
        }
    }
}

}  // namespace riprap::solid::implicit_dda
