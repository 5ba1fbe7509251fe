// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/gauge/gauge.hpp"
#include "riprap/sim/advance.hpp"

namespace riprap::sim {

/// Reads a gauge of the fluid of the case at this moment, where its carrier is now.
/// @param scratch  of the last step; nullptr before the first
fluid::GaugeReading read_now(const Model& model, const State& state, const Scratch* scratch, const fluid::Gauge& gauge);

/// Reading of the gauge of that number as its instrument shows it: `read_now`, or for one that responds slowly what
/// `follow` has kept.
fluid::GaugeReading read_gauge(const Model& model, const State& state, const Scratch* scratch, std::size_t gauge);

/// Lets instruments that respond slowly follow the step that has just been taken (fluid::lagged). They begin with the
/// reading of the first step.
void follow(const Model& model, State& state, const Scratch& scratch, double dt);

}  // namespace riprap::sim
