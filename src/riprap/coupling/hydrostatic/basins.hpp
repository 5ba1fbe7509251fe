// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/coupling/fill.hpp"
#include "riprap/coupling/hydrostatic/settings.hpp"

namespace riprap::coupling {

/// Returns the extent of the water of a region: a box, or the sides of its convex pieces where these are no boxes along
/// the axes. Water that reaches from one periodic side of the domain to the other has no end there.
HydrostaticSettings::Basin basin_of(const FillRegion& region, const fluid::Domain& domain, const Vec3& up);

/// Returns planes with the water behind them, the sides and the bed, for each convex part of a basin; its top is the
/// level. All are `slack` farther out [m].
std::vector<std::vector<HydrostaticSettings::Side>> sides_of(const HydrostaticSettings& settings,
                                                             const HydrostaticSettings::Basin& basin, double slack);

/// Returns the distance of x from a basin, sideways, where it is near [m]; 0 inside. A place above the top or below the
/// bed of a box counts as inside.
double distance_from(const HydrostaticSettings::Basin& basin, const HydrostaticSettings& settings, const Vec3& x);

/// Returns the basin that reaches x, or the nearest one; nullptr without basins.
const HydrostaticSettings::Basin* nearest_basin(const HydrostaticSettings& settings, const Vec3& x);

}  // namespace riprap::coupling
