// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/body/loads.hpp"

namespace riprap::body {

/// A force that varies in time: linear between rows, none before the first, the last afterwards.
struct ForceTable {
    std::vector<double> time;  ///< increasing [s]
    std::vector<Vec3> force;   ///< world axes [N]
    Vec3 at(double t) const;
};

/// A force on a point of a body: a thrust, a cable, a weight set down. Its direction is fixed in the world, its point
/// moves with the body. It grows linearly over [start, start + ramp] and ends at `stop`. A body that does not follow
/// forces does not feel it.
struct PointLoad {
    BodyId body;
    Vec3 force{};                                          ///< at its full size, world axes [N]
    std::shared_ptr<const ForceTable> table{};             ///< instead of `force`; its times count from `start`
    Vec3 point{};                                          ///< in the frame of the body, from its centre of mass [m]
    double start{0};                                       ///< [s]
    double ramp{0};                                        ///< [s]
    double stop{std::numeric_limits<double>::infinity()};  ///< [s]
    Vec3 at(double time) const;
};

/// Adds the point loads of a case to the other loads on its bodies. Scratch: holds the sums of one step.
class PointLoadSum {
 public:
    /// Returns force, torque about the centre of mass and pull of every body at `time`, in the order of `loads`:
    /// `others` itself where there are no loads. Valid until the next call.
    /// @param others  empty, or loads of every body
    LoadView add(std::span<const PointLoad> loads, const BodyState& bodies, double time, const LoadView& others);

 private:
    Loads sum_;
};

}  // namespace riprap::body
