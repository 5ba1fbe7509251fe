// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/contact/contact_set.hpp"
#include "riprap/contact/count_pairs.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/solid/planar_dda/accounts.hpp"
#include "riprap/solid/planar_dda/assemble.hpp"
#include "riprap/solid/planar_dda/dashpots.hpp"
#include "riprap/solid/planar_dda/move_blocks.hpp"
#include "riprap/solid/planar_dda/open_close.hpp"

namespace riprap::solid::planar_dda {

namespace {

/// Solves for the present modes; the factors are kept while only the right side changed.
Outcome solve(const Model& model, const State& state, double dt, bool has_new_matrix, Scratch& scratch,
              StepReport& report) {
    const auto singular = [&](std::int32_t row) {
        return Outcome{fmt::format("the equations of {} are singular", model.name_of(scratch.block_of_row[at(row)])),
                       0};
    };
    if (has_new_matrix) {
        assemble_matrix(model, state, dt, scratch);
        ++report.factorizations;
        if (const std::int32_t row = scratch.equations.prepare(); row >= 0) {
            return singular(row);
        }
    }
    ++report.iterations;
    assemble_right_side(model, state, dt, scratch);
    if (const std::int32_t row = scratch.equations.solve(scratch.right, scratch.solution); row >= 0) {
        return singular(row);
    }
    for (std::size_t row = 0; row < scratch.solution.size(); ++row) {
        scratch.motion[at(scratch.block_of_row[row])] = scratch.solution[row];
    }
    return {};
}

/// Names the corner and the edge by their place in their blocks.
std::string name_of(const Model& model, const Contact& contact) {
    if (contact.is_round) {
        return fmt::format("{} and {}", model.name_of(contact.a), model.name_of(contact.b));
    }
    return fmt::format("corner {} of {} and edge {} of {}", contact.corner - model.corner_begin[at(contact.a)],
                       model.name_of(contact.a), contact.edge - model.corner_begin[at(contact.b)],
                       model.name_of(contact.b));
}

/// Counts contacts whose friction changed by more than a tolerance [N] after the last solution.
std::int64_t count_changing(const Scratch& scratch, double tolerance) {
    return std::count_if(scratch.trials.begin(), scratch.trials.end(),
                         [tolerance](const Trial& trial) { return trial.change > tolerance; });
}

/// Open-close iteration: solves until no contact opens, closes, locks or slides and no bond breaks. A front of closing
/// or opening that runs through a stack may take as many rounds as it has blocks; only rounds in which a contact goes
/// back to what it was before count against the limit, as those are what a shorter step helps.
Outcome settle_contacts(const Model& model, const Settings& settings, const State& state, double dt, Scratch& scratch,
                        StepReport& report) {
    bool has_new_matrix = true;
    int rounds = 0, friction_rounds = 0;
    while (true) {
        const Outcome outcome = solve(model, state, dt, has_new_matrix, scratch, report);
        if (!outcome.ok()) {
            return outcome;
        }
        const Changes changes = update_modes(settings, dt, scratch);
        has_new_matrix = changes.opened_or_closed + changes.locked_or_slid > 0;
        if (changes.opened_or_closed > 0) {
            rounds += changes.returned > 0 ? 1 : 0;
            if (rounds >= settings.max_iterations) {
                const Contact& contact = scratch.contacts[at(changes.worst)];
                return {fmt::format("open-close iteration does not settle: {}", name_of(model, contact)), 0.3};
            }
            friction_rounds = 0;
            continue;
        }
        const bool is_settled =
            !has_new_matrix && changes.friction <= settings.friction_tolerance * changes.largest_normal;
        if (!is_settled && ++friction_rounds < 3 * settings.max_iterations) {
            continue;
        }
        report.open_frictions =
            is_settled ? 0 : count_changing(scratch, settings.friction_tolerance * changes.largest_normal);
        if (break_bonds(settings, scratch) == 0) {
            return {};
        }
        update_modes(settings, dt, scratch);
        has_new_matrix = true;
        rounds = friction_rounds = 0;
    }
}

/// Largest displacement of a corner [m].
double largest_displacement(const Model& model, const State& state, const Scratch& scratch) {
    double largest = 0;
    for (std::size_t k = 0; k < scratch.corners.size(); ++k) {
        const std::int32_t b = model.corner_block[k];
        const Vec2 r = scratch.corners[k] - Vec2{state.x[at(b)], state.y[at(b)]};
        const Vec2 d = displacement_at(r, scratch.motion[at(b)]);
        largest = std::max(largest, dot(d, d));
    }
    return std::sqrt(largest);
}

Outcome accept_or_refuse(const Settings& settings, const Scratch& scratch, StepReport& report) {
    const double ratio = report.largest_displacement / settings.displacement_limit;
    if (!(ratio <= 3)) {
        return {fmt::format("a corner moves by {:.3g} m in one step, {:.2g} times the limit",
                            report.largest_displacement, ratio),
                std::isfinite(ratio) ? 1 / std::sqrt(ratio) : 0.3};
    }
    std::vector<std::uint64_t> pairs;
    for (std::size_t k = 0; k < scratch.contacts.size(); ++k) {
        const Trial& trial = scratch.trials[k];
        if (trial.mode == Mode::open) {
            continue;
        }
        ++report.closed_contacts;
        const auto [a, b] = std::minmax(scratch.contacts[k].a, scratch.contacts[k].b);
        pairs.push_back(contact::pair_key({a, b}));
        report.largest_overlap = std::max(report.largest_overlap, -trial.gap);
    }
    std::sort(pairs.begin(), pairs.end());
    report.touching_pairs = contact::count_pairs(pairs);
    return {};
}

/// Books the step, moves every block and keeps the contacts.
void accept(const Model& model, const Settings& settings, const Step& step, State& state, Scratch& scratch) {
    Accounts& accounts = state.accounts;
    const double found_energy = remembered_energy(scratch);
    accounts.linearization += found_energy - contact_energy(model, state, scratch.corners);
    const double stored = book_step(model, step, state, scratch, accounts);
    double kinetic = 0;
    for (std::int32_t b = 0; b < model.block_count(); ++b) {
        const Unknowns& d = scratch.motion[at(b)];
        if (model.is_fixed[at(b)]) {
            drive_block(step.dt, d, b, state);
            continue;
        }
        Unknowns rates;
        for (std::size_t k = 0; k < 6; ++k) {
            rates[k] = 2 / step.dt * d[k] - state.rates[6 * at(b) + k];
        }
        kinetic += 0.5 * dot(rates, multiply(mass_block(model.mass[at(b)], spread_of(model, state, b)), rates));
        move_block(model, step.dt, d, b, state);
    }
    keep_contacts(scratch, state);
    place_corners(model, state, scratch.corners);
    const double kinetic_now = kinetic_energy(model, state);
    accounts.linearization += stored_energy(model, state, scratch.corners) - stored + kinetic_now - kinetic;
    if (settings.dynamic_factor != 1) {
        accounts.static_loss += (1 - settings.dynamic_factor * settings.dynamic_factor) * kinetic_now;
        for (double& rate : state.rates) {
            rate *= settings.dynamic_factor;
        }
    }
}

}  // namespace

namespace {

/// Chooses the solver by the stiffest spring over the least inertia 2 m/dt^2, of which the condition number is a small
/// multiple: conjugate gradients take some tens of products, a factorisation of n blocks takes n^2.
Way way_of(const Model& model, double dt, const Scratch& scratch) {
    constexpr std::size_t many = 64;
    constexpr double stiff = 30;
    if (scratch.block_of_row.size() < many) {
        return Way::direct;
    }
    double mass = model.mass[at(scratch.block_of_row.front())], stiffest = 0;
    for (const std::int32_t b : scratch.block_of_row) {
        mass = std::min(mass, model.mass[at(b)]);
    }
    for (const Contact& contact : scratch.contacts) {
        stiffest = std::max(stiffest, contact.joint.normal_stiffness + std::max(0.0, contact.dashpot) / dt);
    }
    for (const body::FixedPoint& point : model.fixed_points) {
        stiffest = std::max(stiffest, point.stiffness);
    }
    for (const body::Bolt& bolt : model.bolts) {
        stiffest = std::max(stiffest, bolt.stiffness);
    }
    return stiffest <= stiff * 2 * mass / (dt * dt) ? Way::iterative : Way::direct;
}

/// Begins the solutions of a step with what the velocities would do.
void guess_motion(const State& state, double dt, Scratch& scratch) {
    scratch.solution.resize(scratch.block_of_row.size());
    for (std::size_t row = 0; row < scratch.solution.size(); ++row) {
        scratch.solution[row] = rates_of(state, scratch.block_of_row[row]);
        for (double& u : scratch.solution[row]) {
            u *= dt;
        }
    }
}

}  // namespace

Outcome advance(const Model& model, const Settings& settings, const Step& step, State& state, Scratch& scratch,
                StepReport& report) {
    report = {};
    Laps laps;
    place_corners(model, state, scratch.corners);
    find_contacts(model, state, settings, scratch.corners, scratch.search, scratch.contacts, step.dt);
    set_dashpots(model, state, step.gravity, step.dt, scratch.contacts);
    laps.end(scratch.times.find_contacts);
    number_rows(model, scratch);
    scratch.equations.set_pattern(static_cast<std::int32_t>(scratch.block_of_row.size()), scratch.couplings,
                                  way_of(model, step.dt, scratch));
    guess_motion(state, step.dt, scratch);
    scratch.motion.assign(at(model.block_count()), Unknowns{});
    for (std::int32_t b = 0; b < model.block_count() && !step.driven.empty(); ++b) {
        scratch.motion[at(b)] = model.is_fixed[at(b)] ? step.driven[at(b)] : Unknowns{};
    }
    assemble_blocks(model, state, step, scratch);
    begin_trials(settings, scratch);
    Outcome outcome = settle_contacts(model, settings, state, step.dt, scratch, report);
    for (int round = 0; outcome.ok() && settings.has_multipliers && round < settings.max_augmentations; ++round) {
        if (update_multipliers(scratch) <= settings.multiplier_tolerance) {
            break;
        }
        outcome = settle_contacts(model, settings, state, step.dt, scratch, report);
    }
    laps.end(scratch.times.contact_loads);
    if (outcome.ok()) {
        report.largest_displacement = largest_displacement(model, state, scratch);
        outcome = accept_or_refuse(settings, scratch, report);
    }
    if (outcome.ok()) {
        end_bonds(settings, scratch);
        accept(model, settings, step, state, scratch);
    }
    laps.end(scratch.times.move_bodies);
    return outcome;
}

}  // namespace riprap::solid::planar_dda
