// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// Water, and water with blocks, against exact solutions and experiments (validation/water/README.md). Every case takes
// its numerical settings from the defaults of the key table.

namespace riprap::validation::water {

void taylor_green(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::water
