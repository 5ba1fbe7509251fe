// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scenes with exact answers, each run with every solid method and every fluid. A scene is data: a folder
// validation/cross/NAME with a case.toml, its [[expect]] and its derivation.

#include <vector>

#include "riprap/validation/cross/cell.hpp"
#include "riprap/validation/registry.hpp"

namespace riprap::validation::cross {

/// Returns every folder of validation/cross as a case, by name.
std::vector<ValidationCase> scenes();

/// Runs the scene in setting.folder with every method, at the values of its [[vary]] and, in the long version, with the
/// step and the stiffness of every solid method times 1/4 and 4. Appends one cell for each run, and one for the energy
/// that its ledger misses where there is water.
void run_scene(const CaseSetting& setting, std::vector<Cell>& cells);

}  // namespace riprap::validation::cross
