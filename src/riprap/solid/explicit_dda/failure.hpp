// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/solid/explicit_dda/advance.hpp"

namespace riprap::solid::explicit_dda {

/// Block that a step has lost, and how, in words that follow its name.
struct Failure {
    std::int32_t block{-1};  ///< -1 = none
    std::string what;
};

/// Finds the first block whose place is not finite or whose volume has left the range of Settings::max_stretch.
Failure find_failure(const affine::BlockSystem& system, const Settings& settings, const affine::BlockState& state);

}  // namespace riprap::solid::explicit_dda
