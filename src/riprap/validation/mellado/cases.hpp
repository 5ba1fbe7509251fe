// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// Spheres and multisphere bodies: exact impacts, and the cases of [Mellado2021] and [Amaro2021].

namespace riprap::validation::mellado {

void cylinder_entry(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::mellado
