// SPDX-License-Identifier: Apache-2.0
#pragma once

// The table of quantities and what is behind its lines: for the sources of this folder only.

#include <span>

#include "riprap/sim/quantity.hpp"

namespace riprap::sim {

/// A line of the table together with the function behind it. Exactly one of the two functions is set.
struct Quantity {
    QuantityInfo info;
    Vec3 (*of_body)(const Moment&, BodyId);
    Vec3 (*of_scene)(const Moment&);
};

/// In the order in which the manual prints them.
std::span<const Quantity> body_quantities();
std::span<const Quantity> scene_quantities();

}  // namespace riprap::sim
