// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/simulate/good_state.hpp"

namespace riprap::run {

void GoodState::keep(Standing standing) {
    standing_ = std::make_shared<const Standing>(std::move(standing));
    steps_.clear();
}

sim::State GoodState::now(const sim::Model& model) const {
    sim::State state = last().state;
    sim::Scratch scratch;
    for (const double dt : steps_) {
        advance(model, state, scratch, dt, sim::Measure::flow);
    }
    return state;
}

}  // namespace riprap::run
