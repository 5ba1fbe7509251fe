// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "riprap/scene/keys/key_unit.hpp"

namespace riprap::scene {
namespace {

TEST(KeyUnit, is_that_at_the_end_of_the_key_or_the_one_of_bare_numbers) {
    EXPECT_EQ(unit_of_key("material.rock.friction_angle_deg"), "deg");
    EXPECT_EQ(unit_of_key("material.rock.friction_angle"), "rad");
    EXPECT_EQ(unit_of_key("material.rock.density"), "kg/m^3");
    EXPECT_EQ(unit_of_key("end"), "s");
    EXPECT_EQ(unit_of_key("end_ms"), "ms");
    EXPECT_EQ(unit_of_key("body.stone.velocity.0"), "m/s");
    EXPECT_EQ(unit_of_key("body.3.position"), "m");
}

TEST(KeyUnit, of_a_plain_number_a_word_or_no_key_is_empty) {
    for (const char* path : {"", "seed", "solid.method", "material", "material.rock", "material.rock.nothing_deg",
                             "no.such.key", "body", "body.stone"}) {
        EXPECT_EQ(unit_of_key(path), "") << path;
    }
}

}  // namespace
}  // namespace riprap::scene
