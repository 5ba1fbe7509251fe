// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// Rock and water [MikolaSitar2013]. The source prints pictures and no number: what is judged is theory.

namespace riprap::validation::mikola {

void wave_maker(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::mikola
