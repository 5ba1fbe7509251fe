// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/run/remedy/refused.hpp"

namespace riprap::run {

/// Names the stiffness that carries what the deepest contact of a refused step has to carry, "key = value", or what
/// else has to change where no stiffness would do:
///
///     factor = reserve E/C(d),   E = sum of m |v|^2/2 + M g max(0, d - s) + C(s).
///
/// E is what the bodies on the lighter side of the contact bring against the other side, with all free bodies that they
/// touch, v against the other side, M their mass, and what the contact has stored already at its overlap s [J]; d is
/// the overlap that is allowed. C is the energy of a spring through the force F at s, F/s d^2/2, or that of a flat
/// contact where that is less: dashpots are part of F. A driven body that moves on brings energy without end: then its
/// motion has to stop.
std::string stiffness_advice(const Refused& refused, double allowed_share);

}  // namespace riprap::run
