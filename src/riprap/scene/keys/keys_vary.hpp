// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/scene/keys/key_table.hpp"

namespace riprap::scene {

/// [[vary]]: values of keys at which `riprap matrix` and `riprap validate` run a case again.
const Table& vary_table();

}  // namespace riprap::scene
