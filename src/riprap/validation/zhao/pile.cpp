// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/zhao/pile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "riprap/core/timer.hpp"
#include "riprap/validation/saved_trial.hpp"
#include "riprap/validation/side_view.hpp"

namespace riprap::validation::zhao {

namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Sum of m z over the sum of m of the free bodies [m].
double center_height(const Trial& trial) {
    const body::BodySet& bodies = trial.model().bodies;
    double mass = 0, moment = 0;
    for (std::int32_t i = 0; i < bodies.size(); ++i) {
        if (bodies.drive[at(i)] == body::Drive::free) {
            mass += bodies.mass[at(i)];
            moment += bodies.mass[at(i)] * trial.state().bodies.position[at(i)].z;
        }
    }
    return moment / mass;
}

/// Upward force of the fixed bodies on the others in the last step [N].
double support_force(const Trial& trial) {
    const body::BodySet& bodies = trial.model().bodies;
    double force = 0;
    for (std::int32_t i = 0; i < bodies.size(); ++i) {
        if (bodies.drive[at(i)] == body::Drive::fixed) {
            force -= trial.scratch().contact_force()[at(i)].z;
        }
    }
    return force;
}

int count_escaped(const Trial& trial, double width) {
    const body::BodySet& bodies = trial.model().bodies;
    int count = 0;
    for (std::int32_t i = 0; i < bodies.size(); ++i) {
        const Vec3& x = trial.state().bodies.position[at(i)];
        const bool is_inside = x.x > 0 && x.x < width && x.y > 0 && x.y < width && x.z > 0;
        count += bodies.drive[at(i)] == body::Drive::free && !is_inside ? 1 : 0;
    }
    return count;
}

void draw(const Trial& trial, const CaseSetting& setting, const std::string& name, double time, PileRun& run) {
    run.snapshots.push_back(fmt::format("{}_{:.2f}s", name, time));
    write_plot(setting, run.snapshots.back(),
               side_view_plot(trial.model(), trial.state(), {}, fmt::format("{} at t = {:.2f} s", name, time)));
}

/// One window: means of kinetic energy [J] and support [N]; the bound of the contacts is looked at now and then.
struct WindowMeans {
    double kinetic, support;
};
WindowMeans pass_window(Trial& trial, double& largest_kinetic, PileRun& run) {
    const int steps = std::max(1, static_cast<int>(std::lround(rest_window / trial.dt())));
    WindowMeans means{0, 0};
    for (int i = 0; i < steps; ++i) {
        const bool looks = i % 20 == 0 || i + 1 == steps;
        trial.follow_energy(looks);
        const sim::StepReport& report = trial.step();
        if (looks && std::isfinite(report.dt_bound)) {
            run.share_of_bound = std::max(run.share_of_bound, trial.dt() / report.dt_bound);
        }
        means.kinetic += report.ledger.kinetic / steps;
        means.support += support_force(trial) / steps;
        largest_kinetic = std::max(largest_kinetic, report.ledger.kinetic);
    }
    return means;
}

/// Saves a fall on its way, and takes it up.
class Keeper {
 public:
    Keeper(const CaseSetting& setting, const std::string& name, const sim::Model& model)
        : path_(setting.results.empty() ? std::filesystem::path()
                                        : setting.results / fmt::format("{}-{:016x}.trial", name, model.case_hash)) {}

    void take_up(Trial& trial, double& largest_kinetic, PileRun& run) const {
        TrialRecord record;
        record.program = path_.empty() ? 0 : program_identity();
        if (path_.empty() || !take_up_trial(path_, trial.model(), trial.state(), record)) {
            return;
        }
        run.times = record.time;
        run.kinetic.assign(record.values.begin(), record.values.end() - 3);
        run.share_of_bound = record.values.end()[-3];
        run.kinetic_share = record.values.end()[-2];
        largest_kinetic = record.values.end()[-1];
    }
    bool is_due() const { return since_save_.seconds() >= save_every; }
    void save(const Trial& trial, double largest_kinetic, const PileRun& run) {
        if (path_.empty()) {
            return;
        }
        TrialRecord record{run.times, run.kinetic, 0, 0, program_identity()};
        record.values.insert(record.values.end(), {run.share_of_bound, run.kinetic_share, largest_kinetic});
        save_trial(path_, trial.model(), trial.state(), record);
        since_save_.restart();
    }

 private:
    std::filesystem::path path_;
    Timer since_save_;
};

}  // namespace

PileRun fall_to_rest(Trial& trial, double width, const CaseSetting& setting, const std::string& name) {
    PileRun run;
    const double start_height = center_height(trial);
    std::vector<double> moments{0.5, 1, 2, 3, 4};
    double largest_kinetic = 0;
    draw(trial, setting, name, 0, run);
    Keeper keeper(setting, name, trial.model());
    keeper.take_up(trial, largest_kinetic, run);
    std::erase_if(moments, [&](double moment) { return trial.time() >= moment - 0.5 * rest_window; });
    const auto goes_on = [&] {
        return run.kinetic_share >= 1e-6 && trial.time() < trial.model().time.end - 0.5 * rest_window;
    };
    while (goes_on()) {
        const WindowMeans means = pass_window(trial, largest_kinetic, run);
        run.kinetic_share = means.kinetic / largest_kinetic;
        run.support = means.support / (norm(trial.model().gravity.value) * trial.report().ledger.mass);
        run.times.push_back(trial.time());
        run.kinetic.push_back(run.kinetic_share);
        const bool is_moment = !moments.empty() && trial.time() >= moments.front() - 0.5 * rest_window;
        if (is_moment) {
            draw(trial, setting, name, moments.front(), run);
            moments.erase(moments.begin());
        }
        // Not at its end: support and ledger are those of the last window, which a fall that is taken up passes anew.
        if (goes_on() && (is_moment || keeper.is_due())) {
            keeper.save(trial, largest_kinetic, run);
        }
    }
    draw(trial, setting, name, trial.time(), run);
    const sim::StepReport& last = trial.report();
    run.time = trial.time();
    run.energy_error = std::abs(last.ledger.residual) / last.ledger.turnover;
    run.max_potential = last.max_potential;
    for (const contact::ShownContact& row : trial.contacts()) {
        run.largest_force = std::max(run.largest_force, row.normal_force);
    }
    run.mean_height = center_height(trial);
    run.fall = start_height - run.mean_height;
    run.escaped = count_escaped(trial, width);
    return run;
}

void judge_pile(const PileRun& run, const std::function<double(double)>& demanded, const std::string& why,
                const std::string& prefix, CaseReport& report) {
    const auto of = [&prefix](const char* what) { return prefix + what; };
    report.judge({of("kinetic energy over its largest"), "-", std::string("reaches rest"), 0.0,
                  fmt::format("mean over {} s, at t = {:.2f} s", rest_window, run.time)},
                 run.kinetic_share, 0, 1e-6);
    report.judge({of("force of floor and walls over the weight"), "-", {}, 1.0, {}}, run.support, Absolute{1e-3});
    report.judge({of("largest potential at rest"),
                  "-",
                  std::string("< 0.01"),
                  {},
                  fmt::format("at most what the largest force, {:.3g} N, demands: {}; below 0.01 it would take k_n = "
                              "{:.2g} Pa",
                              run.largest_force, why, 1e6 * std::pow(run.max_potential / 0.01, 3))},
                 run.max_potential, 0, demanded(run.largest_force));
    report.judge(
        {of("energy that the ledger does not close by, over the turnover"), "-", {}, 0.0, {}, Kind::bookkeeping},
        run.energy_error, 0, 0.01);
    report.judge({of("blocks outside the box"), "-", {}, 0.0, {}, Kind::bookkeeping}, run.escaped, 0, 0);
    report.judge({of("largest step over the bound for the contacts of the moment"), "-", {}, {}, {}, Kind::bookkeeping},
                 run.share_of_bound, 0, 0.2);
}

}  // namespace riprap::validation::zhao
