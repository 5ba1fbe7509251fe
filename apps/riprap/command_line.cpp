// SPDX-License-Identifier: Apache-2.0
#include "command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "command_line_parts.hpp"
#include "commands.hpp"
#include "riprap/bench/bench.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/run/again/stored_run.hpp"
#include "riprap/run/drive/find_case.hpp"
#include "riprap/run/drive/run_case.hpp"
#include "riprap/run/ensemble/ensemble.hpp"
#include "riprap/run/folder/provenance.hpp"
#include "riprap/run/study/sweep_processes.hpp"
#include "riprap/scene/keys/key_text.hpp"
#include "riprap/validation/validate.hpp"
#include "slurm_options.hpp"

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

/// Runs what is in a run folder again, and says whether the State at its end is the same.
int run_again(const run::StoredRun& stored, run::RunOptions options, const std::string& out) {
    const bool is_changed = !options.overrides.empty();
    options.case_path = stored.case_file.string();
    options.overrides.insert(options.overrides.begin(), stored.overrides.begin(), stored.overrides.end());
    options.out = out.empty() ? std::filesystem::path("runs") / (stored.name + "_again") : std::filesystem::path(out);
    const int code = run::run_case(options);
    if (code > static_cast<int>(ExitCode::failed) || is_changed) {
        return code;
    }
    const run::Comparison found = run::compare(stored, options.out);
    fmt::print(found.is_same ? stdout : stderr, "{}{}\n", found.is_same ? "" : "riprap: ", printable(found.text));
    return found.is_same ? code : static_cast<int>(ExitCode::failed);
}

void add_run(CLI::App& app, Action& action) {
    auto options = std::make_shared<run::RunOptions>();
    auto out = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("run", "Run a case into a folder");
    command->footer(
        "Example:\n  riprap run jointed_slope --end 2 --set material.rock.cohesion=\"1 kPa\" --out runs/trial");
    command->add_option("CASE", options->case_path, std::string(case_help) + ", or a run folder, to run it again")
        ->required();
    command->add_option("--out", *out, "The run folder (default: runs/NAME)");
    command->add_option("--threads", options->threads, "Threads (default: OMP_NUM_THREADS, or else all)")
        ->check(CLI::Range(1, max_threads));
    add_set(*command, options->overrides, "Replace a key of the case: --set end=2 --set solid.skin=0.2");
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
    struct Ensemble {
        std::int64_t members{0};
        int jobs{0};
        SlurmWords slurm;
    };
    auto ensemble = std::make_shared<Ensemble>();
    CLI::Option* members =
        command
            ->add_option("--ensemble", ensemble->members,
                         "Run N members, each with its own values drawn from [[spread]] of the case, and write "
                         "bands.csv and bands.svg; existing members are continued")
            ->type_name("N")
            ->check(CLI::Range(1, 10000));
    command
        ->add_option("--jobs", ensemble->jobs, "With --ensemble: members at a time (default: as many as cores allow)")
        ->check(CLI::Range(1, max_threads))
        ->needs(members);
    add_slurm_options(*command, ensemble->slurm);
    command->get_option("--submit")->needs(members);
    command->callback([&action, options, limits, out, ensemble] {
        require_submit(ensemble->slurm);
        for (const auto& [key, value] : {std::pair("end=", limits->end), std::pair("max_steps=", limits->max_steps)}) {
            if (value) {
                refuse_second_value(options->overrides, key + *value);
                options->overrides.push_back(key + *value);
            }
        }
        action = [options, out, ensemble] {
            if (ensemble->members == 0) {
                if (const std::optional<run::StoredRun> stored = run::stored_run(options->case_path)) {
                    return run_again(*stored, *options, *out);
                }
            }
            const std::filesystem::path file = run::find_case(options->case_path);
            options->case_path = file.string();
            options->out =
                out->empty() ? std::filesystem::path("runs") / run::short_name(file) : std::filesystem::path(*out);
            if (ensemble->members == 0) {
                return run::run_case(*options);
            }
            options->threads = std::max(1, options->threads);  // members side by side use the cores better
            const int usual = ensemble->slurm.submit.empty() ? run::usual_jobs(options->threads) : 0;
            return run_ensemble({*options, ensemble->members, ensemble->jobs > 0 ? ensemble->jobs : usual},
                                ensemble->slurm);
        };
    });
}

void add_resume(CLI::App& app, Action& action) {
    auto options = std::make_shared<run::ResumeOptions>();
    CLI::App* command = app.add_subcommand("resume", "Continue a run from its last checkpoint");
    command->footer("Example:\n  riprap resume runs/jointed_slope --end 12");
    command->add_option("DIR", options->folder, "The run folder")->required();
    command->add_option("--threads", options->threads, "Threads (default: OMP_NUM_THREADS, or else all)")
        ->check(CLI::Range(1, max_threads));
    command->add_option("--end", options->end, "Run to this time instead [s]")->check(CLI::PositiveNumber);
    command->add_option("--max-steps", options->max_steps,
                        "Stop after this many steps, those before the checkpoint included; -1 = no limit");
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
    command->footer("Example:\n  riprap check dam_break_floes --set fluid.spacing=\"3 mm\"");
    command->add_option("CASE", options->case_text, case_help)->required();
    add_set(*command, options->overrides, "Replace a key of the case");
    command->add_flag("--json", options->as_json, "As JSON");
    command->callback([&action, options] {
        action = [options] {
            end_with_reader();
            return print_check(options->case_text, options->overrides, options->as_json);
        };
    });
}

void add_matrix(CLI::App& app, Action& action) {
    auto options = std::make_shared<run::MatrixOptions>();
    CLI::App* command =
        app.add_subcommand("matrix", "Run a case with every solid method and every fluid, and judge it in each");
    command->footer("Example:\n  riprap matrix sliding_block --scales");
    command->add_option("CASE", options->case_path, case_help)->required();
    add_set(*command, options->overrides, "Replace a key of the case");
    command->add_option("--value", options->quantity,
                        "Column to show (default: an answer that is missed, else the first)");
    command->add_flag("--scales", options->has_scales,
                      "Also with the step and the stiffness of the solid method times 1/4 and 4");
    auto as_json = std::make_shared<bool>(false);
    command->add_flag("--json", *as_json, "As JSON");
    auto threads = std::make_shared<int>(0);
    command->add_option("--threads", *threads, "Threads (default: OMP_NUM_THREADS, or else all)")
        ->check(CLI::Range(1, max_threads));
    command->callback([&action, options, as_json, threads] {
        action = [options, as_json, threads] {
            run::use_threads(*threads);
            end_with_reader();
            return print_matrix(*options, *as_json);
        };
    });
}

void add_validate(CLI::App& app, Action& action, const Words& words, const BuiltIn& built_in) {
    auto options = std::make_shared<validation::ValidateOptions>();
    CLI::App* command = app.add_subcommand("validate", "Run validation suites and compare with published answers");
    command->footer("Example:\n  riprap validate rigid water/standing_wave --report report");
    command->add_option("SUITE[/CASE]", options->selection, "What to run (default: every suite)");
    command->add_flag("--full", options->is_full, "Also long cases, and every case in its long version");
    command->add_flag("--still", options->is_still, "Take no step: which answers would hold if nothing moved");
    command->add_flag("--json", options->as_json, "As JSON");
    command->add_option("--results", options->results, "Folder for the runs (default: validation-results)");
    auto report = std::make_shared<std::string>();
    command->add_option("--report", *report, "Write one page with every result into this folder");
    auto threads = std::make_shared<int>(0);
    command->add_option("--threads", *threads, "Threads (default: OMP_NUM_THREADS, or else all)")
        ->check(CLI::Range(1, max_threads));
    command->callback([&action, &words, &built_in, options, threads, report] {
        action = [&words, &built_in, options, threads, report] {
            if (!built_in.validate) {
                return start_program("riprap-validate", words);
            }
            run::use_threads(*threads);
            return built_in.validate(*options, *report);
        };
    });
}

void add_list(CLI::App& app, Action& action, const Words& words, const BuiltIn& built_in) {
    CLI::App* command = app.add_subcommand("list", "List the cases and validation suites found");
    command->footer("Example:\n  riprap list --costs\n  riprap list --published ding figure 7.8");
    auto as_json = std::make_shared<bool>(false), as_names = std::make_shared<bool>(false);
    auto as_costs = std::make_shared<bool>(false), as_published = std::make_shared<bool>(false);
    CLI::Option* json = command->add_flag("--json", *as_json, "As JSON");
    CLI::Option* names = command->add_flag("--names", *as_names, "Names of cases only, one a line")->excludes(json);
    CLI::Option* costs = command
                             ->add_flag("--costs", *as_costs,
                                        "What the run of each case takes on this machine, by some steps of it: a "
                                        "minute in all")
                             ->excludes(names);
    CLI::Option* published =
        command
            ->add_flag("--published", *as_published,
                       "Published experiments and exact answers, each with its source, section and figures")
            ->excludes(names)
            ->excludes(costs);
    auto about = std::make_shared<std::vector<std::string>>();
    command
        ->add_option("WORDS", *about,
                     "Of the published cases those that all words are about: an author, a figure or table of a paper, "
                     "words of the title")
        ->needs(published);
    command->callback([&action, &words, &built_in, as_json, as_names, as_costs, as_published, about] {
        action = [&words, &built_in, as_json, as_names, as_costs, as_published, about] {
            end_with_reader();
            if (*as_published) {
                return print_published(*about, *as_json);
            }
            if (*as_names || *as_costs) {
                return *as_names ? print_case_names() : print_costs(*as_json);
            }
            if (!built_in.published && has_program("riprap-validate")) {
                return start_program("riprap-validate", words);
            }
            return print_list(built_in.published, *as_json);
        };
    });
}

void add_schema(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("schema", "Print the JSON Schema of the case file");
    command->footer("Example:\n  riprap schema > riprap.schema.json");
    auto as_keys = std::make_shared<bool>(false);
    auto as_manual = std::make_shared<bool>(false);
    CLI::Option* keys = command->add_flag("--keys", *as_keys, "Print the keys as a list for reading instead");
    command->add_flag("--manual", *as_manual, "Print docs/reference/case-file.md instead")->excludes(keys);
    command->callback([&action, as_keys, as_manual] {
        action = [as_keys, as_manual] {
            end_with_reader();
            if (*as_manual) {
                fmt::print("{}", scene::case_manual());
                return 0;
            }
            fmt::print("{}\n", *as_keys ? scene::key_listing() : scene::case_schema());
            return 0;
        };
    });
}

void add_bench(CLI::App& app, Action& action, const Words& words, const BuiltIn& built_in) {
    auto options = std::make_shared<bench::BenchOptions>();
    CLI::App* command = app.add_subcommand("bench", "Measure the machine and how fast Riprap is on it");
    command->footer("Example:\n  riprap bench contact step.dam_break");
    command->add_option("NAME", options->selection, "Benches, or how their names begin: contact, pile.10k");
    command->add_flag("--full", options->is_full, "Also those that take minutes");
    command->add_flag("--json", options->as_json, "As JSON");
    command->add_option("--threads", options->threads, "Measure with 1 thread and with this many (default: all)")
        ->check(CLI::Range(1, max_threads));
    command->callback([&action, &words, &built_in, options] {
        action = [&words, &built_in, options] {
            return built_in.bench ? built_in.bench(*options) : start_program("riprap-bench", words);
        };
    });
}

void add_version(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("version", "Print the version and how it was built");
    command->footer("Example:\n  riprap version --json");
    auto as_json = std::make_shared<bool>(false);
    command->add_flag("--json", *as_json, "As JSON");
    command->callback([&action, as_json] {
        action = [as_json] {
            end_with_reader();
            return print_version(*as_json);
        };
    });
}

}  // namespace

void end_with_reader() { std::signal(SIGPIPE, SIG_DFL); }

int command_line(const Words& words, const BuiltIn& built_in) {
    CLI::App app("Riprap: discrete solid blocks in and under water", "riprap");
    app.require_subcommand(1);
    app.set_version_flag("--version", "riprap " + run::build_info().version, "Print the version and exit");
    app.footer(exit_code_help);
    Action action;
    add_run(app, action);
    add_check(app, action);
    add_resume(app, action);
    add_new(app, action);
    add_upgrade(app, action);
    add_sweep(app, action);
    add_fos(app, action);
    add_matrix(app, action);
    add_validate(app, action, words, built_in);
    add_commands_of_runs(app, action);
    add_list(app, action, words, built_in);
    add_schema(app, action);
    add_bench(app, action, words, built_in);
    add_version(app, action);
    add_completion(app, action);
    add_man(app, action);
    if (words.count <= 1) {
        end_with_reader();
        fmt::print("{}", app.help());
        return static_cast<int>(ExitCode::success);
    }
    try {
        app.parse(words.count, words.words);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() != 0) {
            return refuse(app, error, {words.words + 1, words.words + words.count});
        }
        end_with_reader();
        app.exit(error);  // prints the help or the version that was asked for
        return static_cast<int>(ExitCode::success);
    }
    return action();
}

}  // namespace riprap
