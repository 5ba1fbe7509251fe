// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/planar_dda/bond_faces.hpp"

#include <cmath>

#include "riprap/solid/planar_dda/contact_scene.hpp"
#include "riprap/solid/planar_dda/move_blocks.hpp"

namespace riprap::solid::planar_dda {

void bond_faces(const Model& model, const Settings& settings, State& state) {
    if (!model.surfaces.have_bonds()) {
        return;
    }
    std::vector<Vec2> corners;
    ContactSearch search;
    std::vector<Contact> contacts;
    place_corners(model, state, corners);
    find_contacts(model, state, settings, corners, search, contacts);
    clear_contacts(state);
    for (const Contact& contact : contacts) {
        const bool is_on_edge = contact.foot >= -foot_slack && contact.foot <= 1 + foot_slack;
        if (contact.joint.has_bond() && !contact.is_round && is_on_edge &&
            std::abs(contact.gap.value) <= contact.bond_slip) {
            keep_contact(contact, {.mode = Mode::locked, .is_bonded = true}, contact.foot, state);
        }
    }
}

}  // namespace riprap::solid::planar_dda
