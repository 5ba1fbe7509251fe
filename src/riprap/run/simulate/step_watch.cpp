// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/simulate/step_watch.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "riprap/run/simulate/passage_verdict.hpp"

namespace riprap::run {

namespace {

double bound_of(const sim::StepReport& report) { return std::min(report.dt_bound, report.fluid_dt_bound); }

}  // namespace

void StepCounts::add(const sim::StepReport& report, bool meets_end) {
    above_bound += report.dt > bound_of(report) ? 1 : 0;
    unsettled += report.is_fluid_settled ? 0 : 1;
    with_open_friction += report.open_frictions > 0 ? 1 : 0;
    open_frictions += report.open_frictions;
    with_intruder += report.particles.intruder.empty() ? 0 : 1;
    through_walls += report.particles.through_walls.count;
    renewals += report.particles.renewals;
    solver_iterations += report.solver_iterations;
    most_iterations = std::max(most_iterations, report.solver_iterations);
    worst_residual = std::max(worst_residual, report.solver_residual);
    longest = std::max(longest, report.dt);
    if (!meets_end) {
        shortest = shortest > 0 ? std::min(shortest, report.dt) : report.dt;
    }
}

std::vector<Notice> StepWatch::look(const sim::StepReport& report, const sim::State& state, const StepCounts& counts) {
    const std::string when = fmt::format("step {}, t = {:.6g} s", state.step, state.time);
    std::vector<Notice> notices;
    look_at_length(report, when, notices);
    if (!report.is_fluid_settled && counts.unsettled == 1) {
        notices.push_back(
            {fmt::format("{}: the accelerations of light bodies in water have not settled after {} passes, {:.2g} "
                         "of them is still open; the summary counts the steps",
                         when, report.fluid_passes, report.fluid_residual),
             "water_residual", report.fluid_residual});
    }
    if (report.open_frictions > 0 && counts.with_open_friction == 1) {
        notices.push_back(
            {fmt::format("{}: the friction of {} sliding contacts has not settled within the rounds of the open-close "
                         "iteration; a higher open_close or a shorter step lets it; the summary counts them",
                         when, report.open_frictions),
             "open_frictions", static_cast<double>(report.open_frictions)});
    }
    if (!report.particles.intruder.empty() && counts.with_intruder == 1) {
        notices.push_back({fmt::format("{}: {}: neither is right there; the summary counts the steps", when,
                                       report.particles.intruder),
                           "time", state.time});
    }
    if (report.particles.through_walls.count > 0 && counts.through_walls == report.particles.through_walls.count) {
        notices.push_back(
            {fmt::format("{}: water has gone through a wall that it is pressed against; the summary counts "
                         "the particles, and more than {:g} % of all end the run",
                         when, 100 * share_through_walls),
             "water_through_walls", static_cast<double>(report.particles.through_walls.count)});
    }
    return notices;
}

void StepWatch::look_at_length(const sim::StepReport& report, const std::string& when, std::vector<Notice>& notices) {
    const double bound = bound_of(report), excess = report.dt / bound;
    if (!(excess > 1) || excess < 2 * told_excess_) {
        return;
    }
    told_excess_ = excess;
    const bool is_fluid = report.fluid_dt_bound <= report.dt_bound;
    notices.push_back({fmt::format("{}: the time step {:.4g} s is {:.3g} times what {} now ({:.4g} s, a bound that "
                                   "errs on the safe side); a smaller {} is safer",
                                   when, report.dt, excess, is_fluid ? "the water allows" : "the contacts allow", bound,
                                   is_fluid ? "time_step" : "time_step, or time_step_factor,"),
                       "dt_bound", bound});
}

std::vector<std::string> StepWatch::totals(const StepCounts& counts, std::int64_t steps) {
    std::vector<std::string> lines;
    if (counts.unsettled > 0) {
        lines.push_back(fmt::format("the accelerations of light bodies in water did not settle in {} of {} steps",
                                    counts.unsettled, steps));
    }
    if (counts.with_open_friction > 0) {
        lines.push_back(
            fmt::format("the friction of sliding contacts did not settle in {} of {} steps, {} contacts in all",
                        counts.with_open_friction, steps, counts.open_frictions));
    }
    if (counts.with_intruder > 0) {
        lines.push_back(fmt::format("bodies stood behind openings in {} of {} steps", counts.with_intruder, steps));
    }
    if (counts.through_walls > 0) {
        lines.push_back(fmt::format("{} particle{} of water went through walls", counts.through_walls,
                                    counts.through_walls == 1 ? "" : "s"));
    }
    if (const double n = counts.sound_steps(steps); n > 1) {
        // Both laws are those of docs/theory/sph.md, 12.
        lines.push_back(
            fmt::format("{:.2f} sound steps to a flow step in the mean: {:.2f} passes a step by the model "
                        "0.85 + 2.35/n, {:.2f} by what was measured, 1.2 + 2.6/n; 2.5 with one clock",
                        n, 0.85 + 2.35 / n, 1.2 + 2.6 / n));
    } else if (counts.renewals > 0) {
        lines.emplace_back("each step of sound had a geometry of its own, as with fluid.sound_steps = 1");
    }
    return lines;
}

}  // namespace riprap::run
