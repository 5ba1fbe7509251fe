// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// Spheres and multisphere bodies: exact impacts, and the cases of [Mellado2021] and [Amaro2021].

namespace riprap::validation::mellado {

void normal_impact(const CaseSetting& setting, CaseReport& report);
void oblique_impact(const CaseSetting& setting, CaseReport& report);
void rolling(const CaseSetting& setting, CaseReport& report);
void sliding_multisphere(const CaseSetting& setting, CaseReport& report);
void single_drop(const CaseSetting& setting, CaseReport& report);
void cylinders(const CaseSetting& setting, CaseReport& report);
void three_blocks(const CaseSetting& setting, CaseReport& report);
void demolisher(const CaseSetting& setting, CaseReport& report);
void friction_strips(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::mellado
