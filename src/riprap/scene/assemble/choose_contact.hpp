// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace riprap::scene {

struct CaseBuild;

/// Fills the contact stiffness, the time step and the modulus that a case leaves to its blocks
/// (solid::affine::default_scales), and notes them with what they follow from; after bodies, loads and supports.
void choose_contact(CaseBuild& build);

}  // namespace riprap::scene
