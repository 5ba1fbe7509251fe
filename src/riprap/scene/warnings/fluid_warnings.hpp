// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "riprap/coupling/field_scene.hpp"
#include "riprap/coupling/fill.hpp"
#include "riprap/coupling/hydrostatic/settings.hpp"
#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

/// Room that regions below their levels leave for water [m^3], in a planar scene [m^2]: what several regions share
/// counts once, solids are taken out. Solids but half-spaces are taken not to overlap.
double room_for_water(const CaseBuild& build, const fluid::Domain& domain,
                      const std::vector<coupling::FillRegion>& regions);

/// A warning about the entry of the case whose name has the number `name` among those of bodies.
void warn_at(CaseBuild& build, std::int32_t name, std::string text);

/// Bodies too thin for the spacing (docs/theory/coupling.md, 1): those with water on opposite sides or free to come
/// there, and those with water on one side.
void warn_of_thin_bodies(CaseBuild& build, const coupling::ParticleFluid& fluid, const fluid::ParticleState& water);

/// Bodies that forces can move and whose centres start outside of the domain of the water, in one line for all.
void warn_of_bodies_outside(CaseBuild& build, const coupling::ParticleFluid& fluid);

/// Driven bodies, paddles aside, that move out of the domain by more than a spacing; through its top only those that
/// water lies on, for a gate is lifted out of it.
void warn_of_driven_leaving(CaseBuild& build, const coupling::ParticleFluid& fluid, const std::vector<Vec3>& water);

/// Fixed and driven bodies that water stands at and passes through.
void warn_of_dry_walls(CaseBuild& build, const coupling::ParticleFluid& fluid, const std::vector<Vec3>& water);

/// A region that reaches out of the domain to where no solid is, along axes that are not periodic. Its table is at
/// `place`.
void warn_of_cut_region(CaseBuild& build, const SourcePlace& place, const coupling::FillRegion& region,
                        const coupling::ParticleFluid& fluid);

/// Regions of water so shallow that the surface and the bed lie within the support of every particle. Their tables are
/// the items of `regions`.
void warn_of_shallow_water(CaseBuild& build, const Value& regions, const coupling::ParticleFluid& fluid,
                           const coupling::Filling& filling);

/// Sides of the domain that water stands at without a solid beyond it or an opening there. The table of the domain is
/// at `place`.
void warn_of_open_sides(CaseBuild& build, const SourcePlace& place, const coupling::ParticleFluid& fluid,
                        const std::vector<Vec3>& water);

/// Ground whose cells leave room below it in the domain of a fluid that takes them as they are. Looks at 40 places
/// along each axis.
void warn_of_hollow_ground(CaseBuild& build, const fluid::Domain& domain);

/// Sides whose waves are for less water than stands there: below their bed is no solid.
void warn_of_waves_over_depth(CaseBuild& build, const Value& waves, const coupling::FieldScene& scene);

/// A region of still water that ends at a face of a body that may move, in one line for all.
void warn_of_regions_at_faces(CaseBuild& build, const Value& regions, const coupling::HydrostaticSettings& settings);

/// Settings of the scheme that do not go together, or have no effect between the bodies and openings of the case.
void warn_of_scheme(CaseBuild& build, const fluid::SphSettings& sph, const coupling::ParticleFluid& fluid);

}  // namespace riprap::scene
