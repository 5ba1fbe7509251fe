// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/machine.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>

#include "riprap/bench/benches.hpp"
#include "riprap/bench/machine_kernels.hpp"
#include "riprap/bench/measure.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::bench {

namespace {

constexpr std::int64_t triad_chunk = 1 << 17;  // [entries]

/// Entries of one of the three arrays: 320 MB where an eighth of the memory allows.
std::int64_t triad_entries() {
    const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    return static_cast<std::int64_t>(std::min(320e6, memory / 24) / sizeof(double));
}

double measure_triad() {
    const std::int64_t n = triad_entries();
    const auto entries = static_cast<std::size_t>(n);
    // Not initialised here: pages belong to the thread that first writes them.
    const std::unique_ptr<double[]> a(new double[entries]), b(new double[entries]), c(new double[entries]);
    parallel::for_ranges(n, triad_chunk, [&](std::int64_t begin, std::int64_t end) {
        std::fill(a.get() + begin, a.get() + end, 0.0);
        std::fill(b.get() + begin, b.get() + end, 1.0);
        std::fill(c.get() + begin, c.get() + end, 2.0);
    });
    const auto pass = [&] {
        parallel::for_ranges(n, triad_chunk, [&](std::int64_t begin, std::int64_t end) {
            triad(a.get(), b.get(), c.get(), 3.0, begin, end);
        });
    };
    return 24.0 * static_cast<double>(n) / time_calls(pass, {7, 0.2}).low;
}

double measure_fma(double (*run)(std::int64_t, double&)) {
    const int threads = parallel::thread_count();
    constexpr std::int64_t rounds = 2'000'000;
    std::vector<double> sink(static_cast<std::size_t>(threads), 0.0);
    double flops = 0;
    const auto pass = [&] {
        std::vector<double> done(static_cast<std::size_t>(threads), 0.0);
        parallel::for_each_uneven(threads, 1, [&](std::int64_t t) {
            const auto i = static_cast<std::size_t>(t);
            done[i] = run(rounds, sink[i]);
        });
        flops = 0;
        for (const double d : done) {
            flops += d;
        }
    };
    const Timing timing = time_calls(pass, {9, 0.1});
    return flops / timing.low;
}

}  // namespace

MachineLimits measure_machine(const std::vector<int>& thread_counts) {
    MachineLimits limits;
    for (const int threads : thread_counts) {
        const ThreadScope scope(threads);
        limits.by_threads.push_back(
            {threads, measure_triad(), measure_fma(run_fma_double), measure_fma(run_fma_single)});
    }
    return limits;
}

void machine(const Setting& setting, std::vector<Result>& results) {
    for (const ThreadLimits& limits : setting.machine.by_threads) {
        const auto share = [&](double value, double reference) {
            return limits.threads == 1 ? fmt::format("{:.2f} of a core of the reference machine", value / reference)
                                       : std::string{};
        };
        results.push_back(
            {"machine.triad", limits.threads, limits.triad * 1e-9, "GB/s", share(limits.triad, reference_core.triad)});
        results.push_back({"machine.fma_double", limits.threads, limits.fma_double * 1e-9, "GFLOP/s",
                           share(limits.fma_double, reference_core.fma_double)});
        results.push_back({"machine.fma_single", limits.threads, limits.fma_single * 1e-9, "GFLOP/s",
                           share(limits.fma_single, reference_core.fma_single)});
    }
}

}  // namespace riprap::bench
