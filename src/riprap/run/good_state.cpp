// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/good_state.hpp"

namespace riprap::run {

namespace {
constexpr std::int64_t steps_between_copies = 32;
}

void GoodState::keep(const sim::State& state) {
    if (!copy_ || state.step >= copy_->step + steps_between_copies) {
        copy_ = state;
    }
}

sim::State GoodState::at(const sim::Model& model, std::int64_t step) const {
    sim::State state = *copy_;
    sim::Scratch scratch;
    while (state.step < step) {
        advance(model, state, scratch, choose_time_step(model, state, scratch).dt, sim::Measure::flow);
    }
    return state;
}

}  // namespace riprap::run
