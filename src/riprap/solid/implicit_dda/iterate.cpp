// SPDX-License-Identifier: Apache-2.0
// Open-close iteration of one step.
#include <fmt/format.h>

#include <algorithm>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/core/timer.hpp"
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

/// Takes gaps and slips of a pair from the solution and its modes from them; the pair is stale where they change it.
Round update_pair(const OpenCloseRule& rule, std::int64_t number, Scratch& scratch) {
    Equations& equations = scratch.equations;
    const PairTerm& pair = equations.pairs[at(number)];
    const PairMotion motion(pair, equations.solution);
    Round round;
    bool is_stale = false;
    for (std::int32_t i = pair.first; i < pair.end; ++i) {
        ContactTerm& c = scratch.contacts[at(i)];
        evaluate(motion, c);
        const double friction = c.trial.friction;
        const Vec3 direction = c.trial.direction;
        c.trial.change = 0;
        if (update_mode(c.springs, rule, c.trial)) {
            round.changed = i;
            is_stale = true;
        } else if (c.trial.mode == ContactMode::slide) {
            c.trial.change = norm(c.trial.friction * c.trial.direction - friction * direction);
            round.unsettled = std::max(round.unsettled, c.trial.change);
        }
        is_stale = is_stale || c.trial.mode == ContactMode::slide;
        round.push = std::max(round.push, -c.springs.normal * c.trial.gap);
    }
    equations.is_stale[at(number)] = is_stale ? 1 : 0;
    return round;
}

Round update_contacts(const OpenCloseRule& rule, Scratch& scratch) {
    return parallel::reduce(
        static_cast<std::int64_t>(scratch.equations.pairs.size()), Round{},
        [&](std::int64_t pair) { return update_pair(rule, pair, scratch); },
        [](const Round& x, const Round& y) {
            return Round{std::max(x.changed, y.changed), std::max(x.push, y.push), std::max(x.unsettled, y.unsettled)};
        },
        256);
}

/// Counts contacts whose friction changed by more than a tolerance [N] in the last round.
std::int64_t count_changing(const Scratch& scratch, double tolerance) {
    return std::count_if(scratch.contacts.begin(), scratch.contacts.end(),
                         [tolerance](const ContactTerm& c) { return c.trial.change > tolerance; });
}

}  // namespace

Outcome iterate(const Settings& settings, Scratch& scratch, StepReport& report) {
    Equations& equations = scratch.equations;
    const OpenCloseRule rule{0, 0, settings.slide_tolerance.value_or(-1), settings.joint_law};
    for (report.open_close = 1; report.open_close <= 2 * settings.open_close; ++report.open_close) {
        assemble(scratch.contacts, equations);
        Laps laps;
        const linear::SolveReport solved = solve(settings.solve, equations);
        laps.end(scratch.solve_time);
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
        const double tolerance = friction_tolerance * push;
        if (changed < 0 && (unsettled <= tolerance || report.open_close > settings.open_close)) {
            report.open_frictions = unsettled > tolerance ? count_changing(scratch, tolerance) : 0;
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
