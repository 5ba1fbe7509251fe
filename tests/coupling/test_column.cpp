// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/samples/column.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

namespace riprap::coupling {
namespace {

/// A column of `count` values of which `different` differ, and the same values in a plain list.
struct Listed {
    Column<double> column;
    std::vector<double> plain;

    Listed(std::size_t count, std::size_t different) {
        std::mt19937 random(7);
        std::vector<double> values;
        for (std::size_t k = 0; k < different; ++k) {
            values.push_back(std::uniform_real_distribution<double>(-1, 1)(random));
        }
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t k =
                i < different ? i : std::uniform_int_distribution<std::size_t>(0, different - 1)(random);
            plain.push_back(values[k]);
            column.push_back(values[k]);
        }
    }
    void expect_same() const {
        ASSERT_EQ(column.size(), plain.size());
        for (std::size_t i = 0; i < plain.size(); ++i) {
            ASSERT_EQ(std::bit_cast<std::uint64_t>(column[i]), std::bit_cast<std::uint64_t>(plain[i])) << i;
        }
        EXPECT_TRUE(std::equal(column.begin(), column.end(), plain.begin(), plain.end()));
    }
};

TEST(Column, gives_back_what_it_was_given_in_the_room_of_the_names_of_its_values) {
    for (const auto& [different, room] : {std::pair<std::size_t, std::size_t>{1, 0}, {256, 1}, {257, 2}, {65536, 2}}) {
        Listed list(200'000, different);
        list.column.pack();
        EXPECT_EQ(list.column.bytes(), room * 200'000 + different * sizeof(double)) << different;
        list.expect_same();
    }
    for (const auto& [count, different] : {std::pair<std::size_t, std::size_t>{200'000, 65537}, {100, 51}, {1, 1}}) {
        Listed list(count, different);
        list.column.pack();
        EXPECT_EQ(list.column.bytes(), count * sizeof(double)) << different;
        list.expect_same();
    }
}

TEST(Column, tells_values_apart_that_compare_equal) {
    Column<double> column;
    for (int i = 0; i < 8; ++i) {
        column.push_back(i % 2 == 0 ? 0.0 : -0.0);
    }
    column.pack();
    EXPECT_LT(column.bytes(), 8 * sizeof(double));
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(std::signbit(column[i]), i % 2 == 1) << i;
    }
}

TEST(Column, can_be_changed_after_it_was_packed) {
    Listed list(1000, 7);
    list.column.pack();
    list.column.push_back(3);
    list.plain.push_back(3);
    list.column.set(500, 4);
    list.plain[500] = 4;
    list.expect_same();
    list.column.pack();
    list.expect_same();
    EXPECT_LT(list.column.bytes(), 1200U);
    list.column.clear();
    EXPECT_TRUE(list.column.empty());
    list.column.pack();
    EXPECT_EQ(list.column.size(), 0U);
    Column<std::uint8_t> flags;
    flags.resize(100);
    flags.pack();
    EXPECT_EQ(flags.bytes(), 1U);
    flags.set(7, 1);
    flags.pack();
    EXPECT_EQ(flags.bytes(), 100U);
    EXPECT_EQ(flags[7] + flags[8], 1);
}

TEST(Column, keeps_vectors_whole_and_places_by_axis) {
    Column<Vec3> normals;
    PlaceColumn places;
    for (int i = 0; i < 4096; ++i) {
        normals.push_back({0, i % 2 == 0 ? 1.0 : -1.0, 0});
        places.push_back({0.1 * (i % 16), 0.1 * (i / 16 % 16), 0.1 * (i / 256)});
    }
    const PlaceColumn before = places;
    normals.pack();
    places.pack();
    EXPECT_EQ(normals.bytes(), 4096 + 2 * sizeof(Vec3));
    EXPECT_EQ(places.bytes(), 3 * (4096 + 16 * sizeof(double)));
    EXPECT_EQ(normals[4095], (Vec3{0, -1, 0}));
    EXPECT_EQ(places, before);
}

}  // namespace
}  // namespace riprap::coupling
