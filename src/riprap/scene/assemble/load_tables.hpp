// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/body/point_loads.hpp"
#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

/// Tells whether a load ends after it begins; a problem otherwise.
bool check_times(CaseBuild& build, const Value& load);
/// Reads the force against time of a load into build.force_tables, where it has one; false with a problem otherwise.
bool read_force_table(CaseBuild& build, const Value& load);
/// A load with the force and the times of its table, which has been read; its point is the caller's.
body::PointLoad load_on(const CaseBuild& build, BodyId body, const Value& load);

}  // namespace riprap::scene
