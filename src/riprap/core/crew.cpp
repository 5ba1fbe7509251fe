// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/crew.hpp"

#include <pthread.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <system_error>
#include <thread>

namespace riprap::parallel::detail {

namespace {

thread_local bool is_at_work = false;  ///< in a loop: those inside of it run on this thread

/// Keeps signals away from threads started meanwhile: they are for the thread that steps.
class SignalsBlocked {
 public:
    SignalsBlocked() {
        sigset_t all;
        sigfillset(&all);
        pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsBlocked(const SignalsBlocked&) = delete;
    SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
    sigset_t before_;
};

}  // namespace

std::int64_t Patience::nanoseconds() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

void Patience::pause() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

Crew& Crew::of_process() {
    static Crew& crew = *new Crew;
    return crew;
}

void Crew::run(int team, const Job& job) {
    if (is_at_work || is_busy_.exchange(true, std::memory_order_acquire)) {
        for (std::int64_t chunk = 0; chunk < job.chunk_count; ++chunk) {
            job.body(job.context, chunk);
        }
        return;
    }
    is_at_work = true;
    team_ = static_cast<int>(std::min<std::int64_t>(team, std::min<std::int64_t>(job.chunk_count, inside_mask)));
    job_ = job;
    hire(team_ - 1);
    if (shares_.size() < static_cast<std::size_t>(team_)) {
        shares_ = std::vector<Share>(static_cast<std::size_t>(team_));
    }
    for (std::int64_t thread = 0; thread < team_; ++thread) {
        Share& share = shares_[static_cast<std::size_t>(thread)];
        share.next.store(job.chunk_count * thread / team_, std::memory_order_relaxed);
        share.end = job.chunk_count * (thread + 1) / team_;
    }
    open();
    work(0);
    close();
    is_at_work = false;
    is_busy_.store(false, std::memory_order_release);
}

void Crew::hire(int count) {
    if (hired_ >= count) {
        return;
    }
    const SignalsBlocked blocked;
    try {
        while (hired_ < count) {
            std::thread(&Crew::serve, this, hired_ + 1).detach();
            ++hired_;
        }
    } catch (const std::system_error&) {
        // The system gives no more threads: those that are there do the work.
    }
}

void Crew::open() {
    left_.store(~0U, std::memory_order_relaxed);  // numbers come again after a million jobs
    gate_.store((number_of(gate_.load(std::memory_order_relaxed)) + 1) << job_shift | open_bit,
                std::memory_order_release);
    gate_.notify_all();
}

void Crew::close() {
    const std::uint32_t gate = gate_.fetch_and(~open_bit, std::memory_order_acq_rel);
    if ((gate & inside_mask) == 0) {
        return;
    }
    const std::uint32_t number = number_of(gate);
    const auto is_left = [&] { return left_.load(std::memory_order_acquire) == number; };
    while (!patience_.look(is_left)) {
        if (const std::uint32_t seen = left_.load(std::memory_order_acquire); seen != number) {
            left_.wait(seen, std::memory_order_acquire);
        }
    }
}

void Crew::serve(int thread) {
    is_at_work = true;
    Patience patience;
    std::uint32_t served = 0;  // the first job is number 1
    for (;;) {
        std::uint32_t gate = gate_.load(std::memory_order_acquire);
        const auto is_wanted = [&] {
            gate = gate_.load(std::memory_order_acquire);
            return is_open(gate) && number_of(gate) != served;
        };
        if (!patience.look(is_wanted)) {
            if (!is_wanted()) {
                gate_.wait(gate, std::memory_order_acquire);
            }
            continue;
        }
        if (!gate_.compare_exchange_weak(gate, gate + 1, std::memory_order_acq_rel)) {
            continue;
        }
        served = number_of(gate);
        if (thread < team_) {
            work(thread);
        }
        const std::uint32_t after = gate_.fetch_sub(1, std::memory_order_acq_rel) - 1;
        if (!is_open(after) && (after & inside_mask) == 0) {
            left_.store(served, std::memory_order_release);
            left_.notify_one();
        }
    }
}

void Crew::work(int thread) {
    const auto team = static_cast<std::size_t>(team_);
    for (std::size_t k = 0; k < team; ++k) {
        Share& share = shares_[(static_cast<std::size_t>(thread) + k) % team];
        for (;;) {
            const std::int64_t chunk = share.next.fetch_add(1, std::memory_order_relaxed);
            if (chunk >= share.end) {
                break;
            }
            job_.body(job_.context, chunk);
        }
    }
}

}  // namespace riprap::parallel::detail
