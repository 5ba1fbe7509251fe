// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// The grid fluid against exact solutions and experiments (validation/grid/README.md). Every case takes its numerical
// settings from the defaults of GridSettings, but for outer_corrections = 2 where the order in time is what is asked.

namespace riprap::validation::grid {

void cavity(const CaseSetting& setting, CaseReport& report);
void poiseuille(const CaseSetting& setting, CaseReport& report);
void couette(const CaseSetting& setting, CaseReport& report);
void kovasznay(const CaseSetting& setting, CaseReport& report);
void taylor_green(const CaseSetting& setting, CaseReport& report);
void slotted_disc(const CaseSetting& setting, CaseReport& report);
void vortex(const CaseSetting& setting, CaseReport& report);
void sway(const CaseSetting& setting, CaseReport& report);
void rising_bubble(const CaseSetting& setting, CaseReport& report);

void regular_waves(const CaseSetting& setting, CaseReport& report);
void wave_propagation(const CaseSetting& setting, CaseReport& report);
void run_up(const CaseSetting& setting, CaseReport& report);
void oscillating_cylinder(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::grid
