// SPDX-License-Identifier: Apache-2.0
#pragma once

// The table of quantities and what is behind its lines: for the sources of this folder only.

#include <span>

#include "riprap/sim/quantity.hpp"

namespace riprap::sim {

/// A line of the table together with the function behind it. Exactly one of the first two functions is set.
struct Quantity {
    QuantityInfo info;
    Vec3 (*of_body)(const Moment&, BodyId);
    Vec3 (*of_scene)(const Moment&);
    /// Of a point of a body, in its frame from its centre of mass; nullptr where the quantity is of bodies as a whole.
    Vec3 (*of_point)(const Moment&, BodyId, const Vec3&){nullptr};
};

/// In the order in which the manual prints them.
std::span<const Quantity> body_quantities();
std::span<const Quantity> scene_quantities();

}  // namespace riprap::sim
