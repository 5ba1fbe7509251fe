// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/sim/model.hpp"
#include "riprap/solid/explicit_dem.hpp"

namespace riprap::sim {

/// Adds the point loads of a case to what else acts on its bodies. Scratch: holds the sums of one step.
class PointLoadSum {
 public:
    /// Force and torque about the centre of mass of every body at `time`, in the order of `loads`. The answer is
    /// `others` itself where there are no loads, and is valid until the next call.
    /// @param others  empty, or a force and a torque for every body
    solid::ExternalLoads add(std::span<const PointLoad> loads, const body::BodyState& bodies, double time,
                             const solid::ExternalLoads& others);

 private:
    std::vector<Vec3> force_, torque_;
};

}  // namespace riprap::sim
