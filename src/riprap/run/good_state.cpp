// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/good_state.hpp"

#include "riprap/run/step_choice.hpp"

namespace riprap::run {

sim::State GoodState::at(const sim::Model& model, std::int64_t step) const {
    sim::State state = standing_->state;
    sim::Scratch scratch;
    while (state.step < step) {
        advance(model, state, scratch, choose_step(model, state, scratch).dt, sim::Measure::flow);
    }
    return state;
}

}  // namespace riprap::run
