// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/strength/factor_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace riprap::run {

namespace {

/// Rounds to five digits, as names and overrides of trials have them.
double rounded(double factor) { return std::strtod(fmt::format("{:.5g}", factor).c_str(), nullptr); }

}  // namespace

double FactorSearch::start() const { return std::clamp(1.0, range_.low, range_.high); }

double FactorSearch::failed() const {
    const auto first = std::ranges::find_if(known_, [](const auto& trial) { return !trial.second; });
    return first == known_.end() ? 0 : first->first;
}

double FactorSearch::stood() const {
    double largest = 0;
    const double failing = failed();
    for (const auto& [factor, stands] : known_) {
        largest = stands && (failing == 0 || factor < failing) ? factor : largest;
    }
    return largest;
}

std::vector<double> FactorSearch::contradictions() const {
    std::vector<double> found;
    const double failing = failed();
    for (const auto& [factor, stands] : known_) {
        if (stands && failing > 0 && factor > failing) {
            found.push_back(factor);
        }
    }
    return found;
}

std::vector<double> FactorSearch::between(double low, double high, int count) const {
    std::vector<double> factors;
    for (int i = 1; i <= count; ++i) {
        const double factor = rounded(low * std::pow(high / low, static_cast<double>(i) / (count + 1)));
        if (factor > low && factor < high && !known_.contains(factor)) {
            factors.push_back(factor);
        }
    }
    return factors;
}

std::vector<double> FactorSearch::next() const {
    const auto with_ends = [this](double low, double high, std::vector<double> ends) {
        const int more = range_.at_a_time - static_cast<int>(ends.size());
        const std::vector<double> inner = between(low, high, std::max(0, more));
        ends.insert(ends.end(), inner.begin(), inner.end());
        std::sort(ends.begin(), ends.end());
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
        return ends;
    };
    if (known_.empty()) {
        return with_ends(start(), range_.high, {start(), range_.high});
    }
    const double low = stood(), high = failed();
    if (high == 0) {
        return {};  // it stands at the upper end
    }
    if (low == 0) {
        return known_.contains(range_.low) ? std::vector<double>{} : with_ends(range_.low, high, {range_.low});
    }
    const double wanted = range_.tolerance * low;
    if (high - low <= wanted * (1 + 1e-9)) {
        return {};
    }
    const int needed = static_cast<int>(std::ceil((high - low) / wanted)) - 1;
    return between(low, high, std::clamp(needed, 1, std::max(1, range_.at_a_time)));
}

int FactorSearch::trials_left() const {
    const int n = std::max(1, range_.at_a_time);
    const double low = stood() > 0 ? stood() : start(), high = failed() > 0 ? failed() : range_.high;
    const double parts = std::log(high / low) / std::log1p(range_.tolerance);
    const int rounds = parts > 1 ? static_cast<int>(std::ceil(std::log(parts) / std::log(n + 1.0))) : 0;
    return n * rounds + (known_.empty() ? std::max(2, n) : 0);
}

}  // namespace riprap::run
