// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/validation/cross/cell.hpp"

namespace riprap::validation::cross {

/// The cells of the suite as tables for people: solids across for dry scenes; fluids across for those with water, a
/// line for each solid. A cell shows the answer, "WRONG" or the physics that is missing, and how many runs were right.
/// Below it the wrong cells with what they missed and the cause, counts and the time of computing.
std::string table_of(const std::vector<Cell>& cells);

/// The document of `riprap validate --json` with the cells in it, as "cells".
std::string with_cells(const std::string& results_json, const std::vector<Cell>& cells);

}  // namespace riprap::validation::cross
