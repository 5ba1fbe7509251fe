// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace riprap::bench {

/// Seconds that pass: with one thread the processor time of this process, which other programs on the machine hardly
/// disturb; with more the time on the wall.
double now();

/// Repeated measurements of one thing: times [s], or ratios of them [-].
struct Timing {
    double median{0}, low{0}, high{0};
    int count{0};
};

/// How often to repeat a measurement.
struct Repeat {
    int least_calls{5};
    double least_seconds{0.3};
};

/// Times `call` over and over. The first call, which grows buffers, is not counted.
Timing time_calls(const std::function<void()>& call, const Repeat& repeat = {});

/// How many times as fast `second` is as `first` [-]. They are called in turn and timed on the wall, and the ratios are
/// those of neighbouring calls: what else keeps the machine busy for longer than two calls meets both. The first call
/// of each, which grows buffers, is not counted.
Timing compare_calls(const std::function<void()>& first, const std::function<void()>& second, int pair_count = 9);

/// "median of 7, spread -1 % +4 %"
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
