// SPDX-License-Identifier: Apache-2.0
#pragma once

// Readers of the tables of [fluid]: for the sources of this folder only.

#include <optional>
#include <vector>

#include "riprap/coupling/field_scene.hpp"
#include "riprap/coupling/fill.hpp"
#include "riprap/scene/case/case_build.hpp"

namespace riprap::scene {

/// The flow that fluid.flow names; nothing where `table`, that of the fluid, has none.
std::optional<fluid::Flow> read_flow(const Value& table);

/// The domain in `table`. False with a problem.
bool read_domain(CaseBuild& build, const Value& table, fluid::Domain& domain);

/// Convex pieces of the box or shape of a table, none where it gives neither. Nothing with a problem.
std::optional<std::vector<geometry::Polyhedron>> read_pieces(CaseBuild& build, const Value& table);

/// Waves, stones and boxes where waves die, of a fluid without particles, as far as `table` has them. False with a
/// problem.
bool read_field_tables(CaseBuild& build, const Value& table, coupling::FieldScene& scene);

/// The regions of the case; false where one of them has a problem.
bool read_regions(CaseBuild& build, const Value& list, std::vector<coupling::FillRegion>& regions);

/// Refuses a level that its region does not reach: the water would end at the top of the region instead.
/// @param slack  by which the level may lie above the top of the region [m]
void check_level(CaseBuild& build, const Value& table, const coupling::FillRegion& region, const fluid::Domain& domain,
                 double slack);

/// Refuses a region of a fluid without particles that has no water in the domain. False with a problem.
bool check_region(CaseBuild& build, const Value& table, const coupling::FillRegion& region,
                  const fluid::Domain& domain);

/// Refuses bodies that forces move and that are longer than the domain: what is beyond it feels no water. Ground and
/// walls may go on.
void check_lengths(CaseBuild& build, const fluid::Domain& domain);

/// c_0 from the depth of the water that is there, and from the fastest that the case makes something move, or as given;
/// filling does not need it yet.
void choose_sound_speed(CaseBuild& build, const Value& table, const std::vector<coupling::FillRegion>& regions,
                        const fluid::ParticleState& particles, coupling::ParticleFluid& fluid);

}  // namespace riprap::scene
