// SPDX-License-Identifier: Apache-2.0
#pragma once

// The members of an ensemble as the runs of a study.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/run/figures/spreads.hpp"
#include "riprap/run/folder/run_folder.hpp"
#include "riprap/run/study/sweep.hpp"
#include "riprap/scene/read_case.hpp"

namespace riprap::run {

/// One member: its drawn values, in the order of the spreads, and the exit code of its run.
struct Member {
    std::vector<double> values;  ///< SI
    double code;                 ///< not a number: not run yet
};

struct Members {
    std::uint64_t seed;
    std::vector<Spread> spreads;
    std::vector<Member> list;
};

/// Values of one member, refused by their keys.
struct RefusedMember {
    std::int64_t number;  ///< from 1
    Diagnostic problem;
};

/// Draws the values of members. @throws CaseError where the case has no [[spread]]
/// @param study  case, and what is set in all members; their points are added
/// @returns the members that their keys refuse; their code is that of a bad case. @throws CaseError where all are
std::vector<RefusedMember> draw_members(const scene::LoadedCase& loaded, std::int64_t count, SweepOptions& study,
                                        Members& members);

/// Takes the folder of an ensemble and writes ensemble_plan.json, what it asks for but for the number of members,
/// unless the same is there. Without that plan every file under the name of one of ours is the user's.
/// @param force  replaces another ensemble
/// @throws FileError
void claim_ensemble(const SweepOptions& study, const Members& members, bool force);

/// Writes ensemble.csv (member, seed, exit code, values) and ensemble.json, which has what sweep.json has of a study.
void write_members(const SweepOptions& study, const Members& members);

/// Tells whether a folder holds an ensemble.
bool is_ensemble(const std::filesystem::path& out);

/// Exit code of the run in a folder as far as its files tell it; not a number of one that has not ended.
double ended_code(const RunFolder& folder);

/// Reads the members of an ensemble from its folder, the exit codes of those that ended from their summaries.
/// @param study  its plan, from read_plan
Members read_members(const SweepOptions& study);

}  // namespace riprap::run
