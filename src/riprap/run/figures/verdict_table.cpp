// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "riprap/core/tint.hpp"
#include "riprap/run/figures/expects.hpp"
#include "riprap/sim/reductions.hpp"

namespace riprap::run {

namespace {

/// Returns the reason why there is no value.
std::string cause_of_none(const ExpectResult& result) {
    return result.reduce == "when"           ? "the quantity of 'when' did not reach its level"
           : result.reduce == "at"           ? "the quantity had none at that time"
           : sim::is_of_curve(result.reduce) ? "a point of the curve was not reached"
           : result.reduce == "period"       ? "it passed its level less than three times"
                                             : "no step of its window had one";
}

/// Colour of a verdict on a terminal.
Tint tint_of(Verdict verdict) {
    return verdict == Verdict::passed || verdict == Verdict::reported ? Tint::good
           : verdict == Verdict::failed                               ? Tint::bad
                                                                      : Tint::caution;
}

}  // namespace

std::string_view to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::passed:
            return "passed";
        case Verdict::failed:
            return "failed";
        case Verdict::reported:
            return "reported";
        default:
            return "not_judged";
    }
}

std::string verdict_table(const std::vector<ExpectResult>& results, bool is_coloured) {
    if (results.empty()) {
        return {};
    }
    std::size_t width = 6;
    for (const ExpectResult& result : results) {
        width = std::max(width, result.name.size());
    }
    std::string text = fmt::format("{:<{}}  {:>14}  {:>10}  {:>29}  {:<8}  verdict\n", "expect", width, "value",
                                   "at [s]", "band", "unit");
    for (const ExpectResult& result : results) {
        const std::string time = std::isnan(result.time) ? "-" : fmt::format("{:.5g}", result.time);
        const std::string band =
            std::isinf(result.low) ? "" : fmt::format("{:>13.7g} .. {:>12.7g}", result.low, result.high);
        text += fmt::format("{:<{}}  {:>14.7g}  {:>10}  {:>29}  {:<8}  {}\n", result.name, width, result.value, time,
                            band, result.unit,
                            tinted(result.verdict == Verdict::not_judged ? "not judged" : to_string(result.verdict),
                                   tint_of(result.verdict), is_coloured));
    }
    for (const ExpectResult& result : results) {
        if (result.verdict == Verdict::failed && std::isnan(result.value)) {
            text += fmt::format("'{}' has no value: {}\n", result.name, cause_of_none(result));
        }
    }
    return text;
}

}  // namespace riprap::run
