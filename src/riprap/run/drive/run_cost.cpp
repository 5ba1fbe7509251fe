// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/drive/run_cost.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <vector>

#include "riprap/run/simulate/simulation.hpp"

namespace riprap::run {

RunCost measure_cost(scene::LoadedCase loaded, double budget) {
    using Clock = std::chrono::steady_clock;
    const auto since = [](Clock::time_point begin) {
        return std::chrono::duration<double>(Clock::now() - begin).count();
    };
    Simulation simulation(std::move(loaded));
    RunCost cost;
    const sim::State& state = simulation.state();
    cost.particles = state.fluid.size();
    for (std::int32_t b = 0; b < simulation.model().bodies.size(); ++b) {
        cost.free_bodies += is_free(simulation.model().bodies, BodyId{b}, std::numeric_limits<double>::max()) ? 1 : 0;
    }
    cost.steps = simulation.steps_left();
    std::vector<double> taken;
    constexpr std::size_t least = 4;
    const Clock::time_point begin = Clock::now();
    while (simulation.steps_left() > 0 && (taken.size() < least || since(begin) < budget)) {
        const Clock::time_point before = Clock::now();
        const StepOutcome outcome = simulation.step(sim::Measure::flow);
        if (outcome.kind == StepOutcome::Kind::refused) {
            cost.refusal = outcome.why.with_remedy();
            break;
        }
        taken.push_back(since(before));
    }
    if (taken.size() > 1) {
        taken.erase(taken.begin());
    }
    if (!taken.empty()) {
        const auto middle = taken.begin() + static_cast<std::ptrdiff_t>(taken.size() / 2);
        std::nth_element(taken.begin(), middle, taken.end());
        cost.seconds_per_step = *middle;
    }
    return cost;
}

}  // namespace riprap::run
