// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "riprap/run/study/sweep_slurm.hpp"

namespace riprap {

/// Holds what the command line says of a cluster.
struct SlurmWords {
    std::string submit;  ///< "slurm", or empty
    run::SlurmOptions asked;
    bool is_script_only{false};
};

/// Adds --submit and what belongs to it.
void add_slurm_options(CLI::App& command, SlurmWords& words);

/// Refuses words for a cluster without --submit. @throws CLI::Error
void require_submit(const SlurmWords& words);

/// The options of the scripts: those of the words, this program, and the arrays that Slurm takes here.
run::SlurmOptions slurm_of(const SlurmWords& words, int jobs);

/// Hands scripts in, or prints where they are. @returns an exit code
int hand_in(const SlurmWords& words, const run::SlurmScripts& scripts);

/// Tells what `count` runs like the first would take, by steps of it on this machine.
/// @param name  of the first run
void tell_cost(const std::string& case_path, const std::vector<std::string>& overrides, const std::string& name,
               std::size_t count, int threads, int jobs);

}  // namespace riprap
