// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace riprap::validation {

/// Standing of a value of ours to its reference.
enum class Verdict {
    reproduced,       ///< inside the acceptance band
    close,            ///< outside it, inside a stated wider band; the note says why
    not_reproduced,   ///< outside both, or the case could not be run
    under_specified,  ///< the source gives nothing to compare with, or not enough to set the case up; ours is reported
};
std::string_view to_string(Verdict verdict);

/// Totals count both kinds apart, so that "29 reproduced" means 29 comparisons with nature, theory or a published
/// figure.
enum class Kind {
    physics,      ///< a value with a meaning outside this program: measured, derived or published
    bookkeeping,  ///< an account the program must keep whatever it computes: energy or momentum that a ledger misses,
                  ///< mass, particles inside solids, bodies outside of a box
};
std::string_view to_string(Kind kind);

/// Reference of the paper: a number in the unit of the quantity, words where it gives words, or nothing.
using Published = std::variant<std::monostate, double, std::string>;

/// One line of the table that `riprap validate` prints.
struct Result {
    std::string name;             ///< of the case
    std::string quantity;         ///< what is compared, in words
    std::string unit;             ///< "m", "-" for a pure number
    Published paper;              ///< as published
    std::optional<double> exact;  ///< analytical value, where there is one
    double value{0};              ///< ours; NaN when the case could not be run
    std::optional<double> low;    ///< accepted band; empty for a quantity that is only reported
    std::optional<double> high;
    Verdict verdict{Verdict::not_reproduced};
    std::string note;
    Kind kind{Kind::physics};
    double seconds{0};  ///< wall-clock time of the whole case
};

/// A wider band with the reason why it may be missed by that much.
struct CloseBand {
    double low, high;
    std::string reason;  ///< becomes the note of a result that needs the wider band
};

/// A quantity and its reference, before anything is known of ours.
struct Reference {
    std::string quantity;
    std::string unit{"-"};
    Published paper{};
    std::optional<double> exact{};
    std::string note{};
    Kind kind{Kind::physics};
};

/// A quantity that nothing can be compared with. It has no place for a reference: a row with one is judged.
struct Reported {
    std::string quantity;
    std::string unit{"-"};
    std::string note{};
};

/// The band exact (1 -+ tolerance), tolerance relative [-].
struct Relative {
    double tolerance;
};
/// The band exact -+ tolerance, in the unit of the quantity.
struct Absolute {
    double tolerance;
};

/// Collects the results of one case.
class CaseReport {
 public:
    explicit CaseReport(std::string name) : name_(std::move(name)) {}

    /// Judges `value` by low <= value <= high; NaN is never inside.
    void judge(const Reference& reference, double value, double low, double high,
               const std::optional<CloseBand>& close = {});
    /// The same about reference.exact, which must be there.
    void judge(const Reference& reference, double value, Relative band);
    void judge(const Reference& reference, double value, Absolute band);
    /// Judges |value| <= limit: an error, a drift, a residual whose exact value is zero.
    void judge_below(const Reference& reference, double value, double limit);
    /// Reports a value that nothing can be compared with: under-specified.
    void state(const Reported& reported, double value);
    /// The case could not be finished.
    void fail(const std::string& message);

    const std::vector<Result>& results() const { return results_; }
    void set_seconds(double seconds);

 private:
    void add(const Reference& reference, double value, std::optional<double> low, std::optional<double> high,
             Verdict verdict, const std::string& note);

    std::string name_;
    std::vector<Result> results_;
};

/// {"suite": ..., "version": "short" or "full", "build": {...}, "machine": {...}, "totals": {"physics": {"reproduced":
/// ..., "close", "not_reproduced", "under_specified"}, "bookkeeping": likewise}, "results": [{"case", "kind",
/// "quantity", "unit", "paper", "exact", "value", "low", "high", "verdict", "note", "seconds"}]}. Absent values, and
/// numbers that are not finite, are null.
std::string to_json(std::string_view suite, const std::vector<Result>& results, bool is_full = false);

/// The same for people: one line per result, physics first and bookkeeping below it, the note under each line that is
/// not plainly reproduced, counts of both kinds at the end.
std::string to_table(std::string_view suite, const std::vector<Result>& results);

}  // namespace riprap::validation
