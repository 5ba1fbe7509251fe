// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/body/loads.hpp"
#include "riprap/core/step.hpp"
#include "riprap/solid/solid_scene.hpp"

namespace riprap::solid {

/// A way in which solids move: the verbs that the driver of a step calls, a few times a step. An object is bound to
/// Model, State and Scratch for one step. Whatever the method, the bodies of the State say where every point is,
/// x = x_c + R U X, and how it moves; other fields are the method's own. What a method says of itself before any step
/// is in its SolidTraits.
class SolidMethod {
 public:
    virtual ~SolidMethod() = default;
    /// Returns the step that the method allows or, where it is implicit, wants for itself.
    virtual StepLimit limit() const = 0;
    /// Returns the step that it allows whatever touches later in the step: for a step of the fluid, which is shared out
    /// at its beginning.
    virtual StepLimit lasting_limit() const { return limit(); }
    /// May a refused piece have changed the State, and does a shorter one help?
    virtual bool takes_back() const { return false; }
    /// Moves the bodies over a piece of a step under loads that are held over it. A step may be taken on trial and
    /// taken back: it changes bodies, contact history and own fields of the State alone.
    virtual Outcome advance(const TimeSpan& span, const body::LoadView& loads, Measure measure,
                            SolidReport& report) = 0;
};

}  // namespace riprap::solid
