// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/study/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "command_line_parts.hpp"
#include "commands.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/drive/find_case.hpp"
#include "riprap/run/ensemble/members.hpp"
#include "riprap/run/study/sweep_plan.hpp"
#include "riprap/run/study/sweep_processes.hpp"
#include "riprap/view/sweep_page.hpp"
#include "slurm_options.hpp"

namespace riprap {

namespace {

struct SweepWords {
    std::string case_text, out, list;
    std::vector<std::string> vary, overrides;
    SlurmWords slurm;
    std::size_t point{0};
    int jobs{0}, threads{1};
    bool is_quiet{false}, is_gather{false}, is_plan{false};
};

/// Reads the study that the words describe. @throws CaseError where they describe none
run::SweepOptions study_of(const SweepWords& words) {
    const std::filesystem::path file = run::find_case(words.case_text);
    run::SweepOptions options;
    options.case_path = file.string();
    if (words.list.empty()) {
        std::vector<run::Variation> variations;
        for (const std::string& text : words.vary) {
            variations.push_back(run::read_variation(text));
        }
        options.points = run::grid_of(variations);
    } else {
        constexpr std::size_t most = std::size_t{16} << 20U;
        options.points = run::list_of(io::read_file(words.list, most), words.list);
    }
    options.overrides = words.overrides;
    run::refuse_set_and_varied(options);
    options.out = words.out.empty() ? std::filesystem::path("runs") / (run::short_name(file) + "_sweep")
                                    : std::filesystem::path(words.out);
    options.jobs = words.jobs;
    options.threads = words.threads;
    options.quiet = words.is_quiet;
    return options;
}

/// Tells what the study would take by its first run.
void tell_cost_of(const run::SweepOptions& options, int jobs) {
    std::vector<std::string> overrides = options.overrides;
    const std::vector<std::string>& first = options.points.front().overrides;
    overrides.insert(overrides.end(), first.begin(), first.end());
    tell_cost(options.case_path, overrides, options.points.front().name, options.points.size(), options.threads, jobs);
}

/// Hands a study in to Slurm, or writes its scripts only.
int submit_study(const SweepWords& words, const run::SweepOptions& options) {
    run::claim_study(options);
    if (!words.is_quiet) {
        tell_cost_of(options, words.jobs);
    }
    return hand_in(words.slurm, run::write_slurm_scripts(options, slurm_of(words.slurm, words.jobs)));
}

/// Says what would run, and what it would take; writes nothing.
int plan_study(const run::SweepOptions& options) {
    for (const run::SweepPoint& point : options.points) {
        fmt::print("{}  {}{}\n", point.name, printable(fmt::format("{}", fmt::join(point.overrides, " "))),
                   run::is_finished(options, point) ? "  finished before" : "");
    }
    tell_cost_of(options, options.jobs > 0 ? options.jobs : run::usual_jobs(options.threads));
    return 0;
}

/// Reads the study in a folder, for what takes part in it: a task of a cluster, or the gathering of tables.
run::SweepOptions study_in_folder(const SweepWords& words) {
    run::SweepOptions options = run::read_plan(words.out);
    options.threads = words.threads;
    options.quiet = words.is_quiet;
    return options;
}

int sweep(const SweepWords& words) {
    if (words.point > 0) {
        return run::run_point(study_in_folder(words), words.point);
    }
    int code = 0;
    std::filesystem::path out = words.out;
    if (words.is_gather && run::is_ensemble(out)) {
        return gather_ensemble(out, words.is_quiet);
    }
    if (words.is_gather) {
        code = run::gather_study(study_in_folder(words));
    } else {
        const run::SweepOptions options = study_of(words);
        if (words.is_plan) {
            return plan_study(options);
        }
        if (!words.slurm.submit.empty()) {
            return submit_study(words, options);
        }
        const bool is_done = std::all_of(options.points.begin(), options.points.end(),
                                         [&](const auto& point) { return run::is_finished(options, point); });
        if (!words.is_quiet && !is_done) {
            tell_cost_of(options, options.jobs > 0 ? options.jobs : run::usual_jobs(options.threads));
        }
        code = run::run_sweep(options);
        out = options.out;
    }
    fmt::print("{}\n", view::write_sweep_page(out).string());
    return code;
}

/// Adds the options with which the tasks of a cluster call this program.
void add_task_options(CLI::App& command, SweepWords& words) {
    command.add_option("--point", words.point, "Run one run of the study in --out, by its number from 1")
        ->check(CLI::PositiveNumber);
    command.add_flag("--gather", words.is_gather, "Make the tables of the study in --out from what its runs have left");
}

/// Refuses what does not go together. @throws CLI::Error
void require_whole(const SweepWords& words) {
    const bool takes_part = words.point > 0 || words.is_gather;
    if (takes_part &&
        ((words.point > 0 && words.is_gather) || !words.slurm.submit.empty() || words.is_plan || words.jobs > 0)) {
        throw CLI::ExcludesError("--point and --gather", "each other, --submit, --plan and --jobs");
    }
    if (takes_part && words.out.empty()) {
        throw CLI::RequiredError("--out");
    }
    if (takes_part &&
        !(words.case_text.empty() && words.vary.empty() && words.list.empty() && words.overrides.empty())) {
        throw CLI::ExcludesError("--point and --gather", "CASE, --vary, --list and --set: the plan in --out has them");
    }
    if (!takes_part && words.case_text.empty()) {
        throw CLI::RequiredError("CASE");
    }
    if (!takes_part && words.vary.empty() && words.list.empty()) {
        throw CLI::RequiredError("--vary or --list");
    }
    if (words.is_plan && !words.slurm.submit.empty()) {
        throw CLI::ExcludesError("--plan", "--submit");
    }
    require_submit(words.slurm);
}

}  // namespace

void add_sweep(CLI::App& app, Action& action) {
    constexpr int max_jobs = 1024;
    auto words = std::make_shared<SweepWords>();
    CLI::App* command =
        app.add_subcommand("sweep", "Run a case many times with other values of some keys, and compare the answers");
    command->footer(
        "Example:\n"
        "  riprap sweep hello_block --vary material.rock.friction_angle_deg=10,20,25 --vary end=0.5,1\n"
        "runs six cases, several at a time, into runs/hello_block_sweep: a folder each, sweep.csv, sweep.json and\n"
        "index.html. Repeat the command to resume unfinished runs. With --submit slurm a cluster runs them.");
    command->add_option("CASE", words->case_text,
                        "A case file, a folder with a case.toml, or a name from `riprap list`");
    CLI::Option* vary = command->add_option("--vary", words->vary, "A key and its values; several make a grid")
                            ->type_name("KEY=A,B,...")
                            ->allow_extra_args(false);
    command
        ->add_option("--list", words->list,
                     "Instead of --vary: a text file with keys in its first line and the values of a run in each other")
        ->type_name("FILE")
        ->excludes(vary);
    add_set(*command, words->overrides, "Replace a key of the case in all runs");
    command->add_option("--out", words->out, "The folder of the study (default: runs/NAME_sweep)");
    command->add_option("--jobs", words->jobs, "Runs at a time (default: as many as cores allow)")
        ->check(CLI::Range(1, max_jobs));
    command->add_option("--threads", words->threads, "Threads of each run (default: 1)")
        ->check(CLI::Range(1, max_jobs));
    command->add_flag("--quiet", words->is_quiet, "Print the page and errors only");
    command->add_flag("--plan", words->is_plan, "Say what would run, and what it would take; run nothing");
    add_slurm_options(*command, words->slurm);
    add_task_options(*command, *words);
    command->callback([&action, words] {
        require_whole(*words);
        action = [words] { return sweep(*words); };
    });
}

}  // namespace riprap
