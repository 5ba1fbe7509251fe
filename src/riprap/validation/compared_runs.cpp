// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/compared_runs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

namespace riprap::validation {

namespace {

/// The rows of a list of a [[vary]]; none without it.
std::span<const scene::Value> rows_of(const scene::Value& vary, std::string_view key) {
    const scene::Value* list = vary.find(key);
    return list != nullptr ? std::span<const scene::Value>(list->items) : std::span<const scene::Value>{};
}

void judge_comparison(const scene::Value& row, const std::string& quantity, double value, CaseReport& report) {
    Reference reference;
    reference.quantity = quantity;
    if (const scene::Value* exact = row.find("value")) {
        reference.exact = exact->as_number();
        report.judge(reference, value, Absolute{scene::get_number(row, "tolerance")});
    } else {
        report.judge(reference, value, scene::get_number(row, "low"), scene::get_number(row, "high"));
    }
}

/// Value of an answer of a run; NaN where the run did not come to it.
double value_of(const RunAnswers& run, const std::string& name) {
    const auto found = run.of.find(name);
    return found == run.of.end() ? std::nan("") : found->second.value;
}

void judge_ratio(const scene::Value& row, std::span<const RunAnswers> runs, std::int32_t vary, CaseReport& report) {
    const std::string& name = scene::get_text(row, "name");
    double base = std::nan("");
    for (const RunAnswers& run : runs) {
        if (run.variation.vary < 0) {
            base = value_of(run, name);
        } else if (run.variation.vary == vary) {
            judge_comparison(row, fmt::format("{}, over that of the case as it stands; {}", name, run.variation.label),
                             value_of(run, name) / base, report);
        }
    }
}

void judge_order(const scene::Value& row, std::span<const RunAnswers> runs, std::int32_t vary, const std::string& key,
                 CaseReport& report) {
    const std::string& name = scene::get_text(row, "name");
    std::vector<double> key_values, errors;
    for (const RunAnswers& run : runs) {
        const auto found = run.of.find(name);
        if (run.variation.vary == vary && found != run.of.end() && found->second.exact) {
            key_values.push_back(run.variation.first);
            errors.push_back(std::abs(found->second.value - *found->second.exact));
        }
    }
    if (!key_values.empty()) {  // else all are of the long version
        judge_comparison(row, fmt::format("{}, order of convergence over {}", name, key),
                         logarithmic_slope(key_values, errors), report);
    }
}

}  // namespace

RunAnswers answers_of_run(const scene::Value& expects, const nlohmann::json& found, const scene::Variation& variation) {
    RunAnswers run{variation, {}};
    for (std::size_t i = 0; i < found.size(); ++i) {
        const nlohmann::json& value = found[i].at("value");
        RunAnswers::Answer answer{value.is_number() ? value.get<double>() : std::nan(""), {}};
        if (const scene::Value* exact = expects.items.at(i).find("value")) {
            answer.exact = exact->as_number();
        }
        run.of.emplace(found[i].at("name").get<std::string>(), answer);
    }
    return run;
}

double logarithmic_slope(std::span<const double> x, std::span<const double> y) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!(x[i] > 0) || !(y[i] > 0)) {
            return std::nan("");
        }
        const double u = std::log(x[i]), v = std::log(y[i]);
        n += 1;
        sx += u;
        sy += v;
        sxx += u * u;
        sxy += u * v;
    }
    const double spread = n * sxx - sx * sx;
    return n < 2 || !(spread > 0) ? std::nan("") : (n * sxy - sx * sy) / spread;
}

void compare_runs(const scene::Value& checked, std::span<const RunAnswers> runs, CaseReport& report) {
    const std::span<const scene::Value> list = rows_of(checked, "vary");
    for (std::size_t i = 0; i < list.size(); ++i) {
        const auto vary = static_cast<std::int32_t>(i);
        const scene::Value& key = scene::get(list[i], "key");
        const std::string what = key.is_text() ? key.text : key.items.front().text;
        for (const scene::Value& row : rows_of(list[i], "ratio")) {
            judge_ratio(row, runs, vary, report);
        }
        for (const scene::Value& row : rows_of(list[i], "order")) {
            judge_order(row, runs, vary, what, report);
        }
    }
}

}  // namespace riprap::validation
