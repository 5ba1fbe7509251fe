// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/open_close.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/core/index.hpp"

namespace riprap::solid::planar_dda {

namespace {

double cohesion_force(const Contact& contact, const Trial& trial) {
    return trial.is_bonded ? contact.joint.cohesion * contact.bond_length : 0;
}

/// Largest shear force [N].
double shear_limit(const Settings& settings, const Contact& contact, const Trial& trial) {
    return shear_strength(settings.joint_law, {trial.normal, contact.joint.friction, cohesion_force(contact, trial)});
}

/// Force that the contact would have if it were closed [N].
double normal_if_closed(const Contact& contact, const Trial& trial, double dt) {
    return trial.multiplier - contact.joint.normal_stiffness * trial.gap -
           contact.dashpot / dt * (trial.gap - trial.gap_before);
}

bool is_foot_on_edge(const Contact& contact, const Trial& trial) {
    if (contact.is_round) {
        return true;
    }
    constexpr double slack = 1e-3;
    const double foot = contact.foot + (trial.slip - trial.slip_start) / contact.edge_length;
    return foot >= -slack && foot <= 1 + slack;
}

/// Lets the slip of a new contact count from where it touched.
void lock_at_touch(Contact& contact, Trial& trial) {
    const double change = trial.gap - contact.gap.value;
    const double share = change < 0 ? std::clamp(-contact.gap.value / change, 0.0, 1.0) : 0.0;
    const double slipped = trial.slip - trial.slip_start;
    trial.slip_start = -share * slipped;
    trial.slip = trial.slip_start + slipped;
    if (!contact.is_round) {
        contact.lock = contact.foot - trial.slip_start / contact.edge_length;
    }
}

void count_change(Changes& changes, Trial& trial, std::size_t k) {
    ++changes.opened_or_closed;
    changes.returned += ++trial.flips > 1 ? 1 : 0;
    changes.worst = static_cast<std::int32_t>(k);
}

/// Decides between lock and slide, and the friction of the next solution.
void update_shear(const Settings& settings, const Contact& contact, Trial& trial, Changes& changes) {
    const double limit = shear_limit(settings, contact, trial), shear = contact.joint.shear_stiffness * trial.slip;
    const bool has_turned = trial.mode == Mode::sliding && trial.friction * trial.slip < 0;
    const bool slides = std::abs(shear) >= limit && !has_turned;
    const Mode mode = slides ? Mode::sliding : Mode::locked;
    if (limit == 0 && contact.joint.friction == 0) {  // frictionless: never held
        changes.locked_or_slid += trial.mode == Mode::locked ? 1 : 0;
        trial.mode = Mode::sliding;
        trial.friction = 0;
        return;
    }
    changes.locked_or_slid += mode != trial.mode ? 1 : 0;
    trial.mode = mode;
    const double friction = slides ? std::copysign(limit, trial.slip) : 0;
    trial.change = slides ? std::abs(friction - trial.friction) : 0;
    changes.friction = std::max(changes.friction, trial.change);
    trial.friction = friction;
}

}  // namespace

void begin_trials(const Settings& settings, Scratch& scratch) {
    scratch.trials.resize(scratch.contacts.size());
    for (std::size_t k = 0; k < scratch.contacts.size(); ++k) {
        const Contact& contact = scratch.contacts[k];
        Trial trial;
        trial.mode = contact.mode;
        trial.is_bonded = contact.is_bonded;
        trial.plastic_slip = contact.plastic_slip;
        trial.multiplier = contact.mode == Mode::open ? 0 : contact.multiplier;
        trial.gap = contact.gap.value;
        trial.gap_before = contact.mode == Mode::open ? std::min(trial.gap, 0.0) : trial.gap;
        trial.slip = trial.slip_start = contact.slip.value;
        if (contact.mode != Mode::open) {
            trial.normal = trial.multiplier - contact.joint.normal_stiffness * trial.gap;
        }
        if (contact.mode == Mode::sliding) {
            trial.friction = std::copysign(shear_limit(settings, contact, trial), trial.slip);
        }
        scratch.trials[k] = trial;
    }
}

Changes update_modes(const Settings& settings, double dt, Scratch& scratch) {
    Changes changes;
    for (std::size_t k = 0; k < scratch.contacts.size(); ++k) {
        Contact& contact = scratch.contacts[k];
        Trial& trial = scratch.trials[k];
        const Unknowns &da = scratch.motion[at(contact.a)], &db = scratch.motion[at(contact.b)];
        trial.gap = contact.gap.after(da, db);
        trial.slip = trial.slip_start + dot(contact.slip.a, da) + dot(contact.slip.b, db);
        trial.change = 0;
        const double normal = normal_if_closed(contact, trial, dt);
        if (trial.mode == Mode::open) {
            if (trial.gap < -settings.close_tolerance && normal > 0 && is_foot_on_edge(contact, trial)) {
                lock_at_touch(contact, trial);
                trial.normal = normal;
                trial.mode = Mode::locked;
                update_shear(settings, contact, trial, changes);
                count_change(changes, trial, k);
            }
            continue;
        }
        trial.normal = normal;
        const bool may_pull = trial.is_bonded && contact.joint.tension > 0;
        if (!may_pull && normal < -contact.joint.normal_stiffness * settings.open_tolerance) {
            trial.mode = Mode::open;
            trial.normal = trial.friction = trial.multiplier = 0;
            count_change(changes, trial, k);
            continue;
        }
        changes.largest_normal = std::max(changes.largest_normal, std::abs(normal));
        update_shear(settings, contact, trial, changes);
    }
    return changes;
}

int break_bonds(const Settings& settings, Scratch& scratch) {
    int broken = 0;
    for (std::size_t k = 0; k < scratch.contacts.size(); ++k) {
        const Contact& contact = scratch.contacts[k];
        Trial& trial = scratch.trials[k];
        if (!trial.is_bonded || contact.joint.tension == 0 || trial.mode == Mode::open) {
            continue;
        }
        const double tolerance = contact.joint.normal_stiffness * settings.open_tolerance;
        const bool is_torn = -trial.normal > contact.joint.tension * contact.bond_length + tolerance;
        const bool is_sheared = trial.mode == Mode::sliding && trial.normal < -tolerance;
        if (is_torn || is_sheared) {
            trial.is_bonded = false;
            trial.has_broken = true;
            ++broken;
        }
    }
    return broken;
}

void end_bonds(const Settings& settings, Scratch& scratch) {
    for (std::size_t k = 0; k < scratch.contacts.size(); ++k) {
        const Contact& contact = scratch.contacts[k];
        Trial& trial = scratch.trials[k];
        trial.kept = trial.friction;
        if (!trial.is_bonded || trial.mode == Mode::locked) {
            continue;
        }
        if (trial.mode == Mode::sliding) {
            const double elastic = std::abs(trial.friction) / contact.joint.shear_stiffness;
            trial.plastic_slip += std::max(0.0, std::abs(trial.slip) - elastic);
        } else {
            trial.plastic_slip += std::abs(trial.slip - trial.slip_start);  // without springs all of the motion is slip
        }
        const bool may_be_apart = contact.joint.tension == 0 && trial.gap <= contact.bond_slip;
        trial.is_bonded = (trial.mode == Mode::sliding || may_be_apart) && trial.plastic_slip <= contact.bond_slip;
        trial.has_broken = !trial.is_bonded;
        if (trial.has_broken) {
            trial.kept =
                std::copysign(std::min(std::abs(trial.kept), shear_limit(settings, contact, trial)), trial.kept);
        }
    }
}

double update_multipliers(Scratch& scratch) {
    double largest = 0;
    for (std::size_t k = 0; k < scratch.contacts.size(); ++k) {
        Trial& trial = scratch.trials[k];
        if (trial.mode != Mode::open) {
            largest = std::max(largest, std::abs(trial.gap));
            const double next = trial.multiplier - scratch.contacts[k].joint.normal_stiffness * trial.gap;
            trial.multiplier = trial.is_bonded ? next : std::max(0.0, next);
        }
    }
    return largest;
}

}  // namespace riprap::solid::planar_dda
