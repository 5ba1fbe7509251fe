// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numeric>

#include "riprap/core/range.hpp"

namespace riprap {
namespace {

/// Memory of the host that stands for a device's and counts what is copied.
class OtherMemory final : public DeviceMemory {
 public:
    void* allocate(std::size_t bytes) override {
        ++held;
        return std::malloc(bytes);
    }
    void release(void* memory) noexcept override {
        --held;
        std::free(memory);
    }
    void upload(void* device, const void* host, std::size_t bytes) override {
        ++uploads;
        std::memcpy(device, host, bytes);
    }
    void download(void* host, const void* device, std::size_t bytes) override {
        ++downloads;
        std::memcpy(host, device, bytes);
    }
    int held{0}, uploads{0}, downloads{0};
};

/// A loop as a device would take it: a named functor over spans.
struct Double {
    std::span<const double> in;
    std::span<double> out;
    void operator()(std::int64_t i) const { out[static_cast<std::size_t>(i)] = 2 * in[static_cast<std::size_t>(i)]; }
};

TEST(Field, StepsThatStayOnADeviceCopyOnceInAndOnceOut) {
    OtherMemory memory;
    {
        Field<double> x({1, 2, 3}, &memory), y(3, &memory);
        for (int step = 0; step < 5; ++step) {
            const Double loop{x.read(Residence::device), y.overwrite(Residence::device)};
            parallel::for_each(parallel::Range{0, 3}, loop);
            x.swap(y);
        }
        EXPECT_EQ(memory.uploads, 1);
        EXPECT_EQ(memory.downloads, 0);
        EXPECT_FALSE(x.is_in(Residence::host));
        const std::span<const double> here = x.read(Residence::host);
        EXPECT_EQ(std::vector<double>(here.begin(), here.end()), (std::vector<double>{32, 64, 96}));
        EXPECT_EQ(memory.downloads, 1);
    }
    EXPECT_EQ(memory.held, 0);
}

TEST(Field, AChangeOnOneSideIsSeenOnTheOther) {
    OtherMemory memory;
    Field<int> x({1, 2}, &memory);
    x.read(Residence::device);
    x.change(Residence::host)[1] = 7;
    EXPECT_FALSE(x.is_in(Residence::device));
    EXPECT_EQ(x.read(Residence::device)[1], 7);
    x.change(Residence::device)[0] = 5;
    EXPECT_EQ(x.read(Residence::host)[0], 5);
    EXPECT_EQ(memory.uploads, 2);
    EXPECT_EQ(memory.downloads, 1);
}

TEST(Field, OnTheHostAloneNeedsNoDevice) {
    Field<int> x({1, 2});
    EXPECT_EQ(x.change(Residence::host)[1], 2);
    Field<int> none;
    EXPECT_TRUE(none.read(Residence::host).empty());
}

/// Sums whose order shows in their bits.
double value(std::int64_t i) { return std::sin(static_cast<double>(i)) * std::pow(10.0, static_cast<double>(i % 13)); }

TEST(Range, RanksThatMeetAtABlockFoldToTheBitsOfOneMachine) {
    constexpr std::int64_t n = 30'001;
    const auto add = [](double a, double b) { return a + b; };
    const double whole = parallel::reduce(n, 0.0, value, add);
    EXPECT_EQ(parallel::reduce(parallel::Range{0, n}, 0.0, value, add), whole);
    double folded = 0;
    const std::int64_t cut = 3 * parallel::reduce_block;
    for (const parallel::Range rank : {parallel::Range{0, cut}, parallel::Range{cut, n}}) {
        parallel::reduce_blocks(rank, 0.0, value, add, [&](std::int64_t, double sum) { folded += sum; });
    }
    EXPECT_EQ(folded, whole);
    std::vector<double> all(n);
    for (std::int64_t i = 0; i < n; ++i) {
        all[static_cast<std::size_t>(i)] = value(i);
    }
    EXPECT_NE(std::accumulate(all.begin(), all.end(), 0.0), whole) << "the order of the sum does not show";
}

TEST(Range, ALoopTouchesWhatItOwnsAndNoGhost) {
    std::vector<int> touched(3000, 0);
    parallel::for_each(parallel::Range{100, 2900}, [&](std::int64_t i) { ++touched[static_cast<std::size_t>(i)]; });
    for (std::size_t i = 0; i < touched.size(); ++i) {
        ASSERT_EQ(touched[i], i >= 100 && i < 2900 ? 1 : 0) << i;
    }
}

}  // namespace
}  // namespace riprap
