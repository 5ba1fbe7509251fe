// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "command_line_parts.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/run/drive/find_case.hpp"
#include "riprap/run/study/sweep_processes.hpp"
#include "riprap/view/strength/fos_trials.hpp"
#include "slurm_options.hpp"

namespace riprap {

namespace {

struct FosWords {
    view::FosRequest request;
    std::string case_text, out;
    std::vector<double> between{0.5, 5};
    bool is_plan{false};
};

/// Says what is watched, how trials go, and what they cost.
void tell_plan(const view::FosRequest& request, const view::FosPlan& plan, const run::FactorSearch& search) {
    const run::TrialTimes& times = plan.times;
    fmt::print(
        "watches {} bodies of up to {:.4g} m; strength falls from {:.4g} to {:.4g} s and is held to {:.4g} s; a body "
        "fails that creeps {:.2g} of its size in the hold and does not slow down, or has moved {:.2g} of it\n",
        plan.watched.size(), plan.size, times.begins, times.ramp_end(), times.end(), request.criteria.creep,
        request.criteria.displaced);
    if (plan.method != plan.proposed) {
        fmt::print(
            "solid.method is {}; {} is proposed, where it moves the bodies of the case: it takes the fewest steps\n",
            plan.method, plan.proposed);
    }
    const run::SweepPoint first = run::trial_at(request.range.high, 1);
    std::vector<std::string> overrides = plan.study.overrides;
    overrides.insert(overrides.end(), first.overrides.begin(), first.overrides.end());
    tell_cost(request.case_path, overrides, "a trial", static_cast<std::size_t>(search.trials_left()), request.threads,
              request.jobs);
}

int find_factor(const FosWords& words) {
    view::FosRequest request = words.request;
    const std::filesystem::path file = run::find_case(words.case_text);
    request.case_path = file.string();
    request.out = words.out.empty() ? std::filesystem::path("runs") / (run::short_name(file) + "_fos")
                                    : std::filesystem::path(words.out);
    request.jobs = request.jobs > 0 ? request.jobs : run::usual_jobs(request.threads);
    request.range.low = words.between[0];
    request.range.high = words.between[1];
    request.range.at_a_time = request.jobs;
    const view::FosPlan plan = view::plan_fos(request);
    if (words.is_plan || !request.quiet) {
        tell_plan(request, plan, run::FactorSearch(request.range));
    }
    return words.is_plan ? 0 : view::run_fos(request, plan);
}

void add_criteria(CLI::App& command, view::FosRequest& request) {
    const CLI::Range share(1e-9, 10.0), seconds(0.0, 1e9);
    command
        .add_option("--watch", request.watched, "Beginning of the names of bodies that are watched (default: all free)")
        ->type_name("NAME");
    command
        .add_option("--begins", request.begins,
                    "When strength begins to fall [s] (default: the end of the case; 0 where bodies settle before "
                    "time 0 and there is no water)")
        ->check(seconds);
    command
        .add_option("--over", request.over,
                    "How long it falls [s] (default: 6 sqrt(size/g), of the largest watched body)")
        ->check(seconds);
    command.add_option("--hold", request.hold, "How long it is held then [s] (default: as --over)")->check(seconds);
    command
        .add_option("--creep", request.criteria.creep,
                    "A body fails that moves by more than this share of its size in the hold, in its second half at "
                    "more than half the speed of the first (default: 0.001)")
        ->check(share);
    command
        .add_option("--displaced", request.criteria.displaced,
                    "A body fails that has moved by more than this share of its size, at rest or not (default: 0.1)")
        ->check(share);
}

}  // namespace

void add_fos(CLI::App& app, Action& action) {
    constexpr int max_jobs = 1024;
    auto words = std::make_shared<FosWords>();
    view::FosRequest& request = words->request;
    CLI::App* command = app.add_subcommand("fos", "Find the factor of safety of a case, by reduction of strength");
    command->footer(
        "Example:\n"
        "  riprap fos slope_section --out runs/slope_fos\n"
        "runs trials in which friction, cohesion and tensile strength of all contacts fall to 1/F of theirs, and "
        "brackets\n"
        "the F at which bodies fail: fos.json, fos.csv, fos_bodies.csv, fos.svg and index.html. Repeat the command to "
        "resume.\n"
        "Exit code 0: found; 1: it does not lie in --between, or trials contradict each other.");
    command
        ->add_option("CASE", words->case_text, "A case file, a folder with a case.toml, or a name from `riprap list`")
        ->required();
    command->add_option("--between", words->between, "Least and largest F tried (default: 0.5 5)")
        ->expected(2)
        ->check(CLI::Range(0.01, 1000.0))
        ->type_name("LOW HIGH");
    command->add_option("--tolerance", request.range.tolerance, "Width of the bracket over F (default: 0.01)")
        ->check(CLI::Range(1e-3, 1.0));
    command
        ->add_option("--reduce", request.reduces,
                     "friction, cohesion, tension, separated by commas: strengths that are divided (default: all)")
        ->delimiter(',')
        ->check(CLI::IsMember({"friction", "cohesion", "tension"}));
    add_criteria(*command, request);
    add_set(*command, request.overrides, "Replace a key of the case in all trials");
    command->add_option("--out", words->out, "The folder of the search (default: runs/NAME_fos)");
    request.jobs = 0;
    command->add_option("--jobs", request.jobs, "Trials at a time (default: as many as cores allow)")
        ->check(CLI::Range(1, max_jobs));
    command->add_option("--threads", request.threads, "Threads of each trial (default: 1)")
        ->check(CLI::Range(1, max_jobs));
    command->add_flag("--quiet", request.quiet, "Print the result and errors only");
    command->add_flag("--plan", words->is_plan, "Say how trials go and what they cost; run nothing");
    command->callback([&action, words] {
        if (!(words->between[0] < words->between[1])) {
            throw CLI::ValidationError("--between", "the first is the lower one, as 0.5 5");
        }
        action = [words] { return find_factor(*words); };
    });
}

}  // namespace riprap
