// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

namespace riprap::run {

/// Search for the factor of safety F: the factor by which strengths are divided when bodies begin to fail. Trials at
/// several factors at a time part the interval between the largest factor that stood and the smallest that failed,
///
///     F_i = F_s (F_f/F_s)^(i/(n+1)),   i = 1..n,   until F_f - F_s <= tolerance F_s,
///
/// rounded to five digits. A trial that failed counts for all larger factors: where one of these stood, the search says
/// so (contradictions) and goes on below.
class FactorSearch {
 public:
    struct Range {
        double low{0.5}, high{5};  ///< least and largest factor tried [-]
        double tolerance{0.01};    ///< width of the bracket over its lower end [-]
        int at_a_time{1};          ///< trials of a round
    };
    explicit FactorSearch(const Range& range) : range_(range) {}

    /// Returns the factors to try next, ascending; empty once the answer is known. Trials begin at full strength: first
    /// comes 1 or the end of the range next to it, and the upper end; the lower end only where 1 fails.
    std::vector<double> next() const;
    void tell(double factor, bool stands) { known_[factor] = stands; }

    /// Largest factor that stood below all that failed, and the smallest that failed; 0 where there is none.
    double stood() const;
    double failed() const;
    bool is_bracketed() const { return stood() > 0 && failed() > 0; }
    /// Returns the factors that stood above one that failed.
    std::vector<double> contradictions() const;
    /// Returns how many more trials are needed at most.
    int trials_left() const;

 private:
    double start() const;
    std::vector<double> between(double low, double high, int count) const;

    Range range_;
    std::map<double, bool> known_;  ///< factor: stands
};

}  // namespace riprap::run
