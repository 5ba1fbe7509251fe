// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/parallel.hpp"

#include <array>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>

#include "riprap/core/crew.hpp"

namespace riprap::parallel {

namespace {
/// Nothing else is told by it, and no result depends on it: any order of its reads and writes will do.
std::atomic<int> threads{1};
}  // namespace

int thread_count() { return threads.load(std::memory_order_relaxed); }
const char* backend_name() { return "threads"; }
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

}  // namespace

void run_chunks(std::int64_t chunk_count, void (*body)(void*, std::int64_t), void* context) {
    const int team = thread_count();
    if (team <= 1 || chunk_count <= 1) {
        for (std::int64_t chunk = 0; chunk < chunk_count; ++chunk) {
            body(context, chunk);
        }
        return;
    }
    struct Guarded {
        void (*body)(void*, std::int64_t);
        void* context;
        FirstFailure failure;
    } guarded{body, context, {}};
    const auto run_one = [](void* raw, std::int64_t chunk) {
        auto& call = *static_cast<Guarded*>(raw);
        try {
            call.body(call.context, chunk);
        } catch (...) {  // may not leave a thread
            call.failure.store(chunk);
        }
    };
    Crew::of_process().run(team, {chunk_count, run_one, &guarded});
    guarded.failure.rethrow();
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
        detail::for_chunks(n, grain, [&](std::int64_t begin, std::int64_t end) {
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
        detail::for_chunks(n, grain, [&](std::int64_t begin, std::int64_t end) {
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
