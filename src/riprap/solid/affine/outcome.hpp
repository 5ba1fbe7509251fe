// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace riprap::solid::affine {

/// Outcome of a piece of a step.
struct Outcome {
    std::string problem{};  ///< empty = done
    double shorten{0};      ///< share of the step to try instead; 0 = no shorter step helps
    bool ok() const { return problem.empty(); }
};

}  // namespace riprap::solid::affine
