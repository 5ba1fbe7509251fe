// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "riprap/run/remedy/refused.hpp"

namespace riprap::run {

/// Names a shorter step of the solids: "auto" for one that the case fixes above its bound, else a quarter of the
/// `time_step`, the `solid.step` or the `time_step_factor` that there is.
std::string shorter_step(const Refused& refused);

/// Names what the miss of a ledger follows from, first that which explains the rest: a step above its bound, a contact
/// as deep as a third of a block, a tolerance below what the methods give by default, water, bodies.
std::string ledger_advice(const Refused& refused);

/// Names what water made energy by: it is pressed together, or its step is too long for what it does.
std::string made_advice(const Refused& refused);

/// Names the sound speed for the speed that the water comes to, ten times as fast [Monaghan1994]: it may fall by its
/// whole height yet.
std::string faster_sound(const Refused& refused);

/// Returns the speed of the fastest fluid, before and in the refused step [m/s].
double fastest_fluid(const Refused& refused);

}  // namespace riprap::run
