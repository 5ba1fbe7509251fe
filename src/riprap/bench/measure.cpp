// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "riprap/core/parallel.hpp"
#include "riprap/core/timer.hpp"

namespace riprap::bench {

double now() {
    if (parallel::thread_count() == 1) {
        return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    }
    static const Timer timer;
    return timer.seconds();
}

Timing time_calls(const std::function<void()>& call, const Repeat& repeat) {
    call();
    std::vector<double> times;
    const double start = now();
    while (static_cast<int>(times.size()) < repeat.least_calls || now() - start < repeat.least_seconds) {
        const double before = now();
        call();
        times.push_back(now() - before);
    }
    std::ranges::sort(times);
    return {times[times.size() / 2], times.front(), times.back(), static_cast<int>(times.size())};
}

std::string spread(const Timing& timing) {
    const auto percent = [&](double t) { return 100 * (t / timing.median - 1); };
    return fmt::format("median of {}, spread {:.0f} % +{:.0f} %", timing.count, percent(timing.low),
                       percent(timing.high));
}

ThreadScope::ThreadScope(int count) : before_(parallel::thread_count()) { parallel::set_thread_count(count); }
ThreadScope::~ThreadScope() { parallel::set_thread_count(before_); }

}  // namespace riprap::bench
