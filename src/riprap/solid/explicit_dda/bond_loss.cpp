// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/explicit_dda/bond_loss.hpp"

#include "riprap/core/index.hpp"
#include "riprap/solid/affine/bonds.hpp"

namespace riprap::solid::explicit_dda {

double bond_loss(const Scratch& scratch, const State& state) {
    if (!affine::has_intact(scratch.old)) {
        return 0;
    }
    double sum = 0;
    for (std::size_t i = 0; i < scratch.forces.size(); ++i) {
        const ContactForce& found = scratch.forces[i];
        const affine::BlockContact& contact = scratch.contacts()[i];
        sum += has_sheared(found) ? found.answer.friction_loss : 0;
        sum += has_torn(contact, found) ? scratch.old.energy[at(contact.old)] : 0;
    }
    for (std::size_t row = 0; row < scratch.old.size(); ++row) {
        const bool is_gone = scratch.is_carried[row] == 0 && has_come_apart(scratch.old, row, state.contacts);
        sum += is_gone ? scratch.old.energy[row] : 0;
    }
    return sum;
}

}  // namespace riprap::solid::explicit_dda
