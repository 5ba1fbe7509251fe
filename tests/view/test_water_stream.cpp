// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "riprap/view/chunk.hpp"
#include "riprap/view/pack_water.hpp"
#include "view/stirred_water.hpp"
#include "view/unpack.hpp"

namespace riprap::view {
namespace {

constexpr double spacing = StirredWater::spacing;

std::vector<WaterFrame> stirred(int per_side, std::size_t frame_count) {
    StirredWater water(per_side);
    std::vector<WaterFrame> frames;
    for (std::size_t f = 0; f < frame_count; ++f) {
        water.advance(0.01);
        frames.push_back(water.shuffled());
    }
    return frames;
}

WaterSource source_of(const std::vector<WaterFrame>& frames) {
    return [&frames](std::size_t f) { return frames[f]; };
}

/// Positions of the particles of a frame by their id.
std::vector<Vec3> by_id(const WaterFrame& frame) {
    std::vector<Vec3> places(frame.id.size());
    for (std::size_t i = 0; i < frame.id.size(); ++i) {
        places[static_cast<std::size_t>(frame.id[i])] = frame.position[i];
    }
    return places;
}

/// The largest difference of a coordinate between what was packed and what comes back [m].
double largest_error(const std::vector<WaterFrame>& frames, const PackedWater& water) {
    double largest = 0;
    for (std::size_t g = 0; g < water.groups.size(); ++g) {
        const std::vector<WaterNumbers> group = decode_group(water.groups[g]);
        for (std::size_t f = 0; f < group.size(); ++f) {
            const std::vector<Vec3> places = by_id(frames[g * frames_per_group + f]);
            EXPECT_EQ(group[f].channel[0].size(), places.size());
            for (std::size_t i = 0; i < places.size(); ++i) {
                const Vec3 d = position_of(group[f], i, water.scale) - places[i];
                largest = std::max({largest, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
            }
        }
    }
    return largest;
}

TEST(WaterStream, EveryCoordinateComesBackWithinHalfAStep) {
    const std::vector<WaterFrame> frames = stirred(12, 40);
    const PackedWater water = pack_water(source_of(frames), frames.size(), spacing, 1U << 30U);
    EXPECT_DOUBLE_EQ(water.scale.step, spacing / 32);
    EXPECT_EQ(water.groups.size(), 2U);
    EXPECT_EQ(water.stride, 1U);
    EXPECT_LE(largest_error(frames, water), water.error() * (1 + 1e-9));
    EXPECT_GT(largest_error(frames, water), 0.9 * water.error());  // the bound is nearly reached
}

TEST(WaterStream, GroupsOfManyParticlesAreShortSoThatAFirstFrameIsSoonUnpacked) {
    const std::vector<WaterFrame> few = stirred(12, 30), many = stirred(60, 9);  // 216 000 particles
    const PackedWater short_ones = pack_water(source_of(many), many.size(), spacing, 1U << 30U);
    EXPECT_EQ(pack_water(source_of(few), few.size(), spacing, 1U << 30U).group_frames, frames_per_group);
    EXPECT_EQ(short_ones.group_frames, fewest_group_frames);
    EXPECT_EQ(short_ones.groups.size(), 3U);
    EXPECT_EQ(decode_group(short_ones.groups[2]).size(), 1U);
}

TEST(WaterStream, PressureAndSpeedComeBackWithinAHalfOfA255thOfTheirRange) {
    const std::vector<WaterFrame> frames = stirred(8, 3);
    const PackedWater water = pack_water(source_of(frames), frames.size(), spacing, 1U << 30U);
    const std::vector<WaterNumbers> group = decode_group(water.groups[0]);
    const WaterScale& scale = water.scale;
    const double range = scale.pressure_high - scale.pressure_low;
    for (std::size_t i = 0; i < frames[2].id.size(); ++i) {
        const auto at = static_cast<std::size_t>(frames[2].id[i]);
        const double pressure = scale.pressure_low + range * group[2].channel[3][at] / 255.0;
        const double shown =
            std::clamp(static_cast<double>(frames[2].pressure[i]), scale.pressure_low, scale.pressure_high);
        EXPECT_NEAR(pressure, shown, range / 509);
        const double speed = scale.speed_high * group[2].channel[4][at] / 255.0;
        EXPECT_NEAR(speed, std::min(static_cast<double>(frames[2].speed[i]), scale.speed_high), scale.speed_high / 509);
    }
}

TEST(WaterStream, ParticlesThatComeAndGoAreShownWhereTheyAre) {
    std::vector<WaterFrame> frames = stirred(5, 4);
    WaterFrame& fewer = frames[2];
    for (int k = 0; k < 30; ++k) {
        fewer.id.pop_back();
        fewer.position.pop_back();
        fewer.pressure.pop_back();
        fewer.speed.pop_back();
    }
    frames[3] = {};  // and none at all
    const PackedWater water = pack_water(source_of(frames), frames.size(), spacing, 1U << 30U);
    const std::vector<WaterNumbers> group = decode_group(water.groups[0]);
    ASSERT_EQ(group.size(), 4U);
    EXPECT_EQ(group[2].channel[0].size(), frames[2].id.size());
    EXPECT_EQ(group[3].channel[0].size(), 0U);
    std::vector<std::size_t> order(fewer.id.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return fewer.id[a] < fewer.id[b]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        EXPECT_LE(norm(position_of(group[2], i, water.scale) - fewer.position[order[i]]), 2 * water.error());
    }
}

// Three bytes each are 60 MB in a page, in base64, for 100 000 particles over 200 frames.
TEST(WaterStream, StaysWithinThreeBytesForAParticleAndFrameAtTheFinestStep) {
    const std::vector<WaterFrame> frames = stirred(20, 25);
    const double particle_frames = static_cast<double>(frames[0].id.size() * frames.size());
    const auto budget = static_cast<std::size_t>(3 * particle_frames * 3 / 4);
    const PackedWater water = pack_water(source_of(frames), frames.size(), spacing, budget);
    EXPECT_LE(4.0 / 3 * static_cast<double>(water.bytes()), 3 * particle_frames);
    EXPECT_EQ(water.stride, 1U);
    EXPECT_DOUBLE_EQ(water.scale.step, spacing / 32);
}

TEST(WaterStream, WhatCannotBeGuessedStillFitsWithACoarserStepOrFewerParticles) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(0, 0.3);
    std::vector<WaterFrame> frames(6);
    for (WaterFrame& frame : frames) {
        for (std::int32_t i = 0; i < 2000; ++i) {
            frame.id.push_back(i);
            frame.position.push_back({anywhere(random), anywhere(random), anywhere(random)});
            frame.pressure.push_back(static_cast<float>(anywhere(random)));
            frame.speed.push_back(static_cast<float>(anywhere(random)));
        }
    }
    const PackedWater coarse = pack_water(source_of(frames), frames.size(), spacing, 75'000);
    EXPECT_LE(coarse.bytes(), 75'000U);
    EXPECT_GT(coarse.scale.step, spacing / 32);
    EXPECT_LE(largest_error(frames, coarse), coarse.error() * (1 + 1e-9));
    const PackedWater thinned = pack_water(source_of(frames), frames.size(), spacing, 20'000);
    EXPECT_LE(thinned.bytes(), 20'000U);
    EXPECT_GT(thinned.stride, 1U);
}

TEST(WaterStream, AStepThatDoublingDoesNotMoveEndsThePackingAllTheSame) {
    std::vector<WaterFrame> frames = stirred(4, 3);
    for (const double grain : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::denorm_min()}) {
        EXPECT_GE(pack_water(source_of(frames), frames.size(), grain, 0).stride, frames[0].id.size() / 2);
    }
}

TEST(WaterStream, PressuresThatAreNotNumbersAreCountedAndBoundNothing) {
    std::vector<WaterFrame> frames = stirred(8, 3);
    const PackedWater sound = pack_water(source_of(frames), frames.size(), spacing, 1U << 30U);
    EXPECT_EQ(sound.not_numbers, 0U);
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < frames[1].id.size(); i += 3) {
        frames[1].pressure[i] = i % 2 == 0 ? nan : -infinity;
    }
    frames[2].speed[5] = infinity;
    const PackedWater water = pack_water(source_of(frames), frames.size(), spacing, 1U << 30U);
    EXPECT_EQ(water.not_numbers, (frames[1].id.size() + 2) / 3 + 1);
    // The bounds are those of what is left of the same water, so near those of all of it.
    EXPECT_NEAR(water.scale.pressure_low, sound.scale.pressure_low, 0.1 * sound.scale.pressure_high);
    EXPECT_NEAR(water.scale.pressure_high, sound.scale.pressure_high, 0.1 * sound.scale.pressure_high);
    EXPECT_NEAR(water.scale.speed_high, sound.scale.speed_high, 0.1 * sound.scale.speed_high);
    const std::vector<WaterNumbers> group = decode_group(water.groups[0]);
    EXPECT_EQ(group[1].channel[3][static_cast<std::size_t>(frames[1].id[0])], 0);
}

TEST(Chunk, RowsAndPlanesComeBack) {
    std::string bytes;
    for (int i = 0; i < 480; ++i) {
        bytes += static_cast<char>(i * i);
    }
    std::string rows = bytes;
    difference_rows(rows, 48);
    restore_rows(rows, 48);
    EXPECT_EQ(rows, bytes);
    EXPECT_EQ(join_planes(split_planes(bytes, 8), 8), bytes);
    EXPECT_EQ(decompress(compress(bytes), 480), bytes);
}

}  // namespace
}  // namespace riprap::view
