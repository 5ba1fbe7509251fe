// SPDX-License-Identifier: Apache-2.0
// Published cases are found by the number of a figure, from any folder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/run/drive/published.hpp"

namespace riprap::run {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::vector<PublishedCase>& known() {
    static const std::vector<PublishedCase> cases = published_cases();
    return cases;
}

std::vector<std::string> about(const std::vector<std::string>& words) {
    std::vector<std::string> names;
    for (const PublishedCase& one : known()) {
        if (is_about(one, words)) {
            names.push_back(one.name);
        }
    }
    return names;
}

std::string refusal_of(const std::string& text) {
    try {
        return "found " + find_case(text).string();
    } catch (const FileError& error) {
        return error.what();
    }
}

TEST(PublishedCases, ANumberIsOfItsKindAloneInARangeOrInASectionThatHoldsIt) {
    const char* source = "Ding (2021), section 7.2.3, figures 7.7 to 7.9, 7.11 and B1 to B4, table 6";
    for (const char* number : {"7.7", "7.8", "7.9", "7.8a", "7.11", "B1", "b3"}) {
        EXPECT_TRUE(names_number(source, "figure", number)) << number;
        EXPECT_TRUE(names_number(source, "Figs.", number)) << number;
        EXPECT_FALSE(names_number(source, "section", number)) << number;
    }
    for (const char* number : {"7.6", "7.10", "7.12", "7.1", "7.77", "8", "6", "B5", "B", "2021", "C2"}) {
        EXPECT_FALSE(names_number(source, "figure", number)) << number;
    }
    EXPECT_TRUE(names_number(source, "section", "7.2.3"));
    EXPECT_TRUE(names_number(source, "section", "7.2"));
    EXPECT_TRUE(names_number(source, "chapter", "7"));
    EXPECT_FALSE(names_number(source, "section", "7.2.30"));
    EXPECT_FALSE(names_number(source, "section", "2.3"));
    EXPECT_TRUE(names_number(source, "table", "6"));
    EXPECT_TRUE(names_number(source, "", "6"));
    EXPECT_FALSE(names_number(source, "", "2021")) << "a year is no number of a kind";
}

TEST(PublishedCases, AreFoundByAFigureByWordsAndByAuthor) {
    EXPECT_THAT(about({"ding", "figure", "7.16"}),
                ElementsAre("ding/gravity_dam_cohesion", "ding/planar_dam_cohesion", "ding/planar_dam_stands"));
    EXPECT_EQ(about({"ding figure 7.16"}), about({"Ding", "(2021),", "Fig.", "7.16"}));
    EXPECT_THAT(about({"zhao", "fig", "32"}), ElementsAre("zhao/slope_5", "zhao/slope_5_four"));
    EXPECT_THAT(about({"Mikola", "figure", "4"}), ElementsAre("mikola/wave_maker", "mikola/wave_maker_long"));
    EXPECT_THAT(about({"Amaro", "figure", "C1"}), ElementsAre("mellado/floes_none"));
    EXPECT_THAT(about({"ding", "3d", "section", "7.2.1"}), ElementsAre("ding/free_fall_3d"));
    EXPECT_GE(about({"zhao", "slope"}).size(), 5u);
    EXPECT_EQ(about({"zhao", "figure", "99"}).size(), 0u);
}

TEST(PublishedCases, AFigureIsOneOfThePublicationThatIsNamed) {
    const PublishedCase one{{"a/b", "Floes", "Mellado (2021), figure 3.7; Amaro et al. (2021), figure 12", {}}, {}};
    EXPECT_TRUE(is_about(one, {"amaro", "figure", "12"}));
    EXPECT_FALSE(is_about(one, {"amaro", "figure", "3.7"}));
    EXPECT_TRUE(is_about(one, {"mellado", "3.7"}));
    EXPECT_FALSE(is_about(one, {"mellado", "amaro"}));
}

TEST(PublishedCases, OfTheFourPapersNameSectionOrFigureOrSayThatThereIsNoPaper) {
    int count = 0;
    for (const KnownCase& one : known_cases("validation")) {
        const std::string suite = one.name.substr(0, one.name.find('/'));
        if (suite != "zhao" && suite != "mikola" && suite != "mellado" && suite != "ding") {
            continue;
        }
        ++count;
        const bool is_of_suite = one.source.find("section ") != std::string::npos ||
                                 one.source.find("sections ") != std::string::npos ||
                                 one.source.find("appendix ") != std::string::npos;
        const bool is_other = one.source.starts_with("No paper: ") || one.source.find(" (") != std::string::npos;
        EXPECT_TRUE(is_of_suite || is_other) << one.name << ": '" << one.source << "'";
        EXPECT_FALSE(one.title.empty()) << one.name;
    }
    EXPECT_GE(count, 150);
}

TEST(FindCase, TakesTheFolderOfTheTreeBeforeAName) {
    const std::string plain = find_case("ding/planar_arch").string();
    EXPECT_EQ(find_case("validation/ding/planar_arch").filename(), "case.toml");
    EXPECT_TRUE(plain.ends_with("validation/ding/planar_arch/case.toml")) << plain;
    EXPECT_TRUE(find_case("cases/hello_block").string().ends_with("cases/hello_block/case.toml") ||
                find_case("cases/hello_block").string().ends_with("cases/hello_block"));
}

TEST(FindCase, NamesTheNearestOfTheSuite) {
    const std::string arch = refusal_of("validation/ding/arch");
    EXPECT_THAT(arch, HasSubstr("'ding/arch_plane'"));
    EXPECT_THAT(arch, HasSubstr("'ding/planar_arch'"));
    EXPECT_THAT(refusal_of("planar_arch"), HasSubstr("'ding/planar_arch'"));
    EXPECT_THAT(refusal_of("validation/zhao/slope_6"), HasSubstr("did you mean 'zhao/slope_"));
    EXPECT_THAT(refusal_of("cases/hello_blok"), HasSubstr("did you mean 'hello_block'?"));
}

}  // namespace
}  // namespace riprap::run
