// SPDX-License-Identifier: Apache-2.0
#pragma once

// Checkpoints of a run: State, and the little that the driver itself must remember to continue as if nothing had
// happened.

#include <cstdint>
#include <string>
#include <vector>

#include "riprap/io/checkpoint.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "riprap/run/simulate/good_state.hpp"
#include "riprap/run/simulate/passage_verdict.hpp"
#include "riprap/run/simulate/step_watch.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::run {

/// The driver's memory at one step.
struct RunRecord {
    double end{0};               ///< time asked for, which `riprap resume --end` may have moved [s]
    std::int64_t max_steps{-1};  ///< steps asked for; -1 = no limit
    double frame_interval{0};    ///< between frames [s]
    double row_interval{0};      ///< between rows of the tables [s]
    std::int64_t next_frame{0};  ///< the next frame is due at next_frame * frame_interval
    std::int64_t next_row{0};    ///< the next row is due at next_row * row_interval
    std::int64_t retries{0};     ///< steps refused and taken again with half the length
    StepCounts steps;
    double wall_seconds{0};  ///< of all processes so far [s]
    std::int64_t resumes{0};
    std::vector<std::uint64_t> csv_bytes;       ///< lengths of the tables, in the order of io::OutputChoices
    std::vector<double> frame_times;            ///< times of the frames written [s]
    std::vector<double> expects;                ///< running figures of the expected answers
    double approached{PassageWatch::infinite};  ///< since bodies were last looked at, PassageWatch::approached [m]
    DeepPairs deep;                             ///< PassageWatch::deep
    double told_excess{0};                      ///< StepWatch::told_excess [-]
    GoodState good;                             ///< where a run goes back to; no steps: to the State of the checkpoint

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("run.end", self.end);
        visit("run.max_steps", self.max_steps);
        visit("run.frame_interval", self.frame_interval);
        visit("run.row_interval", self.row_interval);
        visit("run.next_frame", self.next_frame);
        visit("run.next_row", self.next_row);
        visit("run.retries", self.retries);
        StepCounts::visit_fields(self.steps, visit);
        visit("run.wall_seconds", self.wall_seconds);
        visit("run.resumes", self.resumes);
        visit("run.csv_bytes", self.csv_bytes);
        visit("run.frame_times", self.frame_times);
        visit("run.expects", self.expects);
        visit("run.approached", self.approached);
        DeepPairs::visit_fields(self.deep, visit);
        visit("run.told_excess", self.told_excess);
        GoodState::visit_fields(self.good, visit);
    }
};

/// Point from which a run continues.
struct Restart {
    sim::State state;
    RunRecord record;
    std::string notice;  ///< why the latest checkpoint was not used, or that it is of an older version; else empty
    bool is_of_unknown_case{false};  ///< of an older version, whose hash of the same case is another
    bool is_of_older_version{false};
};

/// Writes the latest checkpoint and keeps the one before. @throws FileError; the old checkpoints are then untouched
void save_checkpoint(const RunFolder& folder, const sim::Model& model, const sim::State& state,
                     const RunRecord& record);

/// Reads the latest checkpoint or, where that is damaged or missing, the previous one (the damaged file is set
/// aside, so that it never replaces a good one).
/// @param initial  State of the case at time 0, initialised: gives the sizes that a checkpoint must have
/// One of an older version is taken up whatever its case: who knows where the case came from looks at
/// is_of_unknown_case.
/// @throws CheckpointError when there is none to use, or it belongs to another case
Restart load_checkpoint(const RunFolder& folder, const sim::Model& model, const sim::State& initial);

/// Turns one checkpoint into State and record, checking all that later code relies on: sizes, part numbers and order
/// of the contact history, finite numbers. @throws CheckpointError
Restart restore_checkpoint(const io::Checkpoint& checkpoint, const sim::Model& model, const sim::State& initial);

}  // namespace riprap::run
