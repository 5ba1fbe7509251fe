// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <thread>
#include <vector>

#include "riprap/core/crew.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::parallel {
namespace {

/// Sets the number of threads for one test.
struct Threads {
    explicit Threads(int count) { set_thread_count(count); }
    ~Threads() { set_thread_count(1); }
};

/// Sums i over [0, n) by a loop whose chunks are `grain` long.
std::int64_t sum_by_loop(std::int64_t n, std::int64_t grain) {
    std::vector<std::int64_t> of_chunk(static_cast<std::size_t>((n + grain - 1) / grain), 0);
    for_ranges(n, grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            of_chunk[static_cast<std::size_t>(begin / grain)] += i;
        }
    });
    std::int64_t sum = 0;
    for (const std::int64_t part : of_chunk) {
        sum += part;
    }
    return sum;
}

TEST(Crew, EveryChunkOfManyShortLoopsRunsOnceWhateverTheTeam) {
    for (int k = 0; k < 20'000; ++k) {
        const Threads threads(1 + k % 7);
        const std::int64_t n = 1 + k % 90;
        ASSERT_EQ(sum_by_loop(n, 1 + k % 3), n * (n - 1) / 2) << k;
    }
}

TEST(Crew, LoopsOfSeveralThreadsAtOnceDoNotMeet) {
    const Threads threads(3);
    std::atomic<int> wrong{0};
    const auto many = [&wrong] {
        for (int k = 0; k < 3'000; ++k) {
            wrong += sum_by_loop(500, 7) == 500 * 499 / 2 ? 0 : 1;
        }
    };
    std::thread other(many);
    many();
    other.join();
    EXPECT_EQ(wrong, 0);
}

TEST(Crew, AfterALoopThatThrewTheNextOneRunsAsAnyOther) {
    const Threads threads(4);
    for (int k = 0; k < 200; ++k) {
        EXPECT_THROW(for_each_uneven(100, 1, [](std::int64_t i) { i % 10 == 3 ? throw i : void(); }), std::int64_t);
        ASSERT_EQ(sum_by_loop(1000, 10), 1000 * 999 / 2);
    }
}

// Under OpenMP a child of fork() waited for threads that it did not have, forever.
TEST(Crew, AChildOfForkDoesItsLoopsAlone) {
    const Threads threads(3);
    ASSERT_EQ(sum_by_loop(1000, 10), 1000 * 999 / 2);
    const pid_t child = fork();
    if (child == 0) {
        alarm(30);
        _exit(sum_by_loop(1000, 10) == 1000 * 999 / 2 ? 0 : 1);
    }
    int status = -1;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

std::atomic<int> signals_on_others{0};
std::thread::id stepping;
void note_thread(int) { signals_on_others += std::this_thread::get_id() == stepping ? 0 : 1; }

TEST(Crew, SignalsReachTheThreadThatStepsAlone) {
    const Threads threads(3);
    ASSERT_EQ(sum_by_loop(1000, 10), 1000 * 999 / 2);
    stepping = std::this_thread::get_id();
    struct sigaction before {
    }, noted{};
    noted.sa_handler = note_thread;
    ASSERT_EQ(sigaction(SIGUSR1, &noted, &before), 0);
    for (int k = 0; k < 200; ++k) {
        ASSERT_EQ(kill(getpid(), SIGUSR1), 0);
        ASSERT_EQ(sum_by_loop(1000, 10), 1000 * 999 / 2);
    }
    sigaction(SIGUSR1, &before, nullptr);
    EXPECT_EQ(signals_on_others, 0);
}

TEST(Patience, StopsLookingWhereLookingDoesNotHelpAndTriesAgainNowAndThen) {
    detail::Patience patience;
    std::int64_t looks = 0;
    const auto never = [&looks] {
        ++looks;
        return false;
    };
    for (int k = 0; k < 8; ++k) {
        EXPECT_FALSE(patience.look(never));
    }
    looks = 0;
    for (int k = 0; k < 63; ++k) {
        EXPECT_FALSE(patience.look(never));
    }
    EXPECT_EQ(looks, 63);  // one look each
    EXPECT_FALSE(patience.look(never));
    EXPECT_GT(looks, 63 + 30);
}

TEST(Patience, ComesBackOnceLookingHelps) {
    detail::Patience patience;
    for (int k = 0; k < 8; ++k) {
        EXPECT_FALSE(patience.look([] { return false; }));
    }
    std::int64_t looks = 0;
    for (int k = 0; k < 64; ++k) {
        patience.look(
            [&looks] { return ++looks == 80; });  // in the one look of 64 that goes on, before the clock is read
    }
    looks = 0;
    EXPECT_TRUE(patience.look([&looks] { return ++looks == 20; }));
}

}  // namespace
}  // namespace riprap::parallel
