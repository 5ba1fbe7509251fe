// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/io/csv.hpp"
#include "riprap/io/scene_frame.hpp"
#include "riprap/run/restart.hpp"
#include "riprap/run/run_folder.hpp"
#include "riprap/run/schedule.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::run {

/// Outputs that are to be written at one step.
struct Due {
    bool row{false};    ///< of the tables: the ledger must be complete
    bool frame{false};  ///< for ParaView
};

/// Everything a run writes while it runs: frames for ParaView, rows of probes.csv and ledger.csv. The next time at
/// which each is due is part of a checkpoint, so a resumed run writes the same files as one that was never stopped.
class Outputs {
 public:
    /// Starts new files, or continues those of a run as the record of its checkpoint says. @throws FileError
    Outputs(const RunFolder& folder, const sim::Model& model, const sim::State& initial, const RunRecord& record,
            bool is_continued);

    /// Returns the outputs due once a step of length dt has ended at `time` [s]. Asked before the step is taken, so
    /// that it is known which quantities must be measured in it.
    Due due_at(double time, double dt) const;

    /// Writes what is due at this step. Called for step 0 and after every step.
    void after_step(const sim::Moment& moment, Due due);

    /// Puts all rows on the disk and notes the lengths and the next due times, for a checkpoint.
    void note(RunRecord& record);

    /// The last frame and the last rows, where the last step did not write them, and bodies.csv. Comes after `note`:
    /// a run that is continued past its end drops these again.
    void at_end(const sim::Moment& moment);

 private:
    void write_frame(const sim::Moment& moment, const std::string& tag);
    void write_lists(const sim::Moment* last) const;
    void write_probe_row(const sim::Moment& moment);
    void write_ledger_row(const sim::Moment& moment);

    const RunFolder& folder_;
    const sim::Model& model_;
    Schedule frame_schedule_, row_schedule_;
    std::vector<io::DrawnPlane> planes_;
    std::vector<sim::Column> probe_columns_, ledger_columns_;
    io::GrowingCsv probes_, ledger_;
    std::vector<double> frame_times_;
    Due last_written_;
};

/// Looks at the tables of a run of which nothing is left to do. @throws FileError where rows of them are missing
void require_tables(const RunFolder& folder, const sim::Model& model, const RunRecord& record);

/// Every quantity of the scene except time that the methods of a case have, vectors by component: the columns of
/// ledger.csv.
std::vector<sim::Column> scene_columns(const sim::Model& model);

/// The intervals of a case with their defaults: end/100 between frames, end/1000 between rows [s].
double frame_interval(const sim::Model& model);
double row_interval(const sim::Model& model);

}  // namespace riprap::run
