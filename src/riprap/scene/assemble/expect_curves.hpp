// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

/// Reads the points of an [[expect]] that is held beside a curve, from the case or from a table; false with a problem,
/// also where the points do not go with its reduce.
bool read_curve(CaseBuild& build, const Value& table, sim::Expect& expect);

}  // namespace riprap::scene
