// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/bench.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "riprap/bench/machine.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/run/folder/provenance.hpp"

namespace riprap::bench {

namespace {

/// "pile" selects pile.1k, and "pile.10k.memory" the bench that gives that result; "pile.1" selects nothing new.
bool is_within(std::string_view name, std::string_view family) {
    return name == family || (name.size() > family.size() && name.starts_with(family) && name[family.size()] == '.');
}

bool is_named(const Bench& bench, std::string_view word) {
    return bench.name.starts_with(word) || is_within(word, bench.name);
}

std::vector<const Bench*> select(const BenchOptions& options, std::span<const Bench> benches) {
    std::vector<const Bench*> selected;
    for (const Bench& bench : benches) {
        const auto& words = options.selection;
        const bool is_wanted =
            words.empty() || std::ranges::any_of(words, [&](const std::string& word) { return is_named(bench, word); });
        const bool is_exact =
            std::ranges::any_of(words, [&](const std::string& word) { return is_within(word, bench.name); });
        if (is_wanted && (!bench.is_long || options.is_full || is_exact)) {
            selected.push_back(&bench);
        }
    }
    return selected;
}

/// Words that select nothing; not an error of the bench but of the command line.
std::string unknown_words(const BenchOptions& options, std::span<const Bench> benches) {
    std::string text;
    for (const std::string& word : options.selection) {
        if (std::ranges::none_of(benches, [&](const Bench& bench) { return is_named(bench, word); })) {
            text += fmt::format("no bench is called {} or begins so\n", word);
        }
    }
    if (!text.empty()) {
        text += "there are:\n";
        for (const Bench& bench : benches) {
            text += fmt::format("  {:<22}{}{}\n", bench.name, bench.title, bench.is_long ? " (with --full)" : "");
        }
    }
    return text;
}

std::vector<int> thread_counts(int asked) {
    const int most = asked > 0 ? asked : std::max(1, run::machine_info().hardware_threads);
    return most > 1 ? std::vector<int>{1, most} : std::vector<int>{1};
}

}  // namespace

int run_benches(const BenchOptions& options, std::span<const Bench> benches,
                MachineLimits (*measure)(const std::vector<int>&), std::ostream& out, std::ostream* progress) {
    if (const std::string unknown = unknown_words(options, benches); !unknown.empty()) {
        (progress != nullptr ? *progress : out) << unknown;
        return static_cast<int>(ExitCode::usage);
    }
    Setting setting{.thread_counts = thread_counts(options.threads)};
    if (progress != nullptr) {
        *progress << "measuring the machine ..." << std::endl;
    }
    setting.machine = measure(setting.thread_counts);
    std::vector<Result> results;
    for (const Bench* bench : select(options, benches)) {
        if (progress != nullptr) {
            *progress << bench->name << " ..." << std::flush;
        }
        const Timer timer;
        bench->run(setting, results);
        if (progress != nullptr) {
            *progress << fmt::format(" {:.1f} s", timer.seconds()) << std::endl;
        }
    }
    out << (options.as_json ? to_json(setting.machine, results) : to_table(setting.machine, results));
    return static_cast<int>(ExitCode::success);
}

int bench_main(const BenchOptions& options) {
    return run_benches(options, all_benches(), measure_machine, std::cout,
                       isatty(STDERR_FILENO) != 0 ? &std::cerr : nullptr);
}

}  // namespace riprap::bench
