// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace riprap {

/// Work of the command that was named; returns the exit code.
using Action = std::function<int()>;

/// For commands that only print: a reader that has seen enough (`| head`) ends them without a word, as it does others.
void end_with_reader();

/// Adds --set KEY=VALUE. One key with two values is refused: the last one would count without a word.
void add_set(CLI::App& command, std::vector<std::string>& overrides, const std::string& help);
/// @throws CLI::ValidationError where an assignment gives a key of `overrides` another value
void refuse_second_value(const std::vector<std::string>& overrides, const std::string& assignment);

/// Adds the commands that look at the folder of a run: view, render, plot, waves, damage and pack.
void add_commands_of_runs(CLI::App& app, Action& action);

/// Adds single commands: a study of many runs, a case to start from, an old case with the names of today, and texts
/// made from all commands.
void add_sweep(CLI::App& app, Action& action);
void add_fos(CLI::App& app, Action& action);
void add_new(CLI::App& app, Action& action);
void add_upgrade(CLI::App& app, Action& action);
void add_completion(CLI::App& app, Action& action);
void add_man(CLI::App& app, Action& action);

/// Says what is wrong with `words`, all that follows the name of the program: a command or an option that there is
/// not, and the nearest there is, or else what `error` says. @returns the exit code for a bad command line.
int refuse(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& words);

}  // namespace riprap
