// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/sweep.hpp"

#include <fmt/format.h>

#include <memory>

#include "command_line_parts.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/find_case.hpp"
#include "riprap/run/progress.hpp"
#include "riprap/run/run_case.hpp"
#include "riprap/run/run_cost.hpp"
#include "riprap/run/sweep_plan.hpp"
#include "riprap/run/sweep_slurm.hpp"
#include "riprap/view/sweep_page.hpp"

namespace riprap {

namespace {

struct SweepWords {
    std::string case_text, out, list;
    std::vector<std::string> vary, overrides;
    std::string submit;
    run::SlurmOptions slurm;
    std::size_t point{0};
    int jobs{0}, threads{1};
    bool is_quiet{false}, is_gather{false}, is_script_only{false};
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

/// Tells what the runs of a study would take, by the first steps of the first of them, on this machine.
void tell_cost(const run::SweepOptions& options) {
    constexpr double budget = 2;  // [s]
    std::vector<std::string> overrides = options.overrides;
    const std::vector<std::string>& first = options.points.front().overrides;
    overrides.insert(overrides.end(), first.begin(), first.end());
    run::RunCost cost;
    try {
        cost = run::measure_cost(scene::read_case(options.case_path, overrides), budget);
    } catch (const CaseError& error) {
        cost.refusal = error.what();
    }
    if (!cost.refusal.empty()) {
        fmt::print("{} runs; the first is refused: {}\n", options.points.size(), printable(cost.refusal));
        return;
    }
    fmt::print(
        "{} runs; by its first steps {} takes {} steps and {} here with {} threads, and as many runs like it {}\n",
        options.points.size(), options.points.front().name, cost.steps, run::duration_text(cost.seconds()),
        options.threads, run::duration_text(cost.seconds() * static_cast<double>(options.points.size())));
}

/// Hands a study in to Slurm, or writes its scripts only.
int submit_study(const SweepWords& words, const run::SweepOptions& options) {
    run::claim_study(options);
    if (!words.is_quiet) {
        run::use_threads(options.threads);
        tell_cost(options);
    }
    run::SlurmOptions slurm = words.slurm;
    slurm.jobs = words.jobs;
    slurm.program = std::filesystem::read_symlink("/proc/self/exe");
    slurm.largest_index = run::largest_array_index();
    const run::SlurmScripts scripts = run::write_slurm_scripts(options, slurm);
    if (words.is_script_only) {
        fmt::print("{}\n", printable(scripts.submit.string()));
        return 0;
    }
    return run::submit(scripts);
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
    if (words.is_gather) {
        code = run::gather_study(study_in_folder(words));
    } else {
        const run::SweepOptions options = study_of(words);
        if (!words.submit.empty()) {
            return submit_study(words, options);
        }
        code = run::run_sweep(options);
        out = options.out;
    }
    fmt::print("{}\n", view::write_sweep_page(out).string());
    return code;
}

/// Adds the options that make a study a job array of Slurm, and those with which its tasks call this program.
void add_slurm_options(CLI::App& command, SweepWords& words) {
    command.add_option("--submit", words.submit, "Hand the runs in as a job array instead: slurm")
        ->check(CLI::IsMember({"slurm"}))
        ->type_name("slurm");
    command.add_flag("--script-only", words.is_script_only, "With --submit: write the scripts, hand nothing in");
    command.add_option("--partition", words.slurm.partition, "With --submit: the partition of the cluster");
    command.add_option("--account", words.slurm.account, "With --submit: the account that pays");
    command.add_option(
        "--time", words.slurm.time,
        "With --submit: the time limit of a run, as 2:00:00; what takes longer is queued again and goes on");
    command.add_option("--memory", words.slurm.memory, "With --submit: memory of a run, as 4G");
    command.add_option("--point", words.point, "Run one run of the study in --out, by its number from 1")
        ->check(CLI::PositiveNumber);
    command.add_flag("--gather", words.is_gather, "Make the tables of the study in --out from what its runs have left");
}

/// Refuses what does not go together. @throws CLI::Error
void require_whole(const SweepWords& words) {
    const bool takes_part = words.point > 0 || words.is_gather;
    if (takes_part && ((words.point > 0 && words.is_gather) || !words.submit.empty() || words.jobs > 0)) {
        throw CLI::ExcludesError("--point and --gather", "each other, --submit and --jobs");
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
    const run::SlurmOptions& slurm = words.slurm;
    const bool asks_slurm = words.is_script_only || !slurm.partition.empty() || !slurm.account.empty() ||
                            !slurm.time.empty() || !slurm.memory.empty();
    if (asks_slurm && words.submit.empty()) {
        throw CLI::RequiresError("--script-only, --partition, --account, --time and --memory", "--submit");
    }
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
    command->add_option("--set", words->overrides, "Replace a key of the case in all runs")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command->add_option("--out", words->out, "The folder of the study (default: runs/NAME_sweep)");
    command->add_option("--jobs", words->jobs, "Runs at a time (default: as many as cores allow)")
        ->check(CLI::Range(1, max_jobs));
    command->add_option("--threads", words->threads, "Threads of each run (default: 1)")
        ->check(CLI::Range(1, max_jobs));
    command->add_flag("--quiet", words->is_quiet, "Print the page and errors only");
    add_slurm_options(*command, *words);
    command->callback([&action, words] {
        require_whole(*words);
        action = [words] { return sweep(*words); };
    });
}

}  // namespace riprap
