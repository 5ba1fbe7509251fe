// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "riprap/core/timer.hpp"
#include "riprap/scene/read_case.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/quantity.hpp"
#include "riprap/validation/registry.hpp"
#include "riprap/validation/saved_trial.hpp"

namespace riprap::validation::water {

/// The case.toml of a validation case with water, run as `riprap run` runs it: steps are chosen anew every time, probes
/// and gauges are recorded every output.probe_interval.
class WaterTrial {
 public:
    /// Reads <folder>/case.toml. `overrides` as for scene::read_case: what --full makes finer. @throws CaseError
    explicit WaterTrial(const CaseSetting& setting, std::span<const std::string> overrides = {});

    /// A column that no case file can name: `value(*this)` at every row. Before run() only.
    void record(const std::string& name, std::function<double(const WaterTrial&)> value);
    /// Saves the trial in `path` once a minute and before its last row, and takes it up from there where this program
    /// saved this case: for trials of hours whose `look` remembers nothing. Before run(), after record().
    void keep_in(const std::filesystem::path& path) { kept_in_ = path; }

    /// Steps to the end of the case. `look(*this)` at every row of the record.
    template <class Look>
    void run(Look look) {
        begin();
        while (step_to_row()) {
            look(*this);
        }
    }
    void run() {
        run([](const WaterTrial&) {});
    }

    /// Times of the rows [s].
    const std::vector<double>& time() const { return time_; }
    /// A column of probes.csv by its name, one value for every time. @throws std::runtime_error where there is none
    const std::vector<double>& column(const std::string& name) const;
    /// Returns the mean of a column over start <= t <= end.
    double mean(const std::string& name, double start, double end) const;

    double now() const { return state_.time; }
    /// Time that the trial took from its start, over all its parts where it was taken up [s].
    double wall_seconds() const { return earlier_.wall + timer_.seconds(); }
    /// The same of the processor, summed over threads [s].
    double processor_seconds() const;
    const sim::Model& model() const { return loaded_.model; }
    const sim::State& state() const { return state_; }
    /// For a field of velocity that no case file can say: before run() only.
    sim::State& initial() { return state_; }
    const sim::StepReport& report() const { return report_; }
    const fluid::SphSettings& sph() const { return loaded_.model.particles()->sph(); }

 private:
    void begin();
    bool step_to_row();
    void add_row();
    void take_up();
    void save();

    scene::LoadedCase loaded_;
    sim::State state_, initial_;
    AfterStep after_step_;
    sim::Scratch scratch_;
    sim::StepReport report_;
    double interval_{0};
    std::vector<sim::Column> columns_;
    std::vector<double> time_;
    std::vector<std::vector<double>> values_;  ///< by column, then row; columns of the case before those of record()
    struct OwnColumn {
        std::string name;
        std::function<double(const WaterTrial&)> value;
    };
    std::vector<OwnColumn> own_;
    std::filesystem::path kept_in_;
    TrialRecord earlier_;  ///< what former parts took
    Timer timer_, since_save_;
    double processor_at_start_{0};
};

/// Judges that the energy ledger closes to 1 % of what was turned over; the case probes energy_residual and
/// energy_turnover. `run` names one of several runs.
void judge_ledger(CaseReport& report, const WaterTrial& trial, const std::string& run = "");

/// Area (in 3D volume) that the water takes at its density, sum m/rho [m^D].
double water_area(const WaterTrial& trial);

/// Integral of y over x from `start` to `end` by trapezia between the points; ends are interpolated.
double integral(std::span<const double> x, std::span<const double> y, double start, double end);
/// y at x on straight lines between the points; the end values beyond.
double interpolated(std::span<const double> x, std::span<const double> y, double at);
/// The highest point of a record.
struct Crest {
    double time, level;
};
/// By the parabola through the highest row up to `until` and its neighbours; NaN where the record is highest at one of
/// its ends.
Crest crest_of(std::span<const double> time, std::span<const double> level,
               double until = std::numeric_limits<double>::infinity());
/// Returns where y crosses `level`, upwards and downwards, between points by the straight line.
std::vector<double> crossings(std::span<const double> x, std::span<const double> y, double level);

}  // namespace riprap::validation::water
