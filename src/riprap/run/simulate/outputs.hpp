// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "riprap/io/output/output.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "riprap/run/simulate/restart.hpp"
#include "riprap/run/simulate/schedule.hpp"
#include "riprap/sim/quantity.hpp"

namespace riprap::run {

/// Outputs that are to be written at one step.
struct Due {
    bool row{false};    ///< of the tables: the ledger must be complete
    bool frame{false};  ///< for ParaView
};

/// All outputs of a run (io/output/output_kinds.hpp) while it runs. The next time at which each is due is part of a
/// checkpoint, so a resumed run writes the same files as one that was never stopped.
class Outputs {
 public:
    /// Starts new files, or continues those of a run as the record of its checkpoint says. @throws FileError
    Outputs(const RunFolder& folder, const scene::LoadedCase& loaded, const sim::State& initial,
            const RunRecord& record, bool is_continued);

    /// Returns the outputs due once a step of length dt has ended at `time` [s]. Asked before the step is taken, so
    /// that it is known which quantities must be measured in it.
    Due due_at(double time, double dt) const;

    /// Writes what is due at this step. Called for step 0 and after every step.
    void after_step(const sim::Moment& moment, Due due);

    /// Puts all rows on the disk and notes the lengths and the next due times, for a checkpoint.
    void note(RunRecord& record);

    /// The last frame and the last rows, where the last step did not write them, and what is written once. Comes after
    /// `note`: a run that is continued past its end drops these again.
    void at_end(const sim::Moment& moment);

 private:
    /// An output of the case; nullptr where it does without.
    struct Opened {
        std::unique_ptr<io::Output> output;
        bool has_table;
    };
    template <class Work>
    void for_each(const Work& work) {
        for (const Opened& opened : outputs_) {
            if (opened.output != nullptr) {
                work(*opened.output);
            }
        }
    }
    void write_rows(const sim::Moment& moment);
    void write_frames(const sim::Moment& moment, std::span<const io::WrittenFrame> frames);

    std::filesystem::path folder_;
    Schedule frame_schedule_, row_schedule_;
    bool has_frames_{false};
    std::vector<Opened> outputs_;
    std::vector<io::WrittenFrame> frames_;
    Due last_written_;
};

/// The intervals of a case with their defaults: end/100 between frames, end/1000 between rows [s].
double frame_interval(const sim::Model& model);
double row_interval(const sim::Model& model);

}  // namespace riprap::run
