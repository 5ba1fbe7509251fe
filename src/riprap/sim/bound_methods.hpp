// SPDX-License-Identifier: Apache-2.0
#pragma once

// The methods of a case as the driver of a step sees them: bound to Model, State and Scratch for one step, a few calls
// each, whatever the method.

#include <memory>

#include "riprap/coupling/fluid_method.hpp"
#include "riprap/coupling/fluid_scene.hpp"
#include "riprap/solid/solid_method.hpp"

namespace riprap::sim {

struct Model;
struct State;
struct ScratchData;

/// Binds the methods of a case for one step. Model, State and Scratch have to outlive it. Fields of the State and
/// buffers of another method, or of none, are made anew.
class BoundMethods {
 public:
    BoundMethods(const Model& model, State& state, ScratchData& scratch);
    BoundMethods(const BoundMethods&) = delete;
    BoundMethods& operator=(const BoundMethods&) = delete;

    solid::SolidMethod& solid() { return *solid_; }
    coupling::FluidMethod& fluid() { return *fluid_; }
    /// Is the step of the fluid that of the run?
    bool fluid_leads() const { return fluid_leads_; }
    /// Returns the step that solids allow: where a step of the fluid is shared out at its beginning, whatever touches
    /// later.
    StepLimit solid_limit() const { return fluid_leads_ ? solid_->lasting_limit() : solid_->limit(); }

 private:
    solid::SolidScene solid_scene_;
    coupling::FluidScene fluid_scene_;
    bool fluid_leads_;
    std::unique_ptr<solid::SolidMethod> solid_;
    std::unique_ptr<coupling::FluidMethod> fluid_;
};

}  // namespace riprap::sim
