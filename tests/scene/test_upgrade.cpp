// SPDX-License-Identifier: Apache-2.0
// Case files of older versions: they open, or say which name of today is meant, and are rewritten.
#include "riprap/scene/upgrade.hpp"

#include <algorithm>
#include <sstream>

#include "case_fixture.hpp"
#include "riprap/io/atomic_file.hpp"

namespace riprap::scene {
namespace {

using test::minimal_case;
using testing::AllOf;
using testing::HasSubstr;

/// The problems of a case, a line each; empty where it opens.
std::string problems_of(const std::string& text) {
    try {
        test::read(text);
    } catch (const CaseError& error) {
        return error.what();
    }
    return "";
}

std::string refusal_of_upgrade(const std::string& text, const Table& table = case_table(),
                               std::span<const Renamed> rows = renamed_names()) {
    try {
        upgrade_case_text(text, "case.toml", table, rows);
    } catch (const CaseError& error) {
        return error.what();
    }
    return "";
}

std::string file_of_0_2() { return io::read_file("tests/data/upgrade/ledger_of_0_2.toml", 1 << 20); }

std::size_t count(const std::string& text, const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
        ++found;
    }
    return found;
}

TEST(Upgrade, RefusesAFormatNewerThanItsOwnAtItsPlaceAndLooksAtNothingElse) {
    const std::string problem = problems_of("future_key = 3\nformat =  2\n" + minimal_case);
    EXPECT_THAT(problem, AllOf(HasSubstr("case.toml:2:11: format = 2 is newer than this program"),
                               HasSubstr("reads case files of format 1"), testing::Not(HasSubstr("future_key"))));
    EXPECT_EQ(problems_of("format = 1\n" + minimal_case), "");
    EXPECT_THAT(problems_of("format = 0\n" + minimal_case), HasSubstr("case.toml:1:10: format"));
    EXPECT_THAT(refusal_of_upgrade("format = 2\n" + minimal_case), HasSubstr("case.toml:1:10: format = 2"));
}

TEST(Upgrade, FormatIsNoPartOfTheMotionSoOldCheckpointsBelongToIt) {
    EXPECT_EQ(test::read("format = 1\n" + minimal_case).model.case_hash, test::read(minimal_case).model.case_hash);
}

TEST(Upgrade, NamesTheWordOfTodayWhereAFileOf02HasAnOldOne) {
    const std::string problems =
        problems_of(minimal_case +
                    "[[output.probe]]\nquantity = \"elastic_energy\"\n[[output.probe]]\nbody = \"blok\"\n"
                    "quantity = \"kinetic_energy\"\n[surprise]\n");
    EXPECT_THAT(problems, AllOf(HasSubstr("case.toml:11:12: quantity = \"elastic_energy\" is called \"solid.elastic\" "
                                          "since version 0.3; `riprap upgrade` writes the new name into the file"),
                                HasSubstr("surprise"), testing::Not(HasSubstr("is not known"))));
}

TEST(Upgrade, AFileOf02OpensOnceItIsRewritten) {
    const std::string before = file_of_0_2();
    EXPECT_THAT(problems_of(before), HasSubstr("is called"));
    const UpgradedCase upgraded = upgrade_case_text(before, "case.toml");
    EXPECT_EQ(upgraded.renamed.size(), 24U);
    EXPECT_EQ(problems_of(upgraded.text), "");
    EXPECT_TRUE(upgrade_case_text(upgraded.text, "case.toml").renamed.empty());
}

TEST(Upgrade, KeepsEverythingButTheWordsToTheByte) {
    const std::string before = file_of_0_2();
    UpgradedCase upgraded = upgrade_case_text("\xEF\xBB\xBF" + before, "case.toml");
    EXPECT_EQ(upgraded.text.substr(0, 3), "\xEF\xBB\xBF");
    EXPECT_EQ(count(upgraded.text, "\n"), count(before, "\n"));
    // Back, name by name: what remains is the file as it was.
    std::string back = upgraded.text.substr(3);
    for (const OldName& old : upgraded.renamed) {
        for (const char quote : {'"', '\''}) {
            const std::size_t at = back.find(quote + old.now + quote);
            if (at != std::string::npos) {
                back.replace(at + 1, old.now.size(), old.before);
                break;
            }
        }
    }
    EXPECT_EQ(back, before);
    EXPECT_EQ(count(upgraded.text, "body = \"block\", quantity = \"kinetic_energy\""), 1U);
    EXPECT_EQ(count(upgraded.text, "water_kinetic_energy"), 1U);  // in a citation
}

TEST(Upgrade, LeavesAWordByWhichTheFileCallsARecordOfItsOwn) {
    const std::string text = minimal_case +
                             "[[output.probe]]\nname = \"kinetic_energy\"\nbody = \"block\"\nquantity = "
                             "\"kinetic_energy\"\n[[expect]]\nname = \"still\"\nquantity = \"kinetic_energy\"\nvalue = "
                             "0.0\ntolerance = 1e9\ncitation = \"none\"\n";
    EXPECT_TRUE(upgrade_case_text(text, "case.toml").renamed.empty());
    EXPECT_EQ(problems_of(text), "");
}

TEST(Upgrade, RefusesAWordThatNothingReplacesAndOneThatIsNotWrittenOut) {
    const std::string probe = minimal_case + "[[output.probe]]\n";
    EXPECT_THAT(refusal_of_upgrade(probe + "quantity = \"pair_count\"\n"),
                AllOf(HasSubstr("case.toml:11:12: quantity 'pair_count' is not read since version 0.2"),
                      HasSubstr("contact_count")));
    EXPECT_THAT(refusal_of_upgrade(probe + "quantity = \"work\\u005Fdriven\"\n"),
                AllOf(HasSubstr("case.toml:11:12:"), HasSubstr("letter by letter")));
    EXPECT_THAT(refusal_of_upgrade("[open\n"), HasSubstr("case.toml:"));
}

/// Tells whether one of the forms, or an entry of a list, takes the word.
bool takes(const std::vector<Form>& forms, const std::string& word) {
    return std::any_of(forms.begin(), forms.end(), [&](const Form& form) {
        return std::find(form.words.begin(), form.words.end(), word) != form.words.end() || takes(form.item, word);
    });
}

/// Tells whether a row says what became of a key, or of a word that it took.
bool is_renamed(std::string_view table, const std::string& key, const std::string& word) {
    const std::span<const Renamed> rows = renamed_names();
    return std::any_of(rows.begin(), rows.end(), [&](const Renamed& row) {
        return row.word == word && std::any_of(row.places.begin(), row.places.end(), [&](const KeyPlace& place) {
                   return place.table == table && place.key == key;
               });
    });
}

TEST(Upgrade, EveryKeyAndWordOf02IsThereOrSaysWhatReplacesIt) {
    std::istringstream lines(io::read_file("tests/data/upgrade/keys_of_0_2.txt", 1 << 20));
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {  // "[[body]] | shape", with " | WORD" for its words
        const std::size_t bar = line.find(" | "), next = line.find(" | ", bar + 3);
        const std::string header = line.substr(0, bar), key = line.substr(bar + 3, next - bar - 3),
                          word = next == std::string::npos ? "" : line.substr(next + 3);
        const std::vector<const Table*> tables = all_tables();
        const auto table =
            std::find_if(tables.begin(), tables.end(), [&](const Table* one) { return one->header == header; });
        ASSERT_NE(table, tables.end()) << header << " is gone: tables that are renamed need a row of their own kind";
        const Key* now = (*table)->find(key);
        EXPECT_TRUE((now != nullptr && (word.empty() || takes(now->forms, word))) ||
                    is_renamed((*table)->id, key, word))
            << line << " is gone: add a row to scene/keys/renamed.cpp";
    }
    EXPECT_EQ(count, 418);
}

/// Keys of a table that were renamed: `stiffness` (with any unit) and `old` of materials; `gone` is read no more.
constexpr std::array stiffness_places{KeyPlace{"material", "stiffness"}};
constexpr std::array gone_places{KeyPlace{"material", "gone"}};
constexpr std::array renamed_keys{Renamed{stiffness_places, "", "normal_stiffness", "", "0.9"},
                                  Renamed{gone_places, "", "", "leave it out", "0.9"}};

TEST(Upgrade, RenamesAKeyWithItsUnitInHeadersQuotesAndDottedKeys) {
    const auto text_of = [](const std::string& text) {
        return upgrade_case_text(text, "case.toml", case_table(), renamed_keys).text;
    };
    EXPECT_EQ(text_of("[material.rock]\n  stiffness_MPa =  4 # stiffness\n"),
              "[material.rock]\n  normal_stiffness_MPa =  4 # stiffness\n");
    EXPECT_EQ(text_of("[material.rock]\n\"stiffness\" = 4\n"), "[material.rock]\n\"normal_stiffness\" = 4\n");
    EXPECT_EQ(text_of("material = { stiffness = { stiffness = 4 } }\n"),
              "material = { stiffness = { normal_stiffness = 4 } }\n");
    EXPECT_EQ(text_of("material.a.stiffness = 4\nmaterial.stiffness.stiffness = 4\n"),
              "material.a.normal_stiffness = 4\nmaterial.stiffness.normal_stiffness = 4\n");
}

TEST(Upgrade, RefusesAKeyWhoseNewNameIsThereAlreadyAndOneThatIsGone) {
    EXPECT_THAT(
        refusal_of_upgrade("[material.rock]\nnormal_stiffness = 4\nstiffness_MPa = 5\n", case_table(), renamed_keys),
        AllOf(HasSubstr("case.toml:3:1: key 'stiffness_MPa' is not read"),
              HasSubstr("'normal_stiffness' replaces it and is there already")));
    EXPECT_THAT(refusal_of_upgrade("[material.rock]\ngone = 4\n", case_table(), renamed_keys),
                AllOf(HasSubstr("case.toml:2:1: key 'gone'"), HasSubstr("leave it out")));
}

}  // namespace
}  // namespace riprap::scene
