// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/misfit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "riprap/core/index.hpp"

namespace riprap::solid::affine {

std::string misfit(const BlockState& blocks, const BlockContactHistory& contacts, std::int32_t bodies) {
    const std::size_t count = at(bodies), points = contacts.size();
    if (blocks.position.size() != count || blocks.velocity.size() != count || blocks.deformation.size() != 3 * count ||
        blocks.velocity_gradient.size() != 3 * count || blocks.stress.size() != 3 * count) {
        return fmt::format("there are {} blocks of {} bodies", blocks.position.size(), bodies);
    }
    if (contacts.feature.size() != points || contacts.plane.size() != points || contacts.normal.size() != points ||
        contacts.slip.size() != points || contacts.mode.size() != points || contacts.is_intact.size() != points ||
        contacts.plastic_slip.size() != points || contacts.energy.size() != points) {
        return "the arrays of the contacts differ in length";
    }
    const auto is_of_bodies = [count](std::uint64_t pair) {
        return pair >> 32U < count && (pair & 0xFFFFFFFFU) < count;
    };
    if (!std::ranges::all_of(contacts.pair, is_of_bodies) || !std::ranges::all_of(contacts.bonded, is_of_bodies)) {
        return fmt::format("a contact is of a block beyond the {} that there are", bodies);
    }
    return "";
}

}  // namespace riprap::solid::affine
