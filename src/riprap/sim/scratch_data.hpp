// SPDX-License-Identifier: Apache-2.0
#pragma once

// Content of a Scratch: for the sources of this folder only.

#include <optional>

#include "riprap/body/predict.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/sim/methods.hpp"

namespace riprap::sim {

/// Bodies as they will be at mid-step, which the fluid is told: Scratch.
struct Prediction {
    std::vector<body::Acceleration> guess;  ///< of free bodies
    /// Velocity that free bodies took up over the spans of the step that are over, linear and angular [m/s, rad/s].
    std::vector<body::Acceleration> gained;
    std::vector<Vec3> moved;          ///< beyond what the velocities of the State move them in that time [m]
    std::vector<Vec3> correction;     ///< acceleration of driven bodies beyond their motion; may be empty [m/s^2]
    body::BodyState bodies;           ///< at mid-step, as they drift there
    body::BodyKinematics kinematics;  ///< ... there
    body::Motion now, middle;         ///< at t_n and at mid-step
};

struct ScratchData {
    Solids::Scratch solids;
    Fluids::Scratch fluid;
    Prediction prediction;
    coupling::FluidLoads fluid_loads;  ///< of the fluid in the last step, pressure and viscosity apart
    body::Loads span_loads, loads;     ///< ... together: in one span, and over the step
    body::BodyState before;            ///< bodies at the start of the step, where there is a fluid
    StageTimes times;
};

/// Calls work(solids, fluid) with the methods of the case, bound to Model, State and Scratch.
template <class Work>
void with_methods(const Model& model, State& state, ScratchData& scratch, const Work& work) {
    const solid::SolidScene scene = solid_scene(model);
    const solid::SolidState solid_state{state.bodies, state.contacts, state.previous_dt};
    const coupling::FluidScene fluid_scene{model.shapes, model.bodies, model.gravity};
    const coupling::FluidState fluid_state{state.fluid, state.open, state.coupling, state.bodies};
    Solids::visit(model.solid, [&]<class Solid>(const typename Solid::Settings& solid_settings) {
        Solid solids(scene, solid_settings, solid_state, Solids::matching<Solid>(model.solid, state.solid_fields),
                     Solids::matching<Solid>(model.solid, scratch.solids));
        Fluids::visit(model.fluid, [&]<class Fluid>(const typename Fluid::Settings& fluid_settings) {
            Fluid fluid(fluid_scene, fluid_settings, fluid_state,
                        Fluids::matching<Fluid>(model.fluid, state.fluid_fields),
                        Fluids::matching<Fluid>(model.fluid, scratch.fluid));
            work(solids, fluid);
        });
    });
}

}  // namespace riprap::sim
