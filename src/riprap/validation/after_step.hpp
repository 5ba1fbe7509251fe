// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace riprap::validation {

/// Called after every step of a simulation with its time and that of its end [s].
using AfterStep = std::function<void(double time, double end)>;

}  // namespace riprap::validation
