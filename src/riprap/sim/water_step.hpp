// SPDX-License-Identifier: Apache-2.0
#pragma once

// The fluid's side of one step: for the sources of this folder only.

#include <vector>

#include "riprap/coupling/added_mass.hpp"
#include "riprap/coupling/penalty_walls.hpp"
#include "riprap/coupling/rigid_map.hpp"
#include "riprap/fluid/sph/sph_step.hpp"
#include "riprap/sim/joint_loads.hpp"
#include "riprap/sim/model.hpp"
#include "riprap/sim/state.hpp"
#include "riprap/solid/explicit_dem.hpp"

namespace riprap::sim {

/// Buffers of the water: Scratch.
struct WaterScratch {
    fluid::SphScratch sph;
    fluid::BoundaryParticles walls;
    std::vector<std::int32_t> near_numbers;  ///< a copy of the State's near_samples: those that `walls` stand for
    coupling::PenaltyWalls penalty;
    coupling::BodyMotion motion;      ///< of all bodies, where the samples were placed last
    coupling::FluidLoads loads;       ///< at the last kick
    coupling::FluidLoads held_loads;  ///< of particles pressed against faces and of water in joints, part of `loads`
    JointScratch joints;
    std::vector<Vec3> force, torque;  ///< pressure and viscosity together
    std::vector<Vec3> extra_force;    ///< of penalty walls on particles [N]
    fluid::SpongeWork sponge;
    std::vector<Vec3> correction;        ///< acceleration of driven bodies beyond their motion; may be empty [m/s^2]
    body::BodyState middle;              ///< bodies at mid-step, as predicted
    body::BodyKinematics kinematics;     ///< ... there
    std::vector<double> kappa, inertia;  ///< of bodies, for the added-mass iteration
    std::vector<std::uint8_t> is_still;  ///< bodies that never move
    std::vector<std::uint8_t> is_loose;  ///< bodies that forces move, now or once they are released
    std::vector<double> guard_share;     ///< of the guard's stiffness, per body

    std::size_t bytes() const;
};

/// What the water's step brings.
struct WaterReport {
    fluid::FluidReport fluid;
    double absorbed{0};      ///< by sponges, in this step [J]
    double flow_work{0};     ///< on the layers of inflows and outflows, likewise [J]
    double work_on_free{0};  ///< on free bodies, as the water sees it, in this step [J]
    int passes{0};           ///< force passes, more than one where light bodies feed back
    double residual{0};      ///< of the added-mass iteration, over |a| + |g| [-]
    bool is_settled{true};   ///< of that iteration
    std::string intruder;    ///< a moving body among the layers of an opening, and which; empty = none
    bool ok() const { return fluid.problem.empty(); }
};

/// The samples that the water may feel in this step.
inline coupling::SampleView samples_near_water(const Model& model, const WaterScratch& scratch) {
    return {model.fluid->samples, scratch.near_numbers};
}

/// Water from t_n to the kick and over it: density, half a drift, forces with bodies where they will be at mid-step.
/// Bodies are not moved. `scratch.loads`, `force` and `torque` are then what the solids feel over the step. After it,
/// end_water_step is due.
WaterReport kick_water(const Model& model, State& state, WaterScratch& scratch, double dt);

/// Ends the step of the water, `water` being what kick_water found: the second half of the drift, and what passes
/// inflows and outflows.
fluid::Passage end_water_step(const Model& model, State& state, const fluid::FluidReport& water, WaterScratch& scratch,
                              double dt);

/// Notes how bodies sped up over the step that took them from `before` to where they are: the first guess of the next.
void note_accelerations(const Model& model, const body::BodyState& before, State& state, const WaterScratch& scratch,
                        double dt);

/// The work that loads held over a step did on free bodies that went from `before` to where they are [J].
double work_done(const Model& model, const body::BodyState& before, const State& state, const WaterScratch& scratch);

/// Empties what a fresh State keeps for the coupling.
void reset(const Model& model, CouplingState& coupling);

}  // namespace riprap::sim
