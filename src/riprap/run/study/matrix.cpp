// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/study/matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "riprap/core/error.hpp"
#include "riprap/core/timer.hpp"
#include "riprap/run/simulate/ledger_verdict.hpp"
#include "riprap/run/simulate/simulation.hpp"
#include "riprap/run/study/method_scales.hpp"
#include "riprap/run/study/missing_physics.hpp"
#include "riprap/scene/assemble/complete_solid.hpp"
#include "riprap/scene/keys/methods.hpp"
#include "riprap/scene/text/toml_reader.hpp"

namespace riprap::run {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t steps_between_looks = 16;  // at the clock: a look costs as much as a block's step

bool is_late(const ExpectResult& answer) { return answer.verdict == Verdict::not_judged; }
bool is_judged(const ExpectResult& answer) { return !is_late(answer) && answer.verdict != Verdict::reported; }
bool is_missed(const ExpectResult& answer) { return answer.verdict == Verdict::failed; }

/// Value of a column at the end; the first record where none is named.
void show_column(const Simulation& simulation, const std::string& name, MatrixEntry& entry) {
    const sim::Model& model = simulation.model();
    const std::vector<sim::Column> records = sim::record_columns(model);
    const std::optional<sim::Column> column = !name.empty()     ? sim::find_column(model, name)
                                              : records.empty() ? std::nullopt
                                                                : std::optional(records.front());
    entry.quantity = column ? column->name : name;
    entry.value = column ? sim::evaluate(*column, simulation.now()) : missing;
}

/// Shows the column that is asked for, or else an answer: the first that is missed, else the first. Where the case is
/// ended before an answer is due, its quantity at the end stands for it.
void show(const Simulation& simulation, const std::string& asked, MatrixEntry& entry) {
    const std::vector<ExpectResult>& answers = entry.answers;
    auto shown = std::ranges::find_if(answers, is_missed);
    shown = shown == answers.end() ? answers.begin() : shown;
    if (!asked.empty() || answers.empty() || !std::isfinite(shown->value)) {
        show_column(simulation, !asked.empty() || answers.empty() ? asked : shown->quantity, entry);
        return;
    }
    entry.quantity = fmt::format("{} ({})", shown->quantity, shown->reduce);
    entry.value = shown->value;
}

std::string miss_of(const ExpectResult& answer) {
    return std::isfinite(answer.value)
               ? fmt::format("{}: {:.6g} for {:.6g} to {:.6g}", answer.name, answer.value, answer.low, answer.high)
               : fmt::format("{}: no value", answer.name);
}

void judge(const Simulation& simulation, MatrixEntry& entry) {
    entry.answers = simulation.judge();
    entry.finding = std::ranges::none_of(entry.answers, is_judged)   ? Finding::unjudged
                    : std::ranges::none_of(entry.answers, is_missed) ? Finding::right
                                                                     : Finding::wrong;
    for (const ExpectResult& answer : entry.answers) {
        if (is_missed(answer)) {
            entry.why += (entry.why.empty() ? "" : "; ") + miss_of(answer);
        }
    }
    const auto late = std::ranges::count_if(entry.answers, is_late);
    if (late > 0) {  // where `end` is shorter than that of the file, say
        entry.why += fmt::format("{}{} of {} answers not judged: due after the end at {:.6g} s",
                                 entry.why.empty() ? "" : "; ", late, entry.answers.size(), simulation.end());
    }
}

/// Processor time of this program so far: a busy machine may not turn a run wrong [s].
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Runs a case that was read to its end, and judges it.
void run_to_end(Simulation& simulation, const MatrixOptions& options, MatrixEntry& entry) {
    const Timer timer;
    const double start = processor_seconds();
    const std::int64_t first = simulation.state().step;
    while (simulation.steps_left() > 0 && entry.why.empty()) {
        const StepOutcome outcome =
            simulation.step(simulation.next_is_last() ? sim::Measure::energy : sim::Measure::flow);
        if (outcome.kind == StepOutcome::Kind::refused) {
            entry.why = fmt::format("ended at {:.4g} s: {}", simulation.state().time, outcome.why.with_remedy());
        } else if (simulation.state().step % steps_between_looks == 0 &&
                   processor_seconds() - start > options.most_seconds) {
            entry.why = fmt::format("stopped at {:.4g} s, after {:.0f} s of computing", simulation.state().time,
                                    options.most_seconds);
        }
    }
    entry.seconds = processor_seconds() - start;
    const std::int64_t steps = simulation.state().step - first;
    entry.ns = steps > 0 ? 1e9 * timer.seconds() / static_cast<double>(steps) : 0;
    const sim::Ledger& ledger = simulation.report().ledger;
    entry.residual = missed_share(ledger, steps);
    if (!entry.why.empty()) {
        entry.finding = Finding::wrong;
        return;
    }
    judge(simulation, entry);
    show(simulation, options.quantity, entry);
}

/// The case as it was read, before its keys are checked.
scene::Value tree_of(const MatrixOptions& options, const std::string& text) {
    std::vector<Diagnostic> ignored;
    scene::Value root = scene::parse_toml(text, options.case_path, ignored);
    for (const std::string& assignment : options.overrides) {
        scene::apply_override(root, assignment, ignored);
    }
    return root;
}

/// A case and the runs that it asks for.
struct Asked {
    const MatrixOptions& options;
    scene::Value root;
    std::vector<scene::Variation> variations;  ///< the case as it is first
};

/// A refusal is one for missing physics, or wrong.
void note_refusal(const Asked& asked, const CaseError& error, MatrixEntry& entry) {
    const std::vector<std::string> lacking = missing_physics(asked.root, entry.solid, entry.fluid);
    const Diagnostic& first = error.problems().front();
    entry.finding = lacking.empty() ? Finding::wrong : Finding::refused;
    entry.why = lacking.empty() ? "refused: " + first.message + (first.allowed.empty() ? "" : "; " + first.allowed)
                                : fmt::format("{}", fmt::join(lacking, ", "));
}

/// A case as a method has read it.
struct Resolved {
    std::string toml;
    sim::SolidSettings settings;
};

MatrixEntry run_one(const Asked& asked, const std::string& solid, const std::string& fluid,
                    const scene::Variation& variation, Resolved* resolved) {
    MatrixEntry entry{.solid = solid, .fluid = fluid, .variation = variation.label};
    entry.value = entry.ns = entry.residual = missing;
    std::vector<std::string> overrides = asked.options.overrides;
    overrides.insert(overrides.end(), variation.overrides.begin(), variation.overrides.end());
    overrides.push_back(fmt::format("solid.method=\"{}\"", solid));
    if (fluid != "none") {
        overrides.push_back(fmt::format("fluid.method=\"{}\"", fluid));
    }
    try {
        Simulation simulation(scene::read_case(asked.options.case_path, overrides));
        if (resolved != nullptr) {
            *resolved = {scene::completed_toml(simulation.loaded()), simulation.model().solid};
        }
        run_to_end(simulation, asked.options, entry);
    } catch (const CaseError& error) {
        note_refusal(asked, error, entry);
    } catch (const std::exception& error) {
        entry.finding = Finding::wrong;
        entry.why = fmt::format("stopped: {}", error.what());
    }
    return entry;
}

/// Runs one pair of methods: a pair that lacks the physics is refused once for all runs.
void run_pair(const Asked& asked, const std::string& solid, const std::string& fluid,
              const std::function<void(const MatrixEntry&)>& each, std::vector<MatrixEntry>& entries) {
    std::vector<scene::Variation> variations = asked.variations;
    for (std::size_t i = 0; i < variations.size(); ++i) {
        Resolved resolved;
        entries.push_back(run_one(asked, solid, fluid, variations[i], i == 0 ? &resolved : nullptr));
        if (each) {
            each(entries.back());
        }
        if (i == 0 && resolved.toml.empty()) {
            return;
        }
        if (i == 0 && asked.options.has_scales) {
            for (scene::Variation& scale : method_scales(resolved.toml, solid, resolved.settings)) {
                variations.push_back(std::move(scale));
            }
        }
    }
}

}  // namespace

std::string_view to_string(Finding finding) {
    constexpr std::array<std::string_view, 4> words{"right", "wrong", "refused", "ran"};
    return words[static_cast<std::size_t>(finding)];
}

MatrixResult run_matrix(const MatrixOptions& options, const std::function<void(const MatrixEntry&)>& each) {
    const scene::LoadedCase plain = scene::read_case(options.case_path, options.overrides);
    std::vector<Diagnostic> ignored;
    Asked asked{options, tree_of(options, plain.source_text), {scene::Variation{}}};
    for (scene::Variation& run : variations_of(scene::parse_toml(plain.resolved_toml, "the resolved case", ignored))) {
        if (!run.is_full) {
            asked.variations.push_back(std::move(run));
        }
    }
    std::vector<std::string> fluids;
    if (plain.model.has_fluid()) {
        for (const scene::Method& method : scene::FluidMethods::all()) {
            fluids.emplace_back(method.word);
        }
    } else {
        fluids.emplace_back("none");
    }
    MatrixResult result{plain.model.title, {}};
    for (const scene::Method& solid : scene::SolidMethods::all()) {
        for (const std::string& fluid : fluids) {
            run_pair(asked, std::string(solid.word), fluid, each, result.entries);
        }
    }
    return result;
}

std::string matrix_json(const MatrixResult& result) {
    using Json = nlohmann::ordered_json;
    const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
    Json list = Json::array();
    for (const MatrixEntry& entry : result.entries) {
        Json answers = Json::array();
        for (const ExpectResult& answer : entry.answers) {
            answers.push_back({{"name", answer.name},
                               {"value", number(answer.value)},
                               {"low", number(answer.low)},
                               {"high", number(answer.high)},
                               {"unit", answer.unit},
                               {"verdict", to_string(answer.verdict)}});
        }
        list.push_back({{"solid", entry.solid},
                        {"fluid", entry.fluid},
                        {"variation", entry.variation},
                        {"status", to_string(entry.finding)},
                        {"quantity", entry.quantity},
                        {"value", number(entry.value)},
                        {"ns", number(entry.ns)},
                        {"seconds", entry.seconds},
                        {"residual", number(entry.residual)},
                        {"why", entry.why},
                        {"answers", answers}});
    }
    return Json{{"title", result.title}, {"results", list}}.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string matrix_heading() {
    return fmt::format("{:<23} {:<12} {:<8} {:>13} {:>12} {:>10}  {}", "solid", "fluid", "result", "value", "ns a step",
                       "residual", "quantity; why");
}

std::string matrix_line(const MatrixEntry& entry) {
    const auto shown = [](double value, const char* form) {
        return std::isfinite(value) ? fmt::format(fmt::runtime(form), value) : std::string("-");
    };
    std::string text = fmt::format("{:<23} {:<12} {:<8} {:>13} {:>12} {:>10}  {}", entry.solid, entry.fluid,
                                   to_string(entry.finding), shown(entry.value, "{:.6g}"), shown(entry.ns, "{:.0f}"),
                                   shown(entry.residual, "{:.2e}"), entry.quantity);
    for (const std::string& more : {entry.variation, entry.why}) {
        text += more.empty() ? "" : (text.back() == ' ' ? "" : "; ") + more;
    }
    return text;
}

std::string matrix_counts(const std::vector<MatrixEntry>& entries) {
    std::string text;
    for (const Finding finding : {Finding::right, Finding::wrong, Finding::refused, Finding::unjudged}) {
        const auto count = std::ranges::count(entries, finding, &MatrixEntry::finding);
        if (count > 0) {
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, to_string(finding));
        }
    }
    return text;
}

}  // namespace riprap::run
