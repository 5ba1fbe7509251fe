// SPDX-License-Identifier: Apache-2.0
// Texts made from the commands themselves: completion for shells and manual pages.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "command_line_parts.hpp"
#include "riprap/run/folder/provenance.hpp"

namespace riprap {

namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> options_of(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back(fmt::format("--{}", name));
        }
    }
    return names;
}

/// Tells whether the first word after a command is a case; else it is a run folder or another path.
bool takes_case(const CLI::App& command) {
    const std::vector<const CLI::Option*> options = command.get_options();
    return std::any_of(options.begin(), options.end(),
                       [](const CLI::Option* option) { return option->get_name() == "CASE"; });
}

std::string single_quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        result += c == '\'' ? "'\\''" : std::string(1, c);
    }
    result += '\'';
    return result;
}

std::string bash_script(const CLI::App& app) {
    std::string names, branches;
    for (const CLI::App* command : commands_of(app)) {
        names += fmt::format(" {}", command->get_name());
        branches +=
            fmt::format("        {}) words=\"{}{}\" ;;\n", command->get_name(), fmt::join(options_of(*command), " "),
                        takes_case(*command) ? " $(riprap list --names 2>/dev/null)" : "");
    }
    return fmt::format(
        "# Completion of riprap for bash: source <(riprap completion bash)\n"
        "_riprap() {{\n"
        "    local word=\"${{COMP_WORDS[COMP_CWORD]}}\" words\n"
        "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
        "        COMPREPLY=($(compgen -W \"{} --help --version\" -- \"$word\"))\n"
        "        return\n"
        "    fi\n"
        "    case \"${{COMP_WORDS[1]}}\" in\n{}        *) words=\"\" ;;\n"
        "    esac\n"
        "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\") $(compgen -f -- \"$word\"))\n"
        "}}\n"
        "complete -o filenames -F _riprap riprap\n",
        names.substr(1), branches);
}

/// One line of a description, as zsh and fish show it.
std::string brief(const std::string& text) { return text.substr(0, text.find('\n')); }

std::string zsh_script(const CLI::App& app) {
    std::string names, branches;
    for (const CLI::App* command : commands_of(app)) {
        names +=
            fmt::format("        {}\n",
                        single_quoted(fmt::format("{}:{}", command->get_name(), brief(command->get_description()))));
        std::string options;
        for (const CLI::Option* option : command->get_options()) {
            for (const std::string& name : option->get_lnames()) {
                std::string help = brief(option->get_description());
                std::replace_if(
                    help.begin(), help.end(), [](char c) { return c == '[' || c == ']' || c == ':'; }, ' ');
                options += fmt::format(" {}", single_quoted(fmt::format("--{}[{}]", name, help)));
            }
        }
        branches += fmt::format("        {}) _arguments{} '*:file:{}' ;;\n", command->get_name(), options,
                                takes_case(*command) ? "_riprap_cases" : "_files");
    }
    return fmt::format(
        "#compdef riprap\n"
        "# Completion of riprap for zsh: riprap completion zsh > ~/.zfunc/_riprap\n"
        "_riprap_cases() {{ compadd $(riprap list --names 2>/dev/null); _files }}\n"
        "_riprap() {{\n"
        "    local -a commands\n"
        "    commands=(\n{}    )\n"
        "    if (( CURRENT == 2 )); then _describe command commands; return; fi\n"
        "    local command=${{words[2]}}\n"
        "    shift words; (( CURRENT-- ))\n"
        "    case $command in\n{}    esac\n"
        "}}\n"
        "_riprap \"$@\"\n",
        names, branches);
}

std::string fish_script(const CLI::App& app) {
    std::string text =
        "# Completion of riprap for fish: riprap completion fish > ~/.config/fish/completions/riprap.fish\n";
    for (const CLI::App* command : commands_of(app)) {
        text += fmt::format("complete -c riprap -n __fish_use_subcommand -f -a {} -d {}\n", command->get_name(),
                            single_quoted(brief(command->get_description())));
        const std::string when =
            fmt::format("complete -c riprap -n '__fish_seen_subcommand_from {}'", command->get_name());
        if (takes_case(*command)) {
            text += fmt::format("{} -a '(riprap list --names 2>/dev/null)'\n", when);
        }
        for (const CLI::Option* option : command->get_options()) {
            for (const std::string& name : option->get_lnames()) {
                text += fmt::format("{} -l {} -d {}\n", when, name, single_quoted(brief(option->get_description())));
            }
        }
    }
    return text;
}

/// Escapes a text for a manual page, so that no line is a request and no hyphen of an option becomes a dash.
std::string roff(const std::string& text) {
    std::string result;
    bool is_start = true;
    for (const char c : text) {
        if (is_start && (c == '.' || c == '\'')) {
            result += "\\&";
        }
        result += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
        is_start = c == '\n';
    }
    return result;
}

std::string man_of(const CLI::App& app, const CLI::App& command) {
    const bool is_whole = &command == &app;
    const std::string name = is_whole ? "riprap" : fmt::format("riprap-{}", command.get_name());
    std::string text =
        fmt::format(".TH \"{}\" 1 \"\" \"Riprap {}\" \"User commands\"\n.SH NAME\n{} \\- {}\n", roff(name),
                    roff(run::build_info().version), roff(name), roff(brief(command.get_description())));
    text += fmt::format(".SH SYNOPSIS\n.B riprap {}", is_whole ? "COMMAND" : roff(command.get_name()));
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_positional()) {
            text += fmt::format(fmt::runtime(option->get_required() ? " {}" : " [{}]"), roff(option->get_name()));
        }
    }
    text += " [options]\n";
    if (is_whole) {
        text += ".SH COMMANDS\n";
        for (const CLI::App* one : commands_of(app)) {
            text += fmt::format(".TP\n.B {}\n{}\n", roff(one->get_name()), roff(one->get_description()));
        }
    }
    text += ".SH OPTIONS\n";
    for (const CLI::Option* option : command.get_options()) {
        const std::string type = option->get_type_size() > 0 ? option->get_type_name() : "";
        text += fmt::format(".TP\n.B {}{}\n{}\n", roff(option->get_name(false, true)),
                            type.empty() ? "" : fmt::format(" {}", roff(type)), roff(option->get_description()));
    }
    if (!command.get_footer().empty()) {
        text += fmt::format(".SH NOTES\n.nf\n{}\n.fi\n", roff(command.get_footer()));
    }
    return text;
}

}  // namespace

void add_completion(CLI::App& app, Action& action) {
    auto shell = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("completion", "Print what makes a shell complete the words of riprap");
    command->add_option("SHELL", *shell, "bash, zsh or fish")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
    command->footer("Example:\n  source <(riprap completion bash)");
    command->callback([&app, &action, shell] {
        action = [&app, shell] {
            end_with_reader();
            fmt::print("{}", *shell == "bash"  ? bash_script(app)
                             : *shell == "zsh" ? zsh_script(app)
                                               : fish_script(app));
            return 0;
        };
    });
}

void add_man(CLI::App& app, Action& action) {
    auto topic = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("man", "Print the manual page of riprap or of one command");
    command->add_option("COMMAND", *topic, "The command (default: riprap itself)");
    command->footer("Example:\n  riprap man run | man -l -");
    command->callback([&app, &action, topic] {
        const CLI::App* page = &app;
        for (const CLI::App* one : commands_of(app)) {
            page = one->get_name() == *topic ? one : page;
        }
        if (page == &app && !topic->empty()) {
            throw CLI::ValidationError("COMMAND", fmt::format("there is no command '{}'", *topic));
        }
        action = [&app, page] {
            end_with_reader();
            fmt::print("{}", man_of(app, *page));
            return 0;
        };
    });
}

}  // namespace riprap
