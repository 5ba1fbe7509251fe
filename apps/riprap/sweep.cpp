// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/sweep.hpp"

#include <fmt/format.h>

#include <memory>

#include "command_line_parts.hpp"
#include "riprap/io/atomic_file.hpp"
#include "riprap/run/find_case.hpp"
#include "riprap/view/sweep_page.hpp"

namespace riprap {

namespace {

struct SweepWords {
    std::string case_text, out, list;
    std::vector<std::string> vary, overrides;
    int jobs{0}, threads{1};
    bool is_quiet{false};
};

int sweep(const SweepWords& words) {
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
    options.out = words.out.empty() ? std::filesystem::path("runs") / (run::short_name(file) + "_sweep")
                                    : std::filesystem::path(words.out);
    options.jobs = words.jobs;
    options.threads = words.threads;
    options.quiet = words.is_quiet;
    const int code = run::run_sweep(options);
    fmt::print("{}\n", view::write_sweep_page(options.out).string());
    return code;
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
        "index.html. Repeat the command to resume unfinished runs.");
    command
        ->add_option("CASE", words->case_text, "A case file, a folder with a case.toml, or a name from `riprap list`")
        ->required();
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
    command->callback([&action, words] {
        if (words->vary.empty() && words->list.empty()) {
            throw CLI::RequiredError("--vary or --list");
        }
        action = [words] { return sweep(*words); };
    });
}

}  // namespace riprap
