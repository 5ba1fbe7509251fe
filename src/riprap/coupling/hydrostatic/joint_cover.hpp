// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/coupling/hydrostatic/hydrostatic.hpp"

namespace riprap::coupling {

/// Faces that are nearer to each other, or to the side of a region, than this share of a panel lie on it [-].
inline constexpr double lies_on_share = 0.05;

/// Cuts the faces of all bodies that forces may move into panels no longer than `size` to either side [m]; faces stay
/// whole where it is infinite. Faces between parts of one body, end faces of planar prisms and bodies that water passes
/// through are left out.
std::vector<HydrostaticFluid::Panel> cut_faces(const FluidScene& scene, const HydrostaticSettings& settings,
                                               double size);

/// Tells whether the middle of a panel lies on another body that keeps water off.
bool lies_on_another(const FluidScene& scene, const HydrostaticSettings& settings, const body::Motion& motion,
                     const HydrostaticFluid::Panel& panel);

/// Returns the share of the hydrostatic pressure that each panel feels [-]: 1 where it is open; where it lies on
/// another body 0 without uplift, and with linear uplift 1 - d/L, d the horizontal distance of the panel from the water
/// and L the largest d of all covered panels of its body.
std::vector<double> joint_shares(const FluidScene& scene, const HydrostaticSettings& settings,
                                 const body::Motion& motion, const std::vector<HydrostaticFluid::Panel>& panels);

}  // namespace riprap::coupling
