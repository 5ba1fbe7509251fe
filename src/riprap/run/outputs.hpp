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

/// Everything a run writes while it runs: frames for ParaView, rows of probes.csv and ledger.csv. What is written
/// when depends on the step number alone, so a resumed run writes the same files as one that was never stopped.
class Outputs {
 public:
    /// Starts new files, or continues those of a run as the record of its checkpoint says. @throws FileError
    Outputs(const RunFolder& folder, const sim::Model& model, const sim::State& initial, const RunRecord& record,
            bool is_continued);

    /// Writes what is due at this step. Called for step 0 and after every step.
    void after_step(const sim::Moment& moment);

    /// A row is written at this step, so its ledger must be complete.
    bool is_row_due(std::int64_t step) const { return row_schedule_.due_at(step) >= 0; }

    /// Puts all rows on the disk and notes the lengths, for a checkpoint.
    void note(RunRecord& record);

    /// The last frame, the last rows and bodies.csv, where the end does not fall on a regular time. Comes after
    /// `note`: a run that is continued past its end drops these again.
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
};

/// The intervals of a case with their defaults: end/100 between frames, end/1000 between rows [s].
double frame_interval(const sim::Model& model);
double row_interval(const sim::Model& model);

}  // namespace riprap::run
