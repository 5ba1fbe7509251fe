// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/coupling/fill.hpp"
#include "riprap/fluid/particle/domain.hpp"

namespace riprap::coupling {

/// A level of the water at one time.
struct LevelAt {
    double time;   ///< [s]
    double level;  ///< height along `up` from the origin [m]
};

/// What a case says of where a fluid without particles is: given to the `prepare` of its settings, once, while the case
/// is read.
struct FieldScene {
    fluid::Domain domain;
    std::vector<FillRegion> regions;
    std::vector<LevelAt> levels;  ///< in rising order of time; empty where the level does not change
    Vec3 up{0, 0, 1};             ///< against gravity [-]
};

}  // namespace riprap::coupling
