// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// Bonded elastic blocks of planar DDA against theory and finite elements.

namespace riprap::validation::dda {

void planar_bar_impact(const CaseSetting& setting, CaseReport& report);
void planar_cantilever(const CaseSetting& setting, CaseReport& report);
void planar_disc(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::dda
