// SPDX-License-Identifier: Apache-2.0
#include "riprap/run/drive/run_cost.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

#include "riprap/run/simulate/simulation.hpp"

namespace riprap::run {

namespace {

/// Steps to the end at the mean length of the later half of those taken, whose times are `times`: the first ones of
/// water that starts from rest may be much longer or shorter.
std::int64_t steps_left_of(const Simulation& simulation, const std::vector<double>& times) {
    const std::size_t last = times.size() - 1, middle = last / 2;
    const double way = times[last] - times[middle];
    if (!(way > 0)) {
        return simulation.steps_left();
    }
    const double left = (simulation.end() - times[last]) * static_cast<double>(last - middle) / way;
    const auto steps = static_cast<std::int64_t>(std::ceil(std::clamp(left, 0.0, 1e15)));
    const std::int64_t most = simulation.model().time.max_steps;
    return most >= 0 ? std::clamp<std::int64_t>(most - simulation.state().step, 0, steps) : steps;
}

}  // namespace

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
    std::vector<double> taken, times{state.time};
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
        times.push_back(state.time);
    }
    cost.steps = state.step + steps_left_of(simulation, times);
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
