// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "riprap/bench/result.hpp"

namespace riprap::bench {

/// Time on the wall, or that of the processor, which other programs on the machine hardly disturb but which adds up
/// over threads.
enum class Clock : std::uint8_t { wall, processor };
double now(Clock clock);

/// Returns a time [s]: with one thread the processor time of this process, with more that on the wall.
double now();

/// Repeated measurements of one thing: times [s], or ratios of them [-].
struct Timing {
    double median{0}, low{0}, high{0};
    int count{0};
};

/// Least repetitions of a measurement.
struct Repeat {
    int least_calls{5};
    double least_seconds{0.3};
};

/// Times `call` over and over. The first call, which grows buffers, is not counted.
Timing time_calls(const std::function<void()>& call, const Repeat& repeat = {});

/// Returns the speed of `second` over that of `first` [-]. Both are called in turn; the ratios are those of
/// neighbouring calls: a load on the machine that outlasts two calls slows both. The first call of each, which grows
/// buffers, is not counted.
Timing compare_calls(const std::function<void()>& first, const std::function<void()>& second, int pair_count = 9,
                     Clock clock = Clock::wall);

/// The same of calls that return their own seconds.
Timing compare_seconds(const std::function<double()>& first, const std::function<double()>& second, int pair_count = 9);

/// Times of one of `count` calls that were timed as one.
Timing each_of(Timing timing, double count);

/// Adds NAME.speedup: how many times as fast `many` runs with so many threads as `one` with one. Both do the same work.
void add_speedup(const std::string& name, int threads, const std::function<void()>& one,
                 const std::function<void()>& many, std::vector<Result>& results, int pair_count = 9);

/// Writes "median of 7, spread -1 % +4 %".
std::string spread(const Timing& timing);

/// Sets the number of host threads for as long as it lives.
class ThreadScope {
 public:
    explicit ThreadScope(int count);
    ~ThreadScope();
    ThreadScope(const ThreadScope&) = delete;
    ThreadScope& operator=(const ThreadScope&) = delete;

 private:
    int before_;
};

}  // namespace riprap::bench
