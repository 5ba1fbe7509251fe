// SPDX-License-Identifier: Apache-2.0
#include "command_line.hpp"

#include <CLI/CLI.hpp>
#include <functional>

#include "commands.hpp"
#include "riprap/core/error.hpp"

namespace riprap {

namespace {

constexpr const char* exit_code_help =
    "Exit codes: 0 success; 1 an expected answer was missed; 2 bad command line; 3 the case or an input file is "
    "wrong;\n"
    "4 the state became non-finite or absurd; 5 a file cannot be read or written; 6 bad checkpoint; 70 a bug in "
    "Riprap;\n"
    "128 + n stopped by signal n after writing a checkpoint.";

using Action = std::function<int()>;

void add_version(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("version", "Print the version and how it was built");
    auto as_json = std::make_shared<bool>(false);
    command->add_flag("--json", *as_json, "As JSON");
    command->callback([&action, as_json] { action = [as_json] { return print_version(*as_json); }; });
}

}  // namespace

int command_line(int argument_count, char** arguments) {
    CLI::App app("Riprap: discrete solid blocks in and under water", "riprap");
    app.require_subcommand(1);
    app.footer(exit_code_help);
    Action action;
    add_version(app, action);
    try {
        app.parse(argument_count, arguments);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? static_cast<int>(ExitCode::success) : static_cast<int>(ExitCode::usage);
    }
    return action();
}

}  // namespace riprap
