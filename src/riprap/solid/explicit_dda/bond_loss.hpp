// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/explicit_dda/advance.hpp"

namespace riprap::solid::explicit_dda {

/// Tells whether a bond has broken in this step by sliding.
inline bool has_sheared(const ContactForce& found) {
    return found.was_intact && found.answer.is_sliding && !found.answer.is_intact;
}

/// Tells whether a bond that was there the step before has opened in this one and broken.
inline bool has_torn(const affine::BlockContact& contact, const ContactForce& found) {
    return found.was_intact && found.answer.is_open && !found.is_apart && contact.old >= 0;
}

/// Energy that the springs of bonds gave up as these broke in the last step, apart from all losses of its StepReport
/// [J].
double bond_loss(const Scratch& scratch, const State& state);

}  // namespace riprap::solid::explicit_dda
