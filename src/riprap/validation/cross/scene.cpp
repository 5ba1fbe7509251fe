// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/cross/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "riprap/run/drive/find_case.hpp"
#include "riprap/run/study/matrix.hpp"
#include "riprap/validation/cross/causes.hpp"

namespace riprap::validation::cross {

namespace {

constexpr double most_seconds = 180;  // of one run: a scene takes seconds, one of a thousandth in size up to a minute
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Share of the energy turned over that the ledger of a pair may miss.
double energy_limit(const run::MatrixEntry& entry) {
    return entry.solid == "explicit_dda" && entry.fluid == "grid" ? 2e-2 : 1e-3;
}

/// The answer that a cell shows: the first that is missed, else the first.
const run::ExpectResult* shown_answer(const run::MatrixEntry& entry) {
    const auto missed = std::ranges::find(entry.answers, run::Verdict::failed, &run::ExpectResult::verdict);
    return missed != entry.answers.end() ? &*missed : entry.answers.empty() ? nullptr : &entry.answers.front();
}

Cell cell_of(const std::string& scene, const run::MatrixEntry& entry) {
    Cell cell;
    cell.scene = scene;
    cell.solid = entry.solid;
    cell.fluid = entry.fluid;
    cell.variation = entry.variation;
    cell.finding = std::string(to_string(entry.finding));
    cell.value = cell.low = cell.high = missing;
    cell.why = entry.why;
    cell.seconds = entry.seconds;
    if (entry.finding == run::Finding::unjudged) {  // a scene that judges nothing has nothing right
        cell.finding = to_string(run::Finding::wrong);
        cell.why = "nothing was judged";
    }
    if (const run::ExpectResult* answer = shown_answer(entry)) {
        cell.quantity = answer->name;
        cell.unit = answer->unit;
        cell.value = answer->value;
        cell.low = answer->low;
        cell.high = answer->high;
    }
    return cell;
}

/// What the ledger of a run with water misses.
Cell energy_of(Cell cell, const run::MatrixEntry& entry) {
    cell.is_energy = true;
    cell.quantity = "energy that the ledger misses, of that turned over";
    cell.unit = "-";
    cell.value = std::abs(entry.residual);
    cell.low = 0;
    cell.high = energy_limit(entry);
    cell.finding = cell.value <= cell.high ? "right" : "wrong";
    cell.why.clear();
    return cell;
}

std::string name_of(const Cell& cell) {
    std::string name = cell.solid;
    for (const std::string& more : {cell.fluid == "none" ? "" : cell.fluid, cell.variation}) {
        name += more.empty() ? "" : ", " + more;
    }
    return name;
}

}  // namespace

Result result_of(const Cell& cell) {
    const bool has_band = std::isfinite(cell.low) && std::isfinite(cell.high);
    Result result;
    result.name = cell.scene;
    result.quantity = (cell.quantity.empty() ? "" : cell.quantity + ": ") + name_of(cell);
    result.unit = cell.unit.empty() ? "-" : cell.unit;
    result.value = cell.value;
    if (has_band) {
        result.exact = cell.is_energy ? 0 : 0.5 * (cell.low + cell.high);
        result.low = cell.low;
        result.high = cell.high;
    }
    result.kind = cell.is_energy ? Kind::bookkeeping : Kind::physics;
    result.verdict = cell.finding == "refused" ? Verdict::under_specified
                     : cell.is_stale           ? Verdict::not_reproduced
                     : cell.finding == "right" ? Verdict::reproduced
                     : cell.cause.empty()      ? Verdict::not_reproduced
                                               : Verdict::close;
    result.note = cell.is_stale ? "right, and causes.toml lists it as wrong: take it off the list" : cell.why;
    result.note += cell.cause.empty() ? "" : (result.note.empty() ? "" : "; ") + cell.cause;
    return result;
}

std::vector<ValidationCase> scenes() {
    static std::deque<std::string> texts;  // cases hold views
    std::vector<ValidationCase> cases;
    const std::string prefix = std::string(suite) + "/";
    const auto run = [](const CaseSetting& setting, CaseReport& report) {
        std::vector<Cell> cells;
        run_scene(setting, cells);
        for (const Cell& cell : cells) {
            const Result result = result_of(cell);
            if (result.low) {
                report.judge({result.quantity, result.unit}, result.value, *result.low, *result.high);
            } else {
                report.state({result.quantity, result.unit, result.note}, result.value);
            }
        }
    };
    for (const run::KnownCase& known : run::known_cases("validation")) {
        if (known.name.starts_with(prefix)) {
            const std::string& name = texts.emplace_back(known.name.substr(prefix.size()));
            const std::string& title = texts.emplace_back(known.title);
            cases.push_back({suite, name, title, false, run});
        }
    }
    return cases;
}

void run_scene(const CaseSetting& setting, std::vector<Cell>& cells) {
    const Causes causes(setting.folder.parent_path() / "causes.toml");
    const std::string scene = setting.folder.filename().string();
    run::MatrixOptions options;
    options.case_path = (setting.folder / "case.toml").string();
    options.has_scales = setting.is_full;
    options.most_seconds = most_seconds;
    const auto note = [&](Cell cell) {
        causes.note(cell);
        cells.push_back(std::move(cell));
    };
    run::run_matrix(options, [&](const run::MatrixEntry& entry) {
        const Cell cell = cell_of(scene, entry);
        note(cell);
        if (entry.fluid != "none" && !entry.answers.empty()) {
            note(energy_of(cell, entry));
        }
    });
}

}  // namespace riprap::validation::cross
