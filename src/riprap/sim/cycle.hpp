// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "riprap/core/step.hpp"

namespace riprap::sim {

/// Division of one step between both sides: spans of the fluid, then pieces of the solids. All spans are equal, and all
/// pieces; one of both counts is 1.
struct Cycle {
    double time{0};          ///< at the beginning [s]
    double dt{0};            ///< of the whole step [s]
    std::int64_t spans{1};   ///< of the fluid: none without one, more than one where the step of the solids is longer
    std::int64_t pieces{1};  ///< of the solids; more than one where the fluid's is

    TimeSpan span(std::int64_t k) const { return part(k, spans); }
    TimeSpan piece(std::int64_t k) const { return part(k, pieces); }

 private:
    TimeSpan part(std::int64_t k, std::int64_t count) const {
        const double length = dt / static_cast<double>(count);
        return {time + length * static_cast<double>(k), length};
    }
};

}  // namespace riprap::sim
