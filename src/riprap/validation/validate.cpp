// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <memory>

#include "riprap/core/error.hpp"
#include "riprap/core/printable.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/scene/text/suggest.hpp"
#include "riprap/validation/case_files.hpp"
#include "riprap/validation/cross/scene.hpp"
#include "riprap/validation/cross/table.hpp"

namespace riprap::validation {

namespace {

std::string full_name(const ValidationCase& one) { return fmt::format("{}/{}", one.suite, one.name); }

bool has_wanted_suite(const ValidationCase& one, const ValidateOptions& options) {
    return options.selection.empty() ||
           std::find(options.selection.begin(), options.selection.end(), one.suite) != options.selection.end();
}

bool is_selected(const ValidationCase& one, const ValidateOptions& options) {
    const auto names = [&one](const std::string& text) { return text == full_name(one); };
    if (std::any_of(options.selection.begin(), options.selection.end(), names)) {
        return true;  // by its own name: long or not
    }
    return has_wanted_suite(one, options) && (options.is_full || !one.is_long);
}

/// Returns the advice on an unknown name: the nearest one, and the cases of its suite, or all where it has none.
std::string refusal_of(const std::string& text, std::span<const ValidationCase> cases) {
    std::vector<std::string> names;
    for (const ValidationCase& one : cases) {
        names.push_back(full_name(one));
        names.emplace_back(one.suite);
    }
    const std::string meant = scene::nearest(text, names);
    const std::string suite = meant.empty() ? text.substr(0, text.find('/')) : meant.substr(0, meant.find('/'));
    const bool is_suite = std::find(names.begin(), names.end(), suite) != names.end();
    std::string answer = fmt::format("no suite or case of validation is called '{}'", printable(text));
    answer += meant.empty() ? "" : fmt::format("; did you mean '{}'?", meant);
    answer += is_suite ? fmt::format("\nof the suite {} there are:\n", suite) : "\nthere are:\n";
    for (const ValidationCase& one : cases) {
        if (!is_suite || one.suite == suite) {
            answer += fmt::format("  {:<28} {}{}\n", full_name(one), one.title, one.is_long ? " (long)" : "");
        }
    }
    return answer;
}

/// Names of the selection that no suite and no case bears.
std::vector<std::string> unknown_names(const ValidateOptions& options, std::span<const ValidationCase> cases) {
    std::vector<std::string> unknown;
    for (const std::string& text : options.selection) {
        const auto bears = [&text](const ValidationCase& one) { return text == one.suite || text == full_name(one); };
        if (std::none_of(cases.begin(), cases.end(), bears)) {
            unknown.push_back(text);
        }
    }
    return unknown;
}

/// Says now and then how far a case is.
AfterStep teller(std::ostream& progress, double interval) {
    struct Told {
        Timer timer;
        double last{0};
        double time{0};
        int simulation{1};
    };
    // shared by all simulations of the case, whose number is told from the second on
    return [&progress, interval, told = std::make_shared<Told>()](double time, double end) {
        told->simulation += time < told->time ? 1 : 0;
        told->time = time;
        if (told->timer.seconds() - told->last >= interval) {
            told->last = told->timer.seconds();
            const std::string which = told->simulation > 1 ? fmt::format("simulation {}, ", told->simulation) : "";
            progress << fmt::format("  {}t = {:.4g} s of at most {:.4g} s after {:.0f} min\n", which, time, end,
                                    told->last / 60)
                     << std::flush;
        }
    };
}

/// The results of a case; of a scene that is run with every method its cells as well.
std::vector<Result> run_one(const ValidationCase& one, const ValidateOptions& options, std::ostream* progress,
                            std::vector<cross::Cell>& cells) {
    CaseReport report{std::string(one.name)};
    CaseSetting setting;
    setting.folder = case_folder(options) / one.suite / one.name;
    setting.results = options.results.empty() ? "" : std::filesystem::path(options.results) / one.suite;
    setting.is_full = options.is_full;
    setting.is_still = options.is_still;
    setting.after_step = progress != nullptr ? teller(*progress, options.tell_every) : AfterStep{};
    const Timer timer;
    std::vector<Result> results;
    const std::size_t first = cells.size();
    try {
        if (one.suite == cross::suite && setting.is_still) {
            run_case_file(setting, report);  // whose answers need no method
        } else if (one.suite == cross::suite) {
            cross::run_scene(setting, cells);
        } else {
            one.run(setting, report);
        }
        if (report.results().empty() && cells.size() == first) {
            report.fail("the case compared nothing");
        }
    } catch (const std::exception& error) {
        report.fail(error.what());
    }
    report.set_seconds(timer.seconds());
    for (std::size_t i = first; i < cells.size(); ++i) {
        results.push_back(cross::result_of(cells[i]));
        results.back().seconds = timer.seconds();
    }
    results.insert(results.end(), report.results().begin(), report.results().end());
    return results;
}

}  // namespace

std::filesystem::path case_folder(const ValidateOptions& options) {
    if (!options.folder.empty()) {
        return options.folder;
    }
    std::error_code ignored;
    return std::filesystem::is_directory("validation", ignored) ? "validation" : RIPRAP_VALIDATION_FOLDER;
}

int validate(const ValidateOptions& options, std::span<const ValidationCase> cases, std::ostream& out,
             std::ostream* progress) {
    if (const std::vector<std::string> unknown = unknown_names(options, cases); !unknown.empty()) {
        std::cerr << refusal_of(unknown.front(), cases);
        return static_cast<int>(ExitCode::usage);
    }
    std::vector<std::string_view> suites;
    for (const ValidationCase& one : cases) {
        if (is_selected(one, options) && std::find(suites.begin(), suites.end(), one.suite) == suites.end()) {
            suites.push_back(one.suite);
        }
    }
    std::vector<Result> all_results;
    std::vector<cross::Cell> cells;
    // One JSON document, whatever was asked for: with several suites a case carries the name of its own.
    const bool names_suites = suites.size() > 1;
    const auto json = [&] {
        std::string document = to_json(names_suites ? "all" : suites.front(), all_results, options.is_full);
        return cells.empty() ? document : cross::with_cells(document, cells);
    };
    for (const std::string_view suite : suites) {
        std::vector<Result> results;
        for (const ValidationCase& one : cases) {
            if (one.suite != suite || !is_selected(one, options)) {
                continue;
            }
            if (progress != nullptr) {
                *progress << fmt::format("{}: {}\n", full_name(one), one.title) << std::flush;
            }
            for (Result result : run_one(one, options, progress, cells)) {
                results.push_back(result);
                result.name = names_suites ? fmt::format("{}/{}", suite, result.name) : result.name;
                all_results.push_back(std::move(result));
            }
            if (options.after_case) {
                options.after_case(json());
            }
        }
        if (!options.as_json) {
            out << (suite == cross::suite && !options.is_still ? cross::table_of(cells) : to_table(suite, results));
            for (const ValidationCase& one : cases) {
                if (one.suite == suite && has_wanted_suite(one, options) && !is_selected(one, options)) {
                    out << fmt::format("not run, as it is long: {}; by its name, or with --full\n", full_name(one));
                }
            }
            out << std::flush;
        }
    }
    if (options.as_json) {
        out << (suites.empty() ? to_json("all", {}, options.is_full) : json()) << std::flush;
    }
    const bool has_failed = std::any_of(all_results.begin(), all_results.end(),
                                        [](const Result& result) { return result.verdict == Verdict::not_reproduced; });
    return static_cast<int>(has_failed ? ExitCode::failed : ExitCode::success);
}

int validate_main(const ValidateOptions& options) {
    return validate(options, all_cases(), std::cout, options.as_json ? nullptr : &std::cerr);
}

}  // namespace riprap::validation
