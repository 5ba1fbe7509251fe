// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/sim/advance.hpp"

namespace riprap::run {

/// A step that was refused for good, with all that its remedy follows from.
struct Refused {
    const sim::Model& model;
    const sim::State& before;       ///< the last good State
    const sim::State& after;        ///< of the refused step: may hold what is not finite
    const sim::Scratch& scratch;    ///< of the refused step
    const sim::StepReport& report;  ///< of the refused step
    const sim::StepStatus& why;     ///< with the remedy that the method itself names, where it names one
};

}  // namespace riprap::run
