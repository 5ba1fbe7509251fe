// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// Spheres and multisphere bodies: exact impacts, and the cases of [Mellado2021] and [Amaro2021].

namespace riprap::validation::mellado {

void cylinder_entry(const CaseSetting& setting, CaseReport& report);
void floes_4(const CaseSetting& setting, CaseReport& report);
void floes_sph(const CaseSetting& setting, CaseReport& report);
void floes_9(const CaseSetting& setting, CaseReport& report);
void floes_fine(const CaseSetting& setting, CaseReport& report);
void floes_none(const CaseSetting& setting, CaseReport& report);
void floe_methods(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::mellado
