// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/body/body_kinematics.hpp"
#include "riprap/body/body_set.hpp"
#include "riprap/body/motion.hpp"
#include "riprap/core/step.hpp"
#include "riprap/coupling/fluid_loads.hpp"
#include "riprap/coupling/fluid_step.hpp"

namespace riprap::coupling {

/// A way in which a fluid moves, with the coupling that it needs: the verbs that the driver of a step calls in this
/// order (docs/architecture.md, One step). An object is bound to Model, State and Scratch for one step. What a method
/// says of itself before any step is in its FluidTraits.
class FluidMethod {
 public:
    virtual ~FluidMethod() = default;
    /// Returns the step that the fluid allows.
    virtual StepLimit limit() const { return {}; }
    /// Completes a fresh State; called once.
    virtual void start() {}
    /// Puts the fields in order, on steps given by the step number alone.
    virtual void tidy(std::int64_t /*step*/) {}
    /// Corrects driven bodies that absorb waves. @param correction  of each driven body; empty: of none [m/s^2]
    virtual void drive(const TimeSpan& /*span*/, std::vector<Vec3>& correction) { correction.clear(); }
    /// Does the part of the span that does not depend on accelerations of bodies.
    /// @param now, middle  motion of bodies at the beginning of the span and where they will be at its middle
    virtual Outcome begin(const TimeSpan& span, const body::Motion& now, const body::Motion& middle,
                          FluidStep& report) = 0;
    /// Clears `loads` and finds those on bodies that move as `middle` says; may be repeated with other accelerations.
    virtual void load(const TimeSpan& span, const body::Motion& middle, FluidLoads& loads) = 0;
    /// Changes the velocities of the fluid under the last loads, and books their work.
    virtual Outcome kick(const TimeSpan& span, FluidStep& report) = 0;
    /// Ends the span, with bodies at its end.
    virtual Outcome end(const TimeSpan& /*span*/, FluidStep& /*report*/) { return {}; }
    /// Returns how strongly the acceleration of each body comes back in its loads, added mass over mass; none: not at
    /// all
    /// [-].
    virtual std::span<const double> feedback() const { return {}; }
    /// Can `correct` improve accelerations in this scene? Then the fluid cannot give way, and its loads follow the way
    /// of bodies within a step.
    virtual bool corrects() const { return false; }
    /// Improves the accelerations of bodies with which the last load was computed. False where it has no improvement.
    /// @param residual  the accelerations by that load less these
    virtual bool correct(const body::BodySet& /*bodies*/, const body::BodyKinematics& /*kinematics*/,
                         std::span<const std::uint8_t> /*is_sought*/, std::span<const body::Acceleration> /*residual*/,
                         std::vector<body::Acceleration>& /*guess*/) {
        return false;
    }
};

}  // namespace riprap::coupling
