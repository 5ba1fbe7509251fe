// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <sstream>

#include "command_line_parts.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/core/tint.hpp"
#include "riprap/scene/text/suggest.hpp"

namespace riprap {

namespace {

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
    const std::string meant = scene::nearest(word, known);
    return meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant);
}

/// Returns the refusal of the first unknown word; empty where all are known.
std::string unknown_word(const CLI::App& app, const std::vector<std::string>& words) {
    if (words.empty() || words.front().empty()) {
        return {};
    }
    const CLI::App* command = &app;
    std::size_t first = 0;
    if (words.front().front() != '-') {
        std::vector<std::string> names;
        for (const CLI::App* one : app.get_subcommands([](const CLI::App*) { return true; })) {
            names.push_back(one->get_name());
            command = one->get_name() == words.front() ? one : command;
        }
        if (command == &app) {
            return fmt::format("there is no command '{}'{}", words.front(), did_you_mean(words.front(), names));
        }
        first = 1;
    }
    std::vector<std::string> options;
    for (const CLI::Option* option : command->get_options()) {
        for (const std::string& name : option->get_lnames()) {
            options.push_back("--" + name);
        }
        for (const std::string& name : option->get_snames()) {
            options.push_back("-" + name);
        }
    }
    for (std::size_t i = first; i < words.size() && words[i] != "--"; ++i) {
        const std::string option = words[i].substr(0, words[i].find('='));
        const bool is_short =
            option.size() == 2 && option[0] == '-' && std::isalpha(static_cast<unsigned char>(option[1])) != 0;
        if ((is_short || option.rfind("--", 0) == 0) &&
            std::find(options.begin(), options.end(), option) == options.end()) {
            return fmt::format("`{}` has no option '{}'{}",
                               command == &app ? "riprap" : "riprap " + command->get_name(), option,
                               did_you_mean(option, options));
        }
    }
    return {};
}

}  // namespace

int refuse(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& words) {
    if (const std::string unknown = unknown_word(app, words); !unknown.empty()) {
        fmt::print(stderr, "{} {}\nRun with --help for more information.\n",
                   tinted("riprap:", Tint::bad, shows_colours(stderr)), printable(unknown));
    } else {
        std::ostringstream out, problem;
        app.exit(error, out, problem);
        fmt::print(stderr, "{}{}", out.str(), printable(problem.str()));
    }
    return static_cast<int>(ExitCode::usage);
}

}  // namespace riprap
