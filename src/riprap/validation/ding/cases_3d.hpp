// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// Three-dimensional cases of [Ding2021, chapter 7], by implicit DDA.

namespace riprap::validation::ding {

void arch_3d(const CaseSetting& setting, CaseReport& report);
void dam_uplift(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::ding
