// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/parallel.hpp"

#include <array>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>

#if defined(RIPRAP_OPENMP)
#include <omp.h>
#endif

namespace riprap::parallel {

namespace {
/// Nothing else is told by it, and no result depends on it: any order of its reads and writes will do.
std::atomic<int> threads{1};
}  // namespace

int thread_count() { return threads.load(std::memory_order_relaxed); }
const char* backend_name() {
#if defined(RIPRAP_OPENMP)
    return "OpenMP";
#else
    return "serial";
#endif
}
void set_thread_count(int count) { threads.store(std::max(1, count), std::memory_order_relaxed); }

namespace detail {

namespace {
/// Keeps the exception of the first chunk, in order of index, that threw: the one a single thread would have met.
class FirstFailure {
 public:
    void store(std::int64_t chunk) {
        const std::lock_guard lock(mutex_);
        if (chunk < chunk_) {
            chunk_ = chunk;
            failure_ = std::current_exception();
        }
    }
    void rethrow() const {
        if (failure_) {
            std::rethrow_exception(failure_);
        }
    }

 private:
    std::mutex mutex_;
    std::int64_t chunk_{std::numeric_limits<std::int64_t>::max()};
    std::exception_ptr failure_;
};

#if defined(RIPRAP_OPENMP)
/// For uneven loops: chunks shared out so that a thread meets the same part of the data in loop after loop, where its
/// own cache may still hold what it wrote: each thread has a contiguous share and, once through with it, helps with
/// those that follow.
class Shares {
 public:
    Shares(std::int64_t chunk_count, int team) : shares_(static_cast<std::size_t>(team)) {
        for (std::int64_t thread = 0; thread < team; ++thread) {
            Share& share = shares_[static_cast<std::size_t>(thread)];
            share.next.store(chunk_count * thread / team, std::memory_order_relaxed);
            share.end = chunk_count * (thread + 1) / team;
        }
    }
    /// run(chunk) until none is left in any share. Every share is emptied even if fewer threads came than were asked
    /// for.
    template <class F>
    void work(int thread, const F& run) {
        for (std::size_t k = 0; k < shares_.size(); ++k) {
            Share& share = shares_[(static_cast<std::size_t>(thread) + k) % shares_.size()];
            for (;;) {
                const std::int64_t chunk = share.next.fetch_add(1, std::memory_order_relaxed);
                if (chunk >= share.end) {
                    break;
                }
                run(chunk);
            }
        }
    }

 private:
    struct alignas(64) Share {  // a cache line each
        std::atomic<std::int64_t> next;
        std::int64_t end;
    };
    std::vector<Share> shares_;
};
#endif
}  // namespace

void run_chunks(std::int64_t chunk_count, bool is_dynamic, void (*body)(void*, std::int64_t), void* context) {
#if defined(RIPRAP_OPENMP)
    const int team = thread_count();
    if (team > 1 && chunk_count > 1 && omp_in_parallel() == 0) {
        FirstFailure failure;
        const auto run_one = [&](std::int64_t chunk) {
            try {
                body(context, chunk);
            } catch (...) {  // may not leave a parallel region
                failure.store(chunk);
            }
        };
        if (is_dynamic) {
            Shares shares(chunk_count, team);
#pragma omp parallel num_threads(team)
            shares.work(omp_get_thread_num(), run_one);
        } else {
#pragma omp parallel for schedule(static) num_threads(team)
            for (std::int64_t chunk = 0; chunk < chunk_count; ++chunk) {
                run_one(chunk);
            }
        }
        failure.rethrow();
        return;
    }
#endif
    (void)is_dynamic;
    for (std::int64_t chunk = 0; chunk < chunk_count; ++chunk) {
        body(context, chunk);
    }
}
}  // namespace detail

void sort_by_key(std::vector<std::uint64_t>& keys, std::vector<std::uint32_t>& values,
                 std::vector<std::uint64_t>& scratch_keys, std::vector<std::uint32_t>& scratch_values) {
    constexpr int radix_bits = 8;
    constexpr std::size_t bin_count = 1U << radix_bits;
    using Bins = std::array<std::size_t, bin_count>;
    const auto n = static_cast<std::int64_t>(keys.size());
    const std::int64_t grain = 1 << 15;
    const auto chunk_count = static_cast<std::size_t>((n + grain - 1) / grain);
    scratch_keys.resize(keys.size());
    scratch_values.resize(values.size());

    std::uint64_t differing = 0;
    for (const std::uint64_t key : keys) {
        differing |= key ^ keys.front();
    }
    std::vector<Bins> bins(chunk_count);
    for (int shift = 0; shift < 64; shift += radix_bits) {
        if (((differing >> shift) & (bin_count - 1)) == 0) {
            continue;
        }
        const auto bin_of = [shift](std::uint64_t key) {
            return static_cast<std::size_t>((key >> shift) & (bin_count - 1));
        };
        detail::for_chunks(n, grain, false, [&](std::int64_t begin, std::int64_t end) {
            Bins& count = bins[static_cast<std::size_t>(begin / grain)];
            count.fill(0);
            for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
                ++count[bin_of(keys[i])];
            }
        });
        std::size_t start = 0;
        for (std::size_t bin = 0; bin < bin_count; ++bin) {
            for (Bins& count : bins) {
                const std::size_t next = start + count[bin];
                count[bin] = start;
                start = next;
            }
        }
        detail::for_chunks(n, grain, false, [&](std::int64_t begin, std::int64_t end) {
            Bins& place = bins[static_cast<std::size_t>(begin / grain)];
            for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
                const std::size_t to = place[bin_of(keys[i])]++;
                scratch_keys[to] = keys[i];
                scratch_values[to] = values[i];
            }
        });
        keys.swap(scratch_keys);
        values.swap(scratch_values);
    }
}

}  // namespace riprap::parallel
