// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sparse_vectors.hpp"

#include <gtest/gtest.h>

namespace riprap::fluid {
namespace {

TEST(SparseVectors, are_zero_but_where_something_was_added) {
    SparseVectors vectors(1000);
    vectors.add(130, {1, 2, 3});
    vectors.add(130, {0, 0, 1});
    vectors.add(999, {4, 0, 0});
    for (std::size_t i = 0; i < 1000; ++i) {
        const Vec3 expected = i == 130 ? Vec3{1, 2, 4} : i == 999 ? Vec3{4, 0, 0} : Vec3{};
        EXPECT_EQ(vectors[i], expected) << i;
    }
    vectors.reset(1000);
    EXPECT_EQ(vectors[130], Vec3{});
}

TEST(SparseVectors, of_no_particles_are_zero_too) {
    EXPECT_EQ(SparseVectors()[7], Vec3{});
    SparseVectors vectors(100);
    vectors.add(70, {1, 0, 0});
    vectors.reset(0);
    EXPECT_EQ(vectors[70], Vec3{});
}

TEST(SparseVectors, take_room_for_a_block_where_one_particle_has_one) {
    SparseVectors vectors(64000);
    const std::size_t empty = vectors.bytes();
    EXPECT_LT(empty, 64000U);
    vectors.add(777, {1, 0, 0});
    EXPECT_EQ(vectors.bytes(), empty + 64 * sizeof(Vec3));
    vectors.reset(64000);
    EXPECT_EQ(vectors.bytes(), empty);
}

}  // namespace
}  // namespace riprap::fluid
