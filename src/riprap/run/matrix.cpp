// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/matrix.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "riprap/core/error.hpp"
#include "riprap/run/simulation.hpp"
#include "riprap/scene/keys/methods.hpp"

namespace riprap::run {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Value to compare: of the column that is asked for, the first expected answer or the first record. Where the case is
/// ended before an answer is due, its quantity at the end stands for it.
double value_of(const Simulation& simulation, const std::string& asked, std::string& quantity) {
    const sim::Model& model = simulation.model();
    std::string name = asked;
    if (asked.empty() && !model.expects.empty()) {
        const ExpectResult first = simulation.judge().front();
        if (std::isfinite(first.value)) {
            quantity = fmt::format("{} ({})", first.quantity, first.reduce);
            return first.value;
        }
        name = first.quantity;
    }
    const std::vector<sim::Column> records = sim::record_columns(model);
    const std::optional<sim::Column> column = !name.empty()     ? sim::find_column(model, name)
                                              : records.empty() ? std::nullopt
                                                                : std::optional(records.front());
    if (!column) {
        quantity = name;
        return missing;
    }
    quantity = column->name;
    return sim::evaluate(*column, simulation.now());
}

/// Runs a case that was read to its end.
void run_to_end(Simulation& simulation, MatrixEntry& entry) {
    const auto start = std::chrono::steady_clock::now();
    const std::int64_t first = simulation.state().step;
    entry.status = "ran";
    while (simulation.steps_left() > 0) {
        const StepOutcome outcome =
            simulation.step(simulation.next_is_last() ? sim::Measure::energy : sim::Measure::flow);
        if (outcome.kind == StepOutcome::Kind::refused) {
            entry.status = "failed";
            entry.why = outcome.why.with_remedy();
            break;
        }
    }
    const std::int64_t steps = simulation.state().step - first;
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
    entry.ns = steps > 0 ? spent.count() / static_cast<double>(steps) : 0;
    const sim::Ledger& ledger = simulation.report().ledger;
    entry.residual = ledger.turnover > 0 ? ledger.residual / ledger.turnover : 0;
}

MatrixEntry run_combination(const MatrixOptions& options, const std::string& solid, const std::string& fluid,
                            std::string& quantity) {
    MatrixEntry entry{solid, fluid, "illegal", missing, missing, missing, ""};
    std::vector<std::string> overrides = options.overrides;
    overrides.push_back(fmt::format("solid.method=\"{}\"", solid));
    if (fluid != "none") {
        overrides.push_back(fmt::format("fluid.method=\"{}\"", fluid));
    }
    try {
        Simulation simulation(scene::read_case(options.case_path, overrides));
        run_to_end(simulation, entry);
        if (entry.status == "ran") {
            entry.value = value_of(simulation, options.quantity, quantity);
        }
    } catch (const CaseError& error) {
        const Diagnostic& first = error.problems().front();
        entry.why = first.message + (first.allowed.empty() ? "" : "; allowed: " + first.allowed);
    }
    return entry;
}

}  // namespace

MatrixResult run_matrix(const MatrixOptions& options, const std::function<void(const MatrixEntry&)>& each) {
    const scene::LoadedCase plain = scene::read_case(options.case_path, options.overrides);
    std::vector<std::string> fluids;
    if (plain.model.has_fluid()) {
        for (const scene::Method& method : scene::FluidMethods::all()) {
            fluids.emplace_back(method.word);
        }
    } else {
        fluids.emplace_back("none");
    }
    MatrixResult result;
    for (const scene::Method& solid : scene::SolidMethods::all()) {
        for (const std::string& fluid : fluids) {
            result.entries.push_back(run_combination(options, std::string(solid.word), fluid, result.quantity));
            if (each) {
                each(result.entries.back());
            }
        }
    }
    return result;
}

std::string matrix_json(const MatrixResult& result) {
    using Json = nlohmann::ordered_json;
    const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
    Json list = Json::array();
    for (const MatrixEntry& entry : result.entries) {
        list.push_back({{"solid", entry.solid},
                        {"fluid", entry.fluid},
                        {"status", entry.status},
                        {"value", number(entry.value)},
                        {"ns", number(entry.ns)},
                        {"residual", number(entry.residual)},
                        {"why", entry.why}});
    }
    return Json{{"quantity", result.quantity}, {"results", list}}.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string matrix_heading(const std::string& quantity) {
    return fmt::format("{:<23} {:<13} {:<8} {:>13} {:>12} {:>12}  {}", "solid", "fluid", "status",
                       quantity.empty() ? "value" : quantity, "ns a step", "residual", "why");
}

std::string matrix_line(const MatrixEntry& entry) {
    if (entry.status != "ran") {
        return fmt::format("{:<23} {:<13} {:<8} {:>13} {:>12} {:>12}  {}", entry.solid, entry.fluid, entry.status, "-",
                           "-", "-", entry.why);
    }
    return fmt::format("{:<23} {:<13} {:<8} {:>13.6g} {:>12.0f} {:>12.2e}  {}", entry.solid, entry.fluid, entry.status,
                       entry.value, entry.ns, entry.residual, entry.why);
}

}  // namespace riprap::run
