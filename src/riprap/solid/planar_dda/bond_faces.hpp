// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/planar_dda/contacts.hpp"

namespace riprap::solid::planar_dda {

/// Closes and bonds the contacts of faces that touch at the start, within Contact::bond_slip, and whose surfaces have
/// cohesion or tensile strength.
void bond_faces(const Model& model, const Settings& settings, State& state);

}  // namespace riprap::solid::planar_dda
