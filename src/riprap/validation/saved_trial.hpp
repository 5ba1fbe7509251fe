// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"

namespace riprap::validation {

/// Content of a trial beside its State: the rows so far and the time that they took.
struct TrialRecord {
    std::vector<double> time;      ///< of every row [s]
    std::vector<double> values;    ///< by row, then column
    double wall{0}, processor{0};  ///< time that the trial took so far, of all threads [s]
    std::uint64_t program{0};      ///< program_identity() of what computed it

    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        visit("trial.time", self.time);
        visit("trial.values", self.values);
        visit("trial.wall", self.wall);
        visit("trial.processor", self.processor);
        visit("trial.program", self.program);
    }
};

/// Shortest time between two saves [s] of wall-clock time
constexpr double save_every = 60;

/// A number that differs between two builds of the program: bits are promised for one build only, so a trial is not
/// finished by another. 0 where the program cannot read itself.
std::uint64_t program_identity();

/// Saves both, atomically. @throws FileError
void save_trial(const std::filesystem::path& path, const sim::Model& model, const sim::State& state,
                const TrialRecord& record);

/// Takes both up where `path` is there and was saved by this program in this case before its end; else touches nothing.
/// @returns whether it did. @throws FileError, CheckpointError for a file that is damaged
bool take_up_trial(const std::filesystem::path& path, const sim::Model& model, sim::State& state, TrialRecord& record);

}  // namespace riprap::validation
