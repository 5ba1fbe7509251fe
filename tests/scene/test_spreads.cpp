// SPDX-License-Identifier: Apache-2.0
// Numbers of an ensemble are tried when the case is read.
#include <set>

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

TEST(Spreads, of_one_key_twice_are_refused) {
    EXPECT_THAT(problems_with("key = \"body.block.position.2\"\nlow = 0.5\nhigh = 1.5\n[[spread]]\nkey = "
                              "\"body.block.position.2\"\nmean = 0.5\ndeviation = 0.1\n"),
                ElementsAre(HasSubstr("case.toml:16:7: 'body.block.position.2' has a [[spread]] already")));
    EXPECT_THAT(problems_with("key = \"body.block.position.2\"\nlow = 0.5\nhigh = 1.5\n[[spread]]\nkey = "
                              "\"body.0.position.2\"\nmean = 0.5\ndeviation = 0.1\n"),
                ElementsAre(HasSubstr("case.toml:16:7: 'body.0.position.2' has a [[spread]] already")));
}

TEST(Spreads, with_half_of_what_they_need_are_refused_once_each) {
    const std::vector<std::string> lines{"low = 0.5\n", "high = 1.5\n", "mean = 1.0\n", "deviation = 0.1\n"};
    for (unsigned chosen = 0; chosen < 16; ++chosen) {
        std::string spread = "key = \"body.block.position.2\"\n";
        for (std::size_t k = 0; k < lines.size(); ++k) {
            spread += (chosen >> k) % 2 == 1 ? lines[k] : "";
        }
        const bool is_right = chosen == 3 || chosen == 12;
        const std::vector<std::string> problems = problems_with(spread);
        EXPECT_EQ(problems.empty(), is_right) << spread;
        EXPECT_EQ(std::set<std::string>(problems.begin(), problems.end()).size(), problems.size()) << spread;
    }
    EXPECT_THAT(problems_with("key = \"body.block.position.2\"\nlow = \"a\"\nhigh = 1.5\n"),
                ElementsAre(HasSubstr("case.toml:13:7")));
}

TEST(Spreads, names_in_a_list_are_told_at_their_place) {
    EXPECT_THAT(problems_of(minimal_case + "[[contact.pair]]\nmaterials = [\"rock\", \"wood\"]\n"),
                ElementsAre(HasSubstr("case.toml:11:22: there is no material 'wood'")));
}

}  // namespace
}  // namespace riprap::scene
