// SPDX-License-Identifier: Apache-2.0
#include "slurm_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/run/drive/progress.hpp"
#include "riprap/run/drive/run_case.hpp"
#include "riprap/run/drive/run_cost.hpp"

namespace riprap {

void add_slurm_options(CLI::App& command, SlurmWords& words) {
    command.add_option("--submit", words.submit, "Hand the runs in as a job array instead: slurm")
        ->check(CLI::IsMember({"slurm"}))
        ->type_name("slurm");
    command.add_flag("--script-only", words.is_script_only, "With --submit: write the scripts, hand nothing in");
    command.add_option("--partition", words.asked.partition, "With --submit: the partition of the cluster");
    command.add_option("--account", words.asked.account, "With --submit: the account that pays");
    command.add_option(
        "--time", words.asked.time,
        "With --submit: the time limit of a run, as 2:00:00; what takes longer is queued again and goes on");
    command.add_option("--memory", words.asked.memory, "With --submit: memory of a run, as 4G");
}

void require_submit(const SlurmWords& words) {
    const run::SlurmOptions& slurm = words.asked;
    const bool asks_slurm = words.is_script_only || !slurm.partition.empty() || !slurm.account.empty() ||
                            !slurm.time.empty() || !slurm.memory.empty();
    if (asks_slurm && words.submit.empty()) {
        throw CLI::RequiresError("--script-only, --partition, --account, --time and --memory", "--submit");
    }
}

run::SlurmOptions slurm_of(const SlurmWords& words, int jobs) {
    run::SlurmOptions slurm = words.asked;
    slurm.jobs = jobs;
    slurm.program = std::filesystem::read_symlink("/proc/self/exe");
    slurm.largest_index = run::largest_array_index();
    return slurm;
}

int hand_in(const SlurmWords& words, const run::SlurmScripts& scripts) {
    if (words.is_script_only) {
        fmt::print("{}\n", printable(scripts.submit.string()));
        return 0;
    }
    return run::submit(scripts);
}

void tell_cost(const std::string& case_path, const std::vector<std::string>& overrides, const std::string& name,
               std::size_t count, int threads, int jobs) {
    constexpr double budget = 2;  // [s]
    run::use_threads(threads);
    run::RunCost cost;
    try {
        cost = run::measure_cost(scene::read_case(case_path, overrides), budget);
    } catch (const CaseError& error) {
        cost.refusal = error.what();
    }
    if (!cost.refusal.empty()) {
        fmt::print("{} runs; the first is refused: {}\n", count, printable(cost.refusal));
        return;
    }
    const double all = cost.seconds() * static_cast<double>(count);
    const std::size_t rounds =
        jobs > 0 ? (count + static_cast<std::size_t>(jobs) - 1) / static_cast<std::size_t>(jobs) : 0;
    fmt::print(
        "{} runs; by its first steps {} takes {} steps and {} here with {} threads, and as many runs like it {}{}\n",
        count, name, cost.steps, run::duration_text(cost.seconds()), threads, run::duration_text(all),
        rounds == 0 ? ""
                    : fmt::format(", {} where {} run at a time",
                                  run::duration_text(cost.seconds() * static_cast<double>(rounds)), jobs));
}

}  // namespace riprap
