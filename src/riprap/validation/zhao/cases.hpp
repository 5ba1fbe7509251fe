// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// The examples of the distance-potential paper [Zhao]; set-up, choices and tolerances:
// validation/zhao/<case>/README.md.

namespace riprap::validation::zhao {

void free_columns(const CaseSetting& setting, CaseReport& report);
void slope_1(const CaseSetting& setting, CaseReport& report);
void slope_2(const CaseSetting& setting, CaseReport& report);
void slope_3(const CaseSetting& setting, CaseReport& report);
void slope_4(const CaseSetting& setting, CaseReport& report);
void slope_5(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::zhao
