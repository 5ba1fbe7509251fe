// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace riprap::run {

class Simulation;

/// Called after every accepted step, outputs written; false stops the run as a signal does, but with exit code 0. May
/// read, and take storage; may not step.
using Watch = std::function<bool(Simulation&)>;

}  // namespace riprap::run
