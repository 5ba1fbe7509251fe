// SPDX-License-Identifier: Apache-2.0
#pragma once

// Content of a Scratch: for the sources of this folder only.

#include <cstddef>
#include <memory>
#include <vector>

#include "riprap/body/motion.hpp"
#include "riprap/body/predict.hpp"
#include "riprap/material/material_set.hpp"
#include "riprap/sim/advance.hpp"
#include "riprap/solid/solid_times.hpp"

namespace riprap::sim {

/// Bodies as they will be at mid-step, which the fluid is told: Scratch.
struct Prediction {
    std::vector<body::Acceleration> guess;  ///< of free bodies
    /// Velocity that free bodies took up over the spans of the step that are over, linear and angular [m/s, rad/s].
    std::vector<body::Acceleration> gained;
    std::vector<Vec3> moved;  ///< beyond what the velocities of the State move them in that time [m]
    /// Velocity that makes up over this step for what walls missed in the last one; empty: none [m/s, rad/s].
    std::vector<body::Acceleration> catch_up;
    std::vector<body::Acceleration> way;   ///< that the fluid saw so far in this step, without catch_up [m, rad]
    std::vector<body::Acceleration> told;  ///< way to mid-step that the density of the fluid was told [m, rad]
    std::vector<Vec3> correction;          ///< acceleration of driven bodies beyond their motion; may be empty [m/s^2]
    body::BodyState bodies;                ///< at mid-step, as they drift there
    body::BodyKinematics kinematics;       ///< ... there
    body::Motion now, middle;              ///< at t_n and at mid-step
};

struct MethodScratch;  // method_scratch.hpp

struct ScratchData {
    ScratchData();
    ~ScratchData();

    std::unique_ptr<MethodScratch> methods;  ///< buffers of the methods of the case
    material::MaterialSet materials;         ///< with reduced strengths, where the case reduces them
    Prediction prediction;
    coupling::FluidLoads fluid_loads;  ///< of the fluid in the last step, pressure and viscosity apart
    body::Loads span_loads, loads;     ///< ... together: in one span, and over the step
    body::BodyState before;            ///< bodies at the start of the step, where there is a fluid
    StageTimes times;
};

/// Sum of the contact forces and of their moments on every body in the last piece.
const body::Loads& contact_loads(const ScratchData& scratch);
/// Seconds that the solid method spent per stage so far.
const solid::SolidTimes& solid_times(const ScratchData& scratch);
/// Bytes of the buffers of the methods.
std::size_t method_bytes(const ScratchData& scratch);

}  // namespace riprap::sim
