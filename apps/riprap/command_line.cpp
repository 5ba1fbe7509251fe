// SPDX-License-Identifier: Apache-2.0
#include "command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <utility>

#include "commands.hpp"
#include "riprap/bench/bench.hpp"
#include "riprap/core/error.hpp"
#include "riprap/run/find_case.hpp"
#include "riprap/run/provenance.hpp"
#include "riprap/run/run_case.hpp"
#include "riprap/scene/key_text.hpp"
#include "riprap/scene/suggest.hpp"
#include "riprap/validation/validate.hpp"
#include "riprap/view/render.hpp"
#include "riprap/view/wave_report.hpp"

namespace riprap {

namespace {

constexpr const char* exit_code_help =
    "Exit codes:\n"
    "  0    success\n"
    "  1    an expected answer was missed\n"
    "  2    bad command line\n"
    "  3    the case or an input file is wrong\n"
    "  4    the state became non-finite or absurd\n"
    "  5    a file cannot be read or written\n"
    "  6    a checkpoint is truncated, damaged or of another case\n"
    "  70   a bug in Riprap\n"
    "  128+n  stopped by signal n, after writing a checkpoint";

constexpr const char* case_help = "A case file, a folder with a case.toml, or a name from `riprap list`";
constexpr int max_threads = 1024;

using Action = std::function<int()>;

/// For commands that only print: a reader that has seen enough (`| head`) ends them without a word, as it does others.
void end_with_reader() { std::signal(SIGPIPE, SIG_DFL); }

void add_run(CLI::App& app, Action& action) {
    auto options = std::make_shared<run::RunOptions>();
    auto out = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("run", "Run a case into a folder");
    command->add_option("CASE", options->case_path, case_help)->required();
    command->add_option("--out", *out, "The run folder (default: runs/NAME)");
    command->add_option("--threads", options->threads, "Threads (default: all)")->check(CLI::Range(1, max_threads));
    command->add_option("--set", options->overrides, "Replace a key of the case: --set end=2 --set solid.skin=0.2")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    struct Limits {
        std::optional<std::string> end, max_steps;
    };
    auto limits = std::make_shared<Limits>();
    command->add_option("--end", limits->end, "Run to this time instead, as --set end=T does [s]")->type_name("T");
    command->add_option("--max-steps", limits->max_steps, "Stop after this many steps, as --set max_steps=N does")
        ->type_name("N");
    CLI::Option* resume = command->add_flag("--resume", options->resume, "Continue the run in the folder, if any");
    command->add_flag("--force", options->force, "Replace the run in the folder, if any")->excludes(resume);
    command->add_flag("--quiet", options->quiet, "Print verdicts and errors only");
    command->callback([&action, options, limits, out] {
        for (const auto& [key, value] : {std::pair("end=", limits->end), std::pair("max_steps=", limits->max_steps)}) {
            if (value) {
                options->overrides.push_back(key + *value);
            }
        }
        action = [options, out] {
            const std::filesystem::path file = run::find_case(options->case_path);
            options->case_path = file.string();
            options->out =
                out->empty() ? std::filesystem::path("runs") / run::short_name(file) : std::filesystem::path(*out);
            return run::run_case(*options);
        };
    });
}

void add_resume(CLI::App& app, Action& action) {
    auto options = std::make_shared<run::ResumeOptions>();
    CLI::App* command = app.add_subcommand("resume", "Continue a run from its last checkpoint");
    command->add_option("DIR", options->folder, "The run folder")->required();
    command->add_option("--threads", options->threads, "Threads (default: all)")->check(CLI::Range(1, max_threads));
    command->add_option("--end", options->end, "Run to this time instead [s]")->check(CLI::PositiveNumber);
    command->add_option("--max-steps", options->max_steps, "Stop after this many steps in all; -1 = no limit");
    command->add_flag("--quiet", options->quiet, "Print verdicts and errors only");
    command->callback([&action, options] { action = [options] { return run::resume_run(*options); }; });
}

void add_check(CLI::App& app, Action& action) {
    struct Options {
        std::string case_text;
        std::vector<std::string> overrides;
        bool as_json{false};
    };
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "check", "Read a case, report every problem, and predict time step, steps, memory and output");
    command->add_option("CASE", options->case_text, case_help)->required();
    command->add_option("--set", options->overrides, "Replace a key of the case")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command->add_flag("--json", options->as_json, "As JSON");
    command->callback([&action, options] {
        action = [options] {
            end_with_reader();
            return print_check(options->case_text, options->overrides, options->as_json);
        };
    });
}

void add_validate(CLI::App& app, Action& action) {
    auto options = std::make_shared<validation::ValidateOptions>();
    CLI::App* command = app.add_subcommand("validate", "Run validation suites and compare with published answers");
    command->add_option("SUITE[/CASE]", options->selection, "What to run (default: every suite)");
    command->add_flag("--full", options->is_full, "Also long cases, and every case in its long version");
    command->add_flag("--json", options->as_json, "As JSON");
    command->add_option("--results", options->results, "Folder for plots (default: validation-results)");
    auto report = std::make_shared<std::string>();
    command->add_option("--report", *report, "Write one page with every result and plot into this folder");
    auto threads = std::make_shared<int>(0);
    command->add_option("--threads", *threads, "Threads (default: all)")->check(CLI::Range(1, max_threads));
    command->callback([&action, options, threads, report] {
        action = [options, threads, report] {
            run::use_threads(*threads);
            return report->empty() ? validation::validate_main(*options) : validate_with_report(*options, *report);
        };
    });
}

/// What the file is called says what is written into it; other names would lie.
void require_extension(const std::filesystem::path& file, std::initializer_list<const char*> allowed) {
    if (file.empty() || std::find(allowed.begin(), allowed.end(), file.extension()) != allowed.end()) {
        return;
    }
    std::string names;
    for (const char* extension : allowed) {
        names += fmt::format("{}{}", names.empty() ? "" : " or ", extension);
    }
    throw CLI::ValidationError("--out", fmt::format("'{}' must end in {}", file.string(), names));
}

void add_view(CLI::App& app, Action& action) {
    auto options = std::make_shared<ViewOptions>();
    CLI::App* command = app.add_subcommand("view", "Write one page that shows a run in a browser, offline");
    command->add_option("RUN", options->folder, "The run folder")->required();
    CLI::Option* out = command->add_option("--out", options->out, "The page (default: RUN/index.html)");
    CLI::Option* serve = command->add_flag("--serve", options->is_served,
                                           "Show it to browsers on this machine instead of writing it, until Ctrl-C");
    serve->excludes(out);
    command->add_option("--port", options->port, "With --serve (default: a free one)")
        ->check(CLI::Range(1, 65535))
        ->needs(serve);
    command->add_option("--budget", options->budget_mb, "Size of the page [MB]; water is rounded to fit (default: 60)")
        ->check(CLI::Range(1.0, 2000.0));
    command->callback([&action, options] {
        require_extension(options->out, {".html"});
        action = [options] { return view_run(*options); };
    });
}

void read_size(const std::string& text, view::RenderOptions& options) {
    int end = 0;
    if (std::sscanf(text.c_str(), "%5dx%5d%n", &options.width, &options.height, &end) != 2 ||
        static_cast<std::size_t>(end) != text.size() || options.width < 64 || options.height < 64 ||
        options.width > 8192 || options.height > 8192) {
        throw CLI::ValidationError("--size", "WIDTHxHEIGHT in pixels, 64 to 8192 each, such as 1280x720");
    }
}

void add_render(CLI::App& app, Action& action) {
    auto options = std::make_shared<view::RenderOptions>();
    CLI::App* command = app.add_subcommand("render", "Draw a picture or a movie of a run, with Chromium");
    command->add_option("RUN", options->folder, "The run folder")->required();
    command->add_option("--out", options->out,
                        "The picture, PNG, or the movie, MP4 (default: RUN/picture.png or RUN/movie.mp4)");
    CLI::Option* frame = command->add_option("--frame", options->frame, "From 0; -1 is the last (default)");
    CLI::Option* time = command->add_option("--time", options->time, "The frame nearest to this time [s]");
    frame->excludes(time);
    command->add_flag("--movie", options->is_movie, "All frames, as MP4 where ffmpeg is installed, else as pictures")
        ->excludes(frame)
        ->excludes(time);
    command->add_option_function<std::string>(
        "--size", [options](const std::string& text) { read_size(text, *options); }, "WIDTHxHEIGHT [pixels]");
    command->add_option("--camera", options->camera, "Where from")
        ->check(CLI::IsMember({"corner", "front", "side", "top"}));
    command->add_option("--water", options->water, "Colour of the water")
        ->check(CLI::IsMember({"pressure", "speed", "none"}));
    command->add_option("--blocks", options->blocks, "Colour of the blocks")
        ->check(CLI::IsMember({"material", "speed", "displacement", "force"}));
    command->add_flag("--contacts", options->shows_contacts, "Draw contact forces");
    command->add_flag("--page", options->shows_page, "The whole page, with its plots");
    command->add_option("--theme", options->theme, "light or dark")->check(CLI::IsMember({"light", "dark"}));
    command->callback([&action, options] {
        require_extension(options->out, {options->is_movie ? ".mp4" : ".png"});
        action = [options] { return print_render(*options); };
    });
}

void add_plot(CLI::App& app, Action& action) {
    auto options = std::make_shared<PlotOptions>();
    CLI::App* command = app.add_subcommand("plot", "Draw curves over time from the tables of a run");
    command->add_option("RUN", options->folder, "The run folder")->required();
    command
        ->add_option(
            "--column", options->columns,
            "Of probes.csv or ledger.csv: kinetic_energy, B1.position.x; once for each (default: gauges and bodies, "
            "else energies)")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command->add_option("--out", options->out, "The plot, SVG or PNG (default: RUN/plot.svg)");
    command->callback([&action, options] {
        require_extension(options->out, {".svg", ".png"});
        action = [options] { return plot_run(*options); };
    });
}

void add_waves(CLI::App& app, Action& action) {
    auto request = std::make_shared<view::WaveRequest>();
    auto folder = std::make_shared<std::filesystem::path>();
    auto as_json = std::make_shared<bool>(false);
    CLI::App* command =
        app.add_subcommand("waves", "Heights and periods of the waves at the gauges of a run, and reflection");
    command->add_option("RUN", *folder, "The run folder")->required();
    command->add_option("--gauge", request->gauges, "Of kind level or surface; once for each (default: all)")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command->add_option("--from", request->from, "Start of the stretch looked at [s] (default: half of the record)");
    command->add_option("--to", request->to, "End of it [s] (default: of the record)");
    command->add_option("--period", request->period,
                        "Of the regular wave to take apart [s] (default: the wave maker's)");
    command->add_option("--depth", request->depth, "Of still water [m] (default: the wave maker's)");
    auto way = std::make_shared<std::vector<double>>();
    command->add_option("--direction", *way, "Of the waves: X,Y or X,Y,Z (default: the wave maker's, or +x)")
        ->delimiter(',')
        ->expected(2, 3)
        ->type_name("VECTOR");
    command->add_flag("--json", *as_json, "As JSON");
    command->callback([&action, folder, request, as_json, way] {
        if (!way->empty()) {
            request->direction = Vec3{way->at(0), way->at(1), way->size() > 2 ? way->at(2) : 0};
        }
        action = [folder, request, as_json] {
            end_with_reader();
            return print_waves(*folder, *request, *as_json);
        };
    });
}

void add_list(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("list", "List the cases and validation suites found");
    auto as_json = std::make_shared<bool>(false);
    command->add_flag("--json", *as_json, "As JSON");
    command->callback([&action, as_json] {
        action = [as_json] {
            end_with_reader();
            return print_list(*as_json);
        };
    });
}

void add_schema(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("schema", "Print the JSON Schema of the case file");
    auto as_keys = std::make_shared<bool>(false);
    command->add_flag("--keys", *as_keys, "Print the keys as a list for reading instead");
    command->callback([&action, as_keys] {
        action = [as_keys] {
            end_with_reader();
            fmt::print("{}\n", *as_keys ? scene::key_listing() : scene::case_schema());
            return 0;
        };
    });
}

void add_bench(CLI::App& app, Action& action) {
    auto options = std::make_shared<bench::BenchOptions>();
    CLI::App* command = app.add_subcommand("bench", "Measure the machine and how fast Riprap is on it");
    command->add_option("NAME", options->selection, "Benches, or how their names begin: contact, pile.10k");
    command->add_flag("--full", options->is_full, "Also those that take minutes");
    command->add_flag("--json", options->as_json, "As JSON");
    command->add_option("--threads", options->threads, "Measure with 1 and so many threads (default: all)")
        ->check(CLI::Range(1, max_threads));
    command->callback([&action, options] { action = [options] { return bench::bench_main(*options); }; });
}

void add_version(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("version", "Print the version and how it was built");
    auto as_json = std::make_shared<bool>(false);
    command->add_flag("--json", *as_json, "As JSON");
    command->callback([&action, as_json] {
        action = [as_json] {
            end_with_reader();
            return print_version(*as_json);
        };
    });
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
    const std::string meant = scene::nearest(word, known);
    return meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant);
}

/// What is wrong with the first word that no command and no option bears; empty where all are known.
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
    }
    for (std::size_t i = first; i < words.size() && words[i] != "--"; ++i) {
        const std::string option = words[i].substr(0, words[i].find('='));
        if (option.rfind("--", 0) == 0 && std::find(options.begin(), options.end(), option) == options.end()) {
            return fmt::format("`{}` has no option '{}'{}",
                               command == &app ? "riprap" : "riprap " + command->get_name(), option,
                               did_you_mean(option, options));
        }
    }
    return {};
}

int refuse(const CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& words) {
    if (const std::string unknown = unknown_word(app, words); !unknown.empty()) {
        fmt::print(stderr, "riprap: {}\nRun with --help for more information.\n", unknown);
    } else {
        app.exit(error);
    }
    return static_cast<int>(ExitCode::usage);
}

}  // namespace

int command_line(int argument_count, char** arguments) {
    CLI::App app("Riprap: discrete solid blocks in and under water", "riprap");
    app.require_subcommand(1);
    app.set_version_flag("--version", "riprap " + run::build_info().version, "Print the version and exit");
    app.footer(exit_code_help);
    Action action;
    add_run(app, action);
    add_check(app, action);
    add_resume(app, action);
    add_validate(app, action);
    add_view(app, action);
    add_render(app, action);
    add_plot(app, action);
    add_waves(app, action);
    add_list(app, action);
    add_schema(app, action);
    add_bench(app, action);
    add_version(app, action);
    try {
        app.parse(argument_count, arguments);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) {
            return refuse(app, error, {arguments + 1, arguments + argument_count});
        }
        end_with_reader();
        app.exit(error);  // prints the help or the version that was asked for
        return static_cast<int>(ExitCode::success);
    }
    return action();
}

}  // namespace riprap
