// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/validation/dda/planar_trial.hpp"
#include "riprap/validation/ding/breakwater.hpp"

namespace riprap::validation::ding {

/// Pressure around the caisson of the breakwater while a solitary wave strikes it, every tenth of a second: one-way
/// coupling [Ding2021, section 3.5]: the wave runs against fixed solids, and its recorded pressures load the moving
/// ones.
class RecordedWater {
 public:
    /// Simulates the wave with cells of `cell` [m] by 0.625 of that and keeps the pressures from `first` to `last` [s].
    RecordedWater(double cell, double first, double last);

    /// p at a place and a time [Pa], linear in time and between cells; the ends of the record beyond it.
    double pressure(const geometry::Vec2& place, double time) const;
    double first() const { return first_; }
    double duration() const { return last_ - first_; }

 private:
    static constexpr double interval = 0.1;
    double value(std::size_t sample, const geometry::Vec2& place) const;

    double first_, last_;
    double low_x_{0}, low_y_{0}, width_{0}, height_{0};  ///< centre of the first cell kept, size of cells [m]
    int columns_{0}, rows_{0};
    std::vector<std::vector<float>> samples_;  ///< row by row
    std::vector<std::uint8_t> is_open_;
};

/// Adds the loads of the water on the sides of a block to those of a trial: pressure at the midpoints of segments of
/// half a metre, its points of application [Ding2021, eq. 3.26].
void press_block(PlanarTrial& trial, std::int32_t block, const RecordedWater& water, double time);

/// Adds the loads on the caisson: its front, rear and top, and under its foot pressure that falls linearly from toe to
/// heel.
void press_caisson(PlanarTrial& trial, std::int32_t caisson, const RecordedWater& water, double time);

}  // namespace riprap::validation::ding
