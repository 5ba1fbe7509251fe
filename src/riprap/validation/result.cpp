// SPDX-License-Identifier: Apache-2.0
#include "riprap/validation/result.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "riprap/core/error.hpp"
#include "riprap/run/folder/provenance.hpp"

namespace riprap::validation {

std::string_view to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::reproduced:
            return "reproduced";
        case Verdict::close:
            return "close";
        case Verdict::not_reproduced:
            return "not_reproduced";
        case Verdict::under_specified:
            return "under_specified";
    }
    return "";
}

std::string_view to_string(Kind kind) { return kind == Kind::physics ? "physics" : "bookkeeping"; }

void CaseReport::add(const Reference& reference, double value, std::optional<double> low, std::optional<double> high,
                     Verdict verdict, const std::string& note) {
    results_.push_back({name_, reference.quantity, reference.unit, reference.paper, reference.exact, value, low, high,
                        verdict, note, reference.kind, 0});
}

void CaseReport::judge(const Reference& reference, double value, double low, double high,
                       const std::optional<CloseBand>& close) {
    const auto inside = [value](double from, double to) { return value >= from && value <= to; };
    if (inside(low, high)) {
        add(reference, value, low, high, Verdict::reproduced, reference.note);
    } else if (close && inside(close->low, close->high)) {
        const std::string separator = reference.note.empty() ? "" : reference.note + "; ";
        add(reference, value, low, high, Verdict::close, separator + close->reason);
    } else {
        add(reference, value, low, high, Verdict::not_reproduced, reference.note);
    }
}

void CaseReport::judge(const Reference& reference, double value, Relative band) {
    RIPRAP_ASSERT(reference.exact.has_value(), reference.quantity);
    const double margin = band.tolerance * std::abs(*reference.exact);
    judge(reference, value, *reference.exact - margin, *reference.exact + margin);
}

void CaseReport::judge(const Reference& reference, double value, Absolute band) {
    RIPRAP_ASSERT(reference.exact.has_value(), reference.quantity);
    judge(reference, value, *reference.exact - band.tolerance, *reference.exact + band.tolerance);
}

void CaseReport::judge_below(const Reference& reference, double value, double limit) {
    Reference about_zero = reference;
    about_zero.exact = 0.0;
    judge(about_zero, value, -limit, limit);
}

void CaseReport::state(const Reported& reported, double value) {
    const Reference nothing{reported.quantity, reported.unit, {}, {}, reported.note};
    add(nothing, value, {}, {}, Verdict::under_specified, reported.note);
}

void CaseReport::fail(const std::string& message) {
    Reference reference;
    reference.quantity = "runs to its end";
    reference.note = message;
    add(reference, std::numeric_limits<double>::quiet_NaN(), {}, {}, Verdict::not_reproduced, message);
}

void CaseReport::set_seconds(double seconds) {
    for (Result& result : results_) {
        result.seconds = seconds;
    }
}

namespace {

using Json = nlohmann::ordered_json;

Json number(std::optional<double> value) { return value && std::isfinite(*value) ? Json(*value) : Json(nullptr); }

Json published(const Published& paper) {
    if (const auto* value = std::get_if<double>(&paper)) {
        return number(*value);
    }
    const auto* words = std::get_if<std::string>(&paper);
    return words != nullptr ? Json(*words) : Json(nullptr);
}

Json totals_of(const std::vector<Result>& results) {
    Json totals;
    for (const Kind kind : {Kind::physics, Kind::bookkeeping}) {
        Json& counts = totals[std::string(to_string(kind))];
        for (const Verdict verdict :
             {Verdict::reproduced, Verdict::close, Verdict::not_reproduced, Verdict::under_specified}) {
            counts[std::string(to_string(verdict))] =
                std::count_if(results.begin(), results.end(),
                              [&](const Result& result) { return result.kind == kind && result.verdict == verdict; });
        }
    }
    return totals;
}

}  // namespace

std::string to_json(std::string_view suite, const std::vector<Result>& results, bool is_full) {
    Json rows = Json::array();
    for (const Result& result : results) {
        Json row;
        row["case"] = result.name;
        row["kind"] = to_string(result.kind);
        row["quantity"] = result.quantity;
        row["unit"] = result.unit;
        row["paper"] = published(result.paper);
        row["exact"] = number(result.exact);
        row["value"] = number(result.value);
        row["low"] = number(result.low);
        row["high"] = number(result.high);
        row["verdict"] = to_string(result.verdict);
        row["note"] = result.note;
        row["seconds"] = number(result.seconds);
        rows.push_back(std::move(row));
    }
    Json answer;
    answer["suite"] = suite;
    answer["version"] = is_full ? "full" : "short";
    answer["build"] = Json::parse(run::build_json());
    answer["machine"] = Json::parse(run::machine_json());
    answer["totals"] = totals_of(results);
    answer["results"] = std::move(rows);
    return answer.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace riprap::validation
