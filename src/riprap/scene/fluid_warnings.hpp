// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/coupling/fill.hpp"
#include "riprap/scene/build_case.hpp"

namespace riprap::scene {

/// Room that regions below their levels leave for water [m^3], in a planar scene [m^2]: what several regions share
/// counts once, solids are taken out. Solids but half-spaces are taken not to overlap.
double room_for_water(const CaseBuild& build, const fluid::Domain& domain,
                      const std::vector<coupling::FillRegion>& regions);

/// Bodies too thin for the spacing (docs/theory/coupling.md, 1): those with water on opposite sides or free to come
/// there, and those with water on one side.
void warn_of_thin_bodies(CaseBuild& build, const sim::FluidModel& fluid, const fluid::ParticleState& water);

/// Bodies that forces can move and whose centres start outside of the domain of the water, in one line for all.
void warn_of_bodies_outside(CaseBuild& build, const sim::FluidModel& fluid);

/// Settings of the scheme that do not go together.
void warn_of_scheme(CaseBuild& build, const fluid::SphSettings& sph);

}  // namespace riprap::scene
