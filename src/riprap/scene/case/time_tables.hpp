// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

/// Vectors at increasing times.
struct TimeTable {
    std::vector<double> time;  ///< [s]
    std::vector<Vec3> value;
};

/// Reads a table of time from the case (`time` and the list called `key`) or from its CSV `file` with rows t, x, y, z,
/// in a plane t, x, y; plain numbers of the case become x. Empty, with a problem, where times do not increase or rows
/// are missing.
TimeTable read_time_table(CaseBuild& build, const Value& table, const std::string& key);

}  // namespace riprap::scene
