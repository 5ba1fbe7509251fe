// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::fluid::grid {

double density_of(const GridSettings& settings, double fraction);
/// Dynamic viscosity of the mixture, the harmonic mean [Pa s].
double viscosity_of(const GridSettings& settings, double fraction);
/// Gravity and the acceleration of the frame at a time [m/s^2].
Vec3 body_force(const GridSettings& settings, double time);

/// Masses of cells at the start of the step, before the transport of water [kg].
void find_masses_before(const GridSettings& settings, const GridState& state, GridScratch& scratch);
/// Masses of cells after the transport of water, which went with scratch.moved.water_flux [kg].
void find_masses(const GridSettings& settings, const GridState& state, GridScratch& scratch);
/// Viscosity of cells, molecular and of eddies [Pa s].
void find_viscosity(const GridSettings& settings, const GridState& state, GridScratch& scratch);

/// Velocity before the pressure, and how much the pressure drives through faces (scratch.projection.predicted,
/// scratch.projection.conductance):
///
///     (1 + C_A) rho du/dt = [mass flux]-consistent transport + (1/n) div(tau) - R n u - grad P - (g.x) grad rho
///                           + sigma kappa grad alpha,      U = n u,
///
/// for the velocity u in the pores. A mass leaves a velocity cell with exactly the velocity it is transported with:
/// masses of velocity cells are means of those of two cells and their fluxes means of the fluxes of these, so a uniform
/// velocity stays uniform at any density ratio. Resistance and the shear of solids are implicit.
/// @param advected  velocity whose momentum is carried, with ghosts [m/s]
/// @param is_midpoint  it is that of the middle of the step: no upwinding in time
void predict_velocity(const GridSettings& settings, const GridState& state, GridScratch& scratch,
                      const std::array<std::vector<double>, 3>& advected, bool is_midpoint, double dt);

}  // namespace riprap::fluid::grid
