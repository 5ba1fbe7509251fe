// SPDX-License-Identifier: Apache-2.0
#pragma once

// Expected answers of a case, judged while it runs: every step is looked at, not only the rows that are written.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/run/figures/running_figures.hpp"
#include "riprap/sim/column_group.hpp"

namespace riprap::run {

/// Judgement of one [[expect]].
enum class Verdict {
    passed,
    failed,      ///< outside its band, or never seen
    reported,    ///< has no band
    not_judged,  ///< the run stopped before its end, or that comes before what is looked at
};
std::string_view to_string(Verdict verdict);

struct ExpectResult {
    std::string name, quantity, reduce, unit, citation;
    double value{0};         ///< NaN when never seen
    double time{0};          ///< when it was that; NaN for a mean, and when never seen [s]
    double low{0}, high{0};  ///< infinite of what is only reported
    Verdict verdict{Verdict::not_judged};
};

/// Follows the quantities that a case expects something of.
class ExpectWatch {
 public:
    /// @throws CaseError for a quantity or a reduce that does not exist
    explicit ExpectWatch(const sim::Model& model);

    /// Columns of one expected answer; those that it does not name are unset.
    struct Columns {
        sim::ColumnGroup quantity, relative_to;
        sim::ColumnGroup trigger;             ///< of reduce = when, and what the points of a curve are along
        std::optional<sim::Profile> profile;  ///< instead of a quantity: a curve along gauges, at one time
        std::string unit;
    };

    /// Takes the values at one moment. A missing value (a contact force before the first step) is left out.
    void look(const sim::Moment& moment);

    /// `at_end`: the run reached its end time; otherwise nothing is judged.
    std::vector<ExpectResult> judge(bool at_end) const;

    /// The running figures as flat numbers, for the checkpoint, and back. @throws CheckpointError on another length
    std::vector<double> save() const;
    void load(const std::vector<double>& numbers);

 private:
    double value_of(std::size_t answer) const;

    const sim::Model& model_;
    std::vector<Columns> columns_;
    std::vector<RunningFigures> figures_;
    std::vector<std::vector<double>> met_;  ///< values at the points of curves; NaN before they are reached
};

/// The table of verdicts as printed at the end of a run, those in colour if asked; empty without expects.
std::string verdict_table(const std::vector<ExpectResult>& results, bool is_coloured = false);

}  // namespace riprap::run
