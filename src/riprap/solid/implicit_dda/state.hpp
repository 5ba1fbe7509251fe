// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/affine/block_state.hpp"

namespace riprap::solid::implicit_dda {

struct State {
    affine::BlockState blocks;
    affine::BlockContactHistory contacts;

    friend bool operator==(const State&, const State&) = default;
    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        affine::BlockState::visit_fields(self.blocks, visit);
        affine::BlockContactHistory::visit_fields(self.contacts, visit);
    }
};

}  // namespace riprap::solid::implicit_dda
