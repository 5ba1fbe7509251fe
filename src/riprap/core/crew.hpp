// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

// The threads of the host behind core/parallel. Included by parallel.cpp alone.

namespace riprap::parallel::detail {

/// Decides how a thread waits for what is due within microseconds: by looking again and again, which wakes it at once
/// but keeps a core from others, or asleep. It looks for as long as waking takes, and only while looking has mostly
/// been enough: where other programs want the cores, what it waits for is itself waiting for a core.
class Patience {
 public:
    /// Looks until `is_there()`, for some 100 us at most, and returns whether it came. Where waits like this one have
    /// mostly been in vain, returns at once.
    template <class IsThere>
    bool look(const IsThere& is_there) {
        if (trust_ == 0 && ++refusals_ % probe_every != 0) {
            return is_there();
        }
        const bool came = look_for_a_while(is_there);
        trust_ = came ? (trust_ < most_trust ? trust_ + 1 : most_trust) : (trust_ > 0 ? trust_ - 1 : 0);
        return came;
    }

 private:
    template <class IsThere>
    static bool look_for_a_while(const IsThere& is_there) {
        const std::int64_t end = nanoseconds() + longest;
        do {
            for (int k = 0; k < 32; ++k) {
                if (is_there()) {
                    return true;
                }
                pause();
            }
        } while (nanoseconds() < end);
        return false;
    }
    static std::int64_t nanoseconds();
    static void pause();

    static constexpr std::int64_t longest = 100'000;  ///< of looking [ns]: about what it takes to wake a thread
    static constexpr int most_trust = 8;              ///< failures in a row after which a thread sleeps at once
    static constexpr unsigned probe_every = 64;       ///< waits, after which one that sleeps at once looks again
    int trust_{most_trust};
    unsigned refusals_{0};
};

/// Threads that stay between loops and take part in the next one if they come in time: the caller works from the start,
/// and waits only for those that have begun, so a thread that wakes late, or is gone after fork(), delays nothing.
class Crew {
 public:
    /// A loop over chunks: body(context, chunk) for each, in any order.
    struct Job {
        std::int64_t chunk_count;
        void (*body)(void*, std::int64_t);
        void* context;
    };

    /// Returns the crew of the process, which is never destroyed: its threads end with the process.
    static Crew& of_process();
    /// Runs the job on up to `team` threads, one of them the caller's, who enters with share 0. Where the crew is busy
    /// with the job of another thread, or the caller is of the crew, the caller does it alone.
    void run(int team, const Job& job);

 private:
    /// Contiguous chunks that one thread begins with; others help once through with their own.
    struct alignas(64) Share {
        std::atomic<std::int64_t> next{0};
        std::int64_t end{0};
    };

    void hire(int count);
    void serve(int thread);
    void work(int thread);
    void open();
    void close();

    // The gate: number of the job, whether it takes threads in, how many are inside.
    static constexpr std::uint32_t open_bit = 1U << 11, inside_mask = open_bit - 1, job_shift = 12;
    static bool is_open(std::uint32_t gate) { return (gate & open_bit) != 0; }
    static std::uint32_t number_of(std::uint32_t gate) { return gate >> job_shift; }

    alignas(64) std::atomic<std::uint32_t> gate_{0};
    alignas(64) std::atomic<std::uint32_t> left_{0};  ///< number of the last job that a thread was the last to leave
    alignas(64) std::atomic<bool> is_busy_{false};
    Patience patience_;  ///< of the caller
    Job job_{};
    int team_{0};
    int hired_{0};
    std::vector<Share> shares_;
};

}  // namespace riprap::parallel::detail
