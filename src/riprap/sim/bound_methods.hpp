// SPDX-License-Identifier: Apache-2.0
#pragma once

// The methods of a case as the driver of a step sees them: bound to Model, State and Scratch for one step, a few calls
// each, whatever the method.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "riprap/body/body_set.hpp"
#include "riprap/body/motion.hpp"
#include "riprap/core/step.hpp"
#include "riprap/coupling/fluid_report.hpp"
#include "riprap/coupling/samples/rigid_map.hpp"
#include "riprap/solid/solid_scene.hpp"

namespace riprap::sim {

struct Model;
struct State;
struct ScratchData;

/// A solid method; see SolidMethod of sim/methods.hpp for what each verb does.
class Solid {
 public:
    virtual ~Solid() = default;
    virtual StepLimit limit() const = 0;
    /// May a refused piece have changed the State, and does a shorter one help?
    virtual bool takes_back() const = 0;
    virtual Outcome advance(const TimeSpan& span, const body::LoadView& loads, solid::Measure measure,
                            solid::SolidReport& report) = 0;
};

/// A fluid method with its coupling; see FluidMethod there.
class Fluid {
 public:
    virtual ~Fluid() = default;
    /// Is there a fluid at all?
    virtual bool is_there() const = 0;
    /// Is its step that of the run?
    virtual bool leads() const = 0;
    virtual StepLimit limit() const = 0;
    virtual void start() = 0;
    virtual void tidy(std::int64_t step) = 0;
    virtual void drive(const TimeSpan& span, std::vector<Vec3>& correction) = 0;
    virtual Outcome begin(const TimeSpan& span, const body::Motion& now, const body::Motion& middle,
                          coupling::FluidStep& report) = 0;
    virtual void load(const TimeSpan& span, const body::Motion& middle, coupling::FluidLoads& loads) = 0;
    virtual Outcome kick(const TimeSpan& span, coupling::FluidStep& report) = 0;
    virtual Outcome end(const TimeSpan& span, coupling::FluidStep& report) = 0;
    virtual std::span<const double> feedback() const = 0;
    /// Can it improve accelerations at all?
    virtual bool corrects() const = 0;
    virtual bool correct(const body::BodySet& bodies, const body::BodyKinematics& kinematics,
                         std::span<const std::uint8_t> is_sought, std::span<const body::Acceleration> residual,
                         std::vector<body::Acceleration>& guess) = 0;
};

struct BoundMethods {
    std::unique_ptr<Solid> solid;
    std::unique_ptr<Fluid> fluid;
};

/// Binds the methods of a case for one step. Model, State and Scratch have to outlive them. Fields of the State and
/// buffers of another method, or of none, are made anew.
BoundMethods bind_methods(const Model& model, State& state, ScratchData& scratch);

}  // namespace riprap::sim
