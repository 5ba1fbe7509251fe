// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/validation/registry.hpp"

namespace riprap::validation::mellado {

/// Constants of the lattice, operators, equation of state, collision of a pair, still water, impacts of spheres and
/// free rotation, each beside its exact answer.
void unit_checks(const CaseSetting& setting, CaseReport& report);

}  // namespace riprap::validation::mellado
