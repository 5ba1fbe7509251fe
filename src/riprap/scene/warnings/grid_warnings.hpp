// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/coupling/field_scene.hpp"
#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

/// Warns, for a fluid on cells, of regions of water less than four cells deep, and of paddles with no water at their
/// face or of another depth, as for particles: water of the regions is looked for on a lattice of the cells' width.
/// Says nothing where that would be more than a million places.
/// @param regions  the tables of scene.regions
void warn_of_water_in_cells(CaseBuild& build, const Value& regions, const coupling::FieldScene& scene, double width);

}  // namespace riprap::scene
