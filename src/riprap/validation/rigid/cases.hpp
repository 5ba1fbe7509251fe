// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

// Exact answers of rigid-body mechanics and limit equilibrium: no paper's figure, a formula each.

namespace riprap::validation::rigid {

void granular_column(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::rigid
