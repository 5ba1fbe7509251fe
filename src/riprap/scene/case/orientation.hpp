// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/quat.hpp"
#include "riprap/scene/text/value.hpp"

namespace riprap::scene {

/// The turn that an orientation table means; the identity for null.
Quat orientation_of(const Value* table);

}  // namespace riprap::scene
