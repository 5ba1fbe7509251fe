// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// Exact answers of limit equilibrium and of rigid bodies, by three-dimensional DDA, implicit and explicit.

namespace riprap::validation::dda {

void rock_wedges_3d(const CaseSetting& setting, CaseReport& report);
void tipping_3d(const CaseSetting& setting, CaseReport& report);
void sliding_block_3d(const CaseSetting& setting, CaseReport& report);
void stack_3d(const CaseSetting& setting, CaseReport& report);
void rocking_3d(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::dda
