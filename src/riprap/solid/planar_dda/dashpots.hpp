// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/planar_dda/step.hpp"

// Dashpots of contacts, right for the step that is taken. The force of a spring at the end of a step acts during the
// whole of it, which is the force at its middle and a dashpot of k dt/2. So much is taken off the dashpot of the
// material, and what an impact gives back is what the material says, whatever the step.

namespace riprap::solid::planar_dda {

/// Sets the dashpots of all contacts whose materials have a damping ratio z: c = 2 z sqrt(k m) - k dt/2, m the mass
/// that the contact point bears of its pair. Less than nothing in an impact alone; what rests is damped by k dt/2 at
/// least.
void set_dashpots(const Model& model, const State& state, const Vec2& gravity, double dt,
                  std::vector<Contact>& contacts);

/// Finds a contact whose impact needs shorter steps than the one just taken, among those whose materials have a damping
/// ratio. @returns its number, -1 = none
std::int64_t find_unresolved_impact(const Model& model, const State& state, const Vec2& gravity, double dt,
                                    const Scratch& scratch);

}  // namespace riprap::solid::planar_dda
