// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "fluid/particle/sample.hpp"
#include "riprap/fluid/particle/sweep/box_tree.hpp"

namespace riprap::fluid {
namespace {

BoxTree tree_of(const Sample& sample) {
    BoxTree tree;
    tree.build(sample.position, sample.domain);
    return tree;
}

// A set of up to 64 particles has one block, whose box has no end. It used to be near blocks that do not exist too: the
// motion watched for them was whatever lay behind the array, and a NaN there hid that lists were out of date.
TEST(box_tree, a_box_without_end_is_near_every_block_that_exists_and_no_other) {
    const BoxTree few = tree_of(jittered_lattice(2, {8, 8, 1}, 1.5)),
                  many = tree_of(jittered_lattice(2, {30, 14, 1}, 1.5));
    std::vector<std::int32_t> found, all(7);
    std::iota(all.begin(), all.end(), 0);  // 420 particles in blocks of 64
    many.find_blocks(few.box_of_block(0), 0.01F, found);
    EXPECT_EQ(found, all);
}

TEST(box_tree, finds_the_blocks_within_a_distance) {
    const Sample sample = jittered_lattice(3, {16, 16, 16}, 1.5);
    const BoxTree tree = tree_of(sample);
    const std::int64_t blocks = sample.position.size() / 64;
    for (std::int64_t b = 0; b < blocks; ++b) {
        const BoxTree::Box here = tree.box_of_block(b);
        std::vector<std::int32_t> found, expected;
        tree.find_blocks(here, 0.03F, found);
        for (std::int32_t other = 0; other < blocks; ++other) {
            const BoxTree::Box there = tree.box_of_block(other);
            double square = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double gap =
                    std::abs(here.centre[axis] - there.centre[axis]) - here.half[axis] - there.half[axis];
                square += gap > 0 ? gap * gap : 0;
            }
            if (square < 0.03 * 0.03) {
                expected.push_back(other);
            }
        }
        ASSERT_EQ(found, expected);
    }
}

TEST(box_tree, finds_blocks_across_a_periodic_side) {
    Sample sample = jittered_lattice(2, {8, 64, 1}, 1.5);  // eight blocks in a row along y
    sample.domain.low = {-1, 0, 0};
    sample.domain.high = {1, 64 * sample.spacing, 0};
    const BoxTree::Box corner{{1.04F, 0, 0}, {0, 0, 0}};  // boxes are relative to the corner of the domain
    std::vector<std::int32_t> open, periodic;
    tree_of(sample).find_blocks(corner, 0.02F, open);
    sample.domain.is_periodic[1] = true;
    tree_of(sample).find_blocks(corner, 0.02F, periodic);
    EXPECT_THAT(open, testing::ElementsAre(0));
    EXPECT_THAT(periodic, testing::ElementsAre(0, 7));
}

}  // namespace
}  // namespace riprap::fluid
