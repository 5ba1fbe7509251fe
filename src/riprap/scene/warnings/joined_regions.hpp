// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/coupling/fill.hpp"

namespace riprap::scene {

/// Returns for each region the largest depth of it and of all regions whose water meets its own, one by one: a wet
/// floor beside a column is part of the water of the column.
/// @param depths   of each region alone [m]
/// @param spacing  of the places of `filling` [m]
std::vector<double> joined_depths(const coupling::Filling& filling, std::vector<double> depths, double spacing);

}  // namespace riprap::scene
