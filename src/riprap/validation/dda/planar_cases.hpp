// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// Bonded elastic blocks of planar DDA against theory and finite elements.

namespace riprap::validation::dda {

void planar_disc(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::dda
