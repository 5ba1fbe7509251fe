// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// Water, and water with blocks, against exact solutions and experiments (validation/water/README.md). Every case takes
// its numerical settings from the defaults of the key table.

namespace riprap::validation::water {

void heave_decay(const CaseSetting& setting, CaseReport& report);
void standing_wave(const CaseSetting& setting, CaseReport& report);
void elliptic_drop(const CaseSetting& setting, CaseReport& report);
void wave_run_up(const CaseSetting& setting, CaseReport& report);
void cylinder_entry(const CaseSetting& setting, CaseReport& report);
void sinking_block(const CaseSetting& setting, CaseReport& report);
void taylor_green(const CaseSetting& setting, CaseReport& report);
void viscous_wave(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::water
