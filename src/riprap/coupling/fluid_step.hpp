// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "riprap/core/vec3.hpp"
#include "riprap/coupling/wall_passages.hpp"
#include "riprap/fluid/fluid_balance.hpp"

namespace riprap::coupling {

/// Findings of a step that particles alone report; those of other fluids stay empty.
struct ParticleFindings {
    WallPassages through_walls;
    std::string intruder;      ///< a moving body among the layers of an opening, and which; empty = none
    std::int64_t renewals{0};  ///< of the geometry of water with two clocks (fluid::FlowClock)

    void add(const ParticleFindings& more) {
        through_walls.add(more.through_walls);
        renewals += more.renewals;
        if (intruder.empty()) {
            intruder = more.intruder;
        }
    }
};

/// Counts what came in less what left through inflows, outflows and open tops, after the kick.
struct Transported {
    double energy{0};  ///< kinetic, potential and internal [J]
    Vec3 momentum{};   ///< [kg m/s]
};

/// Report of a fluid on one span of a step.
struct FluidStep {
    fluid::FluidBalance balance;
    std::vector<double> own;      ///< amounts of the accounts that the fluid names itself, in their order [J]
    std::vector<double> earlier;  ///< amounts of the same accounts that were due before the kick; none = zero [J]
    Transported transported;
    ParticleFindings particles;
};

}  // namespace riprap::coupling
