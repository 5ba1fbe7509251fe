// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/implicit_dda/advance.hpp"

namespace riprap::solid::implicit_dda {

/// Energy of both springs of a contact that is not open [J]. One that slides holds the slip of its friction.
double spring_energy(const ContactSprings& springs, double gap, const Vec3& slip);

/// Plastic slip of a bond after the step, in all [m].
double plastic_slip(const ContactTerm& contact);

/// Tells whether a bond is intact after the step, locked, sliding or apart.
bool stays_intact(const affine::BlockContact& found, const ContactTerm& contact);

/// Elastic slip that a contact point keeps after the step [m].
Vec3 slip_kept(const affine::BlockContact& found, const ContactTerm& contact);

/// Energy that a bond gives up where the step has broken it: that of both springs as it opens, that of the shear spring
/// as it slides [J].
double bond_loss(const affine::BlockContact& found, const ContactTerm& contact);

/// Sums the energy that bonds gave up in the last step; no other loss of its StepReport includes it [J].
double bond_loss(const Scratch& scratch);

}  // namespace riprap::solid::implicit_dda
