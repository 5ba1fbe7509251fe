// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <utility>
#include <vector>

#include "riprap/core/parallel.hpp"
#include "riprap/core/timer.hpp"

namespace riprap::bench {

namespace {
Timing timing_of(std::vector<double> values) {
    std::ranges::sort(values);
    return {values[values.size() / 2], values.front(), values.back(), static_cast<int>(values.size())};
}
}  // namespace

double now(Clock clock) {
    static const Timer timer;
    return clock == Clock::wall ? timer.seconds() : static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double now() { return now(parallel::thread_count() == 1 ? Clock::processor : Clock::wall); }

Timing time_calls(const std::function<void()>& call, const Repeat& repeat) {
    call();
    std::vector<double> times;
    const double start = now();
    while (static_cast<int>(times.size()) < repeat.least_calls || now() - start < repeat.least_seconds) {
        const double before = now();
        call();
        times.push_back(now() - before);
    }
    return timing_of(std::move(times));
}

Timing compare_calls(const std::function<void()>& first, const std::function<void()>& second, int pair_count,
                     Clock clock) {
    const auto time = [clock](const std::function<void()>& call) {
        const double before = now(clock);
        call();
        return now(clock) - before;
    };
    return compare_seconds([&] { return time(first); }, [&] { return time(second); }, pair_count);
}

Timing compare_seconds(const std::function<double()>& first, const std::function<double()>& second, int pair_count) {
    first();
    second();
    std::vector<double> ratios;
    for (int pair = 0; pair < pair_count; ++pair) {
        const double seconds_of_first = first(), seconds_of_second = second();
        ratios.push_back(seconds_of_first / std::max(1e-9, seconds_of_second));
    }
    return timing_of(std::move(ratios));
}

Timing each_of(Timing timing, double count) {
    return {timing.median / count, timing.low / count, timing.high / count, timing.count};
}

void add_speedup(const std::string& name, int threads, const std::function<void()>& one,
                 const std::function<void()>& many, std::vector<Result>& results, int pair_count) {
    const auto with = [](int count, const std::function<void()>& work) {
        const ThreadScope scope(count);
        work();
    };
    const Timing ratio = compare_calls([&] { with(1, one); }, [&] { with(threads, many); }, pair_count);
    results.push_back({name + ".speedup", threads, ratio.median, "-",
                       fmt::format("over one thread, in turn on the wall; {}", spread(ratio))});
}

std::string spread(const Timing& timing) {
    const auto percent = [&](double t) { return 100 * (t / timing.median - 1); };
    return fmt::format("median of {}, spread {:.0f} % +{:.0f} %", timing.count, percent(timing.low),
                       percent(timing.high));
}

ThreadScope::ThreadScope(int count) : before_(parallel::thread_count()) { parallel::set_thread_count(count); }
ThreadScope::~ThreadScope() { parallel::set_thread_count(before_); }

}  // namespace riprap::bench
