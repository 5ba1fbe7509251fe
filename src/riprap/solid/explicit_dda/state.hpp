// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/affine/block_state.hpp"

namespace riprap::solid::explicit_dda {

struct State {
    affine::BlockState blocks;
    affine::BlockContactHistory contacts;
    double last_dt{0};  ///< length of the last step; slip counts from mid-step to mid-step [s]

    friend bool operator==(const State&, const State&) = default;
    template <class Self, class Visit>
    static void visit_fields(Self& self, Visit&& visit) {
        affine::BlockState::visit_fields(self.blocks, visit);
        affine::BlockContactHistory::visit_fields(self.contacts, visit);
        visit("explicit_dda.last_dt", self.last_dt);
    }
};

}  // namespace riprap::solid::explicit_dda
