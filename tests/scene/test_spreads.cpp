// SPDX-License-Identifier: Apache-2.0
// Numbers of an ensemble are tried when the case is read.
#include "case_fixture.hpp"

namespace riprap::scene {
namespace {

using namespace test;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> problems_with(const std::string& spread) {
    return problems_of(minimal_case + "position = [0, 0, 1]\n[[spread]]\n" + spread);
}

TEST(Spreads, of_keys_that_there_are_are_accepted) {
    EXPECT_THAT(problems_with("key = \"body.block.position.2\"\nlow = 0.5\nhigh = 1.5\n"), IsEmpty());
    EXPECT_THAT(problems_with("key = \"material.rock.friction_coefficient\"\nmean = 0.4\ndeviation = 0.05\n"),
                IsEmpty());
}

TEST(Spreads, of_keys_and_bodies_that_there_are_not_are_told_at_their_place) {
    EXPECT_THAT(problems_with("key = \"body.block.positon.2\"\nlow = 0.5\nhigh = 1.5\n"),
                ElementsAre(AllOf(HasSubstr("case.toml:12:7: body.block.positon.2 = 0.5:"))));
    EXPECT_THAT(problems_with("key = \"body.blok.position.2\"\nlow = 0.5\nhigh = 1.5\n"),
                ElementsAre(AllOf(HasSubstr("case.toml:12:7"), HasSubstr("blok"))));
}

TEST(Spreads, beyond_what_a_key_allows_are_refused) {
    EXPECT_THAT(problems_with("key = \"material.rock.friction_coefficient\"\nlow = -0.1\nhigh = 0.1\n"),
                ElementsAre(AllOf(HasSubstr("case.toml:12:7: material.rock.friction_coefficient = -0.1:"),
                                  HasSubstr("0 <= value"))));
    EXPECT_THAT(problems_with("key = \"body.block.position.2\"\nlow = 1.5\nhigh = 0.5\n"),
                ElementsAre(HasSubstr("case.toml:13:7: low = 1.5 is above high = 0.5")));
}

TEST(Spreads, names_in_a_list_are_told_at_their_place) {
    EXPECT_THAT(problems_of(minimal_case + "[[contact.pair]]\nmaterials = [\"rock\", \"wood\"]\n"),
                ElementsAre(HasSubstr("case.toml:11:22: there is no material 'wood'")));
}

}  // namespace
}  // namespace riprap::scene
