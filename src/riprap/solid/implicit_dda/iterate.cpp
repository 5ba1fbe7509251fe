// SPDX-License-Identifier: Apache-2.0
// Open-close iteration of one step.
#include <fmt/format.h>

#include <algorithm>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/implicit_dda/stages.hpp"

namespace riprap::solid::implicit_dda {

namespace {

/// Friction of what slides has settled to this share of the largest push.
constexpr double friction_tolerance = 1e-6;

/// Changes of all contacts in one round of the iteration.
struct Round {
    std::int64_t changed{-1};  ///< a contact whose springs came or went; -1 = none
    double push{0};            ///< largest push [N]
    double unsettled{0};       ///< largest change of a friction [N]
};

/// Takes gap and slip of a contact from the solution and its mode from them.
Round update_contact(const OpenCloseRule& rule, std::int64_t number, Scratch& scratch) {
    ContactTerm& c = scratch.contacts[at(number)];
    evaluate(scratch.equations, c);
    const double friction = c.trial.friction;
    const Vec3 direction = c.trial.direction;
    const ContactMode mode = c.trial.mode;
    Round round;
    if (update_mode(c.springs, rule, c.trial)) {
        round.changed = number;
    } else if (c.trial.mode == ContactMode::slide) {
        round.unsettled = norm(c.trial.friction * c.trial.direction - friction * direction);
    }
    scratch.is_moved[at(number)] = c.trial.mode != mode || c.trial.mode == ContactMode::slide ? 1 : 0;
    round.push = std::max(0.0, -c.springs.normal * c.trial.gap);
    return round;
}

/// Updates all contacts by the solution; rows of those that have changed are stale then.
Round update_contacts(const OpenCloseRule& rule, Scratch& scratch) {
    scratch.is_moved.resize(scratch.contacts.size());
    const Round all = parallel::reduce(
        static_cast<std::int64_t>(scratch.contacts.size()), Round{},
        [&](std::int64_t i) { return update_contact(rule, i, scratch); },
        [](const Round& x, const Round& y) {
            return Round{std::max(x.changed, y.changed), std::max(x.push, y.push), std::max(x.unsettled, y.unsettled)};
        });
    for (std::size_t i = 0; i < scratch.contacts.size(); ++i) {
        if (scratch.is_moved[i] != 0) {
            mark_stale(scratch.contacts[i], scratch.equations);
        }
    }
    return all;
}

}  // namespace

affine::Outcome iterate(const Settings& settings, Scratch& scratch, StepReport& report) {
    Equations& equations = scratch.equations;
    const OpenCloseRule rule{0, 0, settings.slide_tolerance};
    for (report.open_close = 1; report.open_close <= 2 * settings.open_close; ++report.open_close) {
        assemble(scratch.contacts, equations);
        const linear::SolveReport solved = solve(settings.solve, equations);
        report.solver_iterations += solved.iterations;
        if (equations.singular_row >= 0) {
            report.singular = scratch.block[at(equations.singular_row)];
            return {fmt::format("the stiffness of block {} is singular", report.singular), settings.cut};
        }
        if (!solved.is_converged() && solved.residual > 1e3 * settings.solve.tolerance) {
            return {fmt::format("the equations of the step were not solved: {}", describe(solved.status)),
                    settings.cut};
        }
        const auto [changed, push, unsettled] = update_contacts(rule, scratch);
        if (changed < 0 && (unsettled <= friction_tolerance * push || report.open_close > settings.open_close)) {
            return {};
        }
        if (changed >= 0 && report.open_close >= settings.open_close) {
            const affine::BlockContact& c = scratch.found()[at(changed)];
            report.unsettled = {c.a, c.b};
            return {fmt::format("contacts of blocks {} and {} open and close without end", c.a, c.b), settings.cut};
        }
    }
    return {};
}

}  // namespace riprap::solid::implicit_dda
