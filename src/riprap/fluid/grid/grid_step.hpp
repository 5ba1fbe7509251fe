// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/grid/scratch.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/grid/state.hpp"

namespace riprap::fluid::grid {

/// A fluid at rest: water where `is_water` holds, by points of a lattice in each cell (128 x 128, 20 x 20 x 20 in
/// space, in cells that one of 5 finds mixed), air elsewhere.
GridState make_state(const GridSettings& settings, const std::function<bool(const Vec3&)>& is_water);
/// A state with given water fractions and velocities at face centres, component by component.
GridState make_state(const GridSettings& settings, const std::function<double(const Vec3&)>& fraction,
                     const std::function<Vec3(const Vec3&)>& velocity);

/// Makes what Scratch holds of the Model, where it is not there yet. Solids come in by set_open_shares.
void prepare(const GridSettings& settings, GridState& state, GridScratch& scratch);

/// Takes the shares that solids leave open at the end of the coming step; those of the last step become those before.
void set_open_shares(const GridSettings& settings, GridState& state, GridScratch& scratch, OpenShares shares);

/// Longest step that is stable: of the Courant number, of acceleration by gravity, of capillary waves and of viscosity
/// (docs/theory/grid.md) [s].
double stable_step(const GridSettings& settings, GridState& state, GridScratch& scratch);

/// Report of a step.
struct GridReport {
    int pressure_iterations{0};   ///< of the last pass [-]
    double pressure_residual{0};  ///< relative [-]
    bool converged{true};
};

/// Advances by dt: water, masses, momentum and pressure, `outer_corrections` times over, in each of which momentum and
/// pressure are repeated `pressure_corrections` times; then turbulence.
GridReport advance(const GridSettings& settings, GridState& state, GridScratch& scratch, double dt);

/// The parts of advance: all before the last pressure, which the motion of solids at the end of the step does not
/// change, and what follows it.
/// @return iterations of the pressures before the last
int begin_step(const GridSettings& settings, GridState& state, GridScratch& scratch, double dt);
void end_step(const GridSettings& settings, GridState& state, GridScratch& scratch, double dt);

}  // namespace riprap::fluid::grid
