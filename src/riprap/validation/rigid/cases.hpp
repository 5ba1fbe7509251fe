// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// Exact answers of rigid-body mechanics and limit equilibrium: no paper's figure, a formula each.

namespace riprap::validation::rigid {

void tip_or_slide(const CaseSetting& setting, CaseReport& report);
void stacks(const CaseSetting& setting, CaseReport& report);
void shaken_block(const CaseSetting& setting, CaseReport& report);
void toppling_columns(const CaseSetting& setting, CaseReport& report);
void arch(const CaseSetting& setting, CaseReport& report);
void granular_column(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::rigid
