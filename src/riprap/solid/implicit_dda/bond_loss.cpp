// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/implicit_dda/bond_loss.hpp"

#include <algorithm>

namespace riprap::solid::implicit_dda {

double spring_energy(const ContactSprings& springs, double gap, const Vec3& slip) {
    return 0.5 * (springs.normal * gap * gap + springs.shear * norm_squared(slip));
}

double plastic_slip(const ContactTerm& contact) {
    const ContactTrial& trial = contact.trial;
    if (trial.mode == ContactMode::open) {
        return trial.plastic_slip + norm(trial.step_slip);  // without springs all of the motion is slip
    }
    const bool yields = trial.mode == ContactMode::slide && contact.springs.shear > 0;
    const double slip = yields ? norm(trial.slip) - trial.friction / contact.springs.shear : 0;
    return trial.plastic_slip + std::max(0.0, slip);
}

bool stays_intact(const affine::BlockContact& found, const ContactTerm& contact) {
    const ContactTrial& trial = contact.trial;
    const double length = contact.springs.bond_length;
    if (!trial.is_intact || trial.mode == ContactMode::lock) {
        return trial.is_intact;
    }
    if (trial.mode == ContactMode::slide) {
        return plastic_slip(contact) <= length;
    }
    return found.old >= 0 && contact.springs.tension == 0 && trial.gap <= length && plastic_slip(contact) <= length;
}

Vec3 slip_kept(const affine::BlockContact& found, const ContactTerm& contact) {
    const ContactTrial& trial = contact.trial;
    const ContactSprings& springs = contact.springs;
    if (trial.mode != ContactMode::slide) {
        return trial.slip;
    }
    // A sliding contact keeps the slip that its friction amounts to, so that it locks without a jump; a bond that
    // breaks keeps friction alone.
    const bool breaks = trial.is_intact && !stays_intact(found, contact);
    const double friction = breaks ? trial.residual : trial.friction;
    return springs.shear > 0 ? (friction / springs.shear) * trial.direction : Vec3{};
}

double bond_loss(const affine::BlockContact& found, const ContactTerm& contact) {
    const ContactTrial& trial = contact.trial;
    if (!trial.is_intact || stays_intact(found, contact) || found.old < 0) {
        return 0;
    }
    if (trial.mode == ContactMode::open) {
        return spring_energy(contact.springs, found.gap, trial.slip_before);
    }
    const double given_up = norm_squared(trial.slip_before) - norm_squared(slip_kept(found, contact));
    return std::max(0.0, 0.5 * contact.springs.shear * given_up);
}

double bond_loss(const Scratch& scratch) {
    double sum = 0;
    for (std::size_t i = 0; i < scratch.contacts.size(); ++i) {
        sum += bond_loss(scratch.found()[i], scratch.contacts[i]);
    }
    return sum;
}

}  // namespace riprap::solid::implicit_dda
