// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "riprap/core/chosen_keys.hpp"

namespace riprap {
namespace {

struct Soft {
    static constexpr std::string_view word = "soft", help = "gives way";
    static KeyList<Soft> keys() {
        return {key::number(&Soft::give, "give", dimension::plain, key::positive(), "How far.")};
    }
    double give{3};
    double answer() const { return give; }
};
struct Hard {
    static constexpr std::string_view word = "hard", help = "stands";
    double answer() const { return -1; }
};
struct Settings {
    Chosen<Soft, Hard> law;
};

const BoundKey<Settings>& key_of(const KeyList<Settings>& keys, std::string_view name) {
    for (const BoundKey<Settings>& key : keys) {
        if (key.row.name == name) {
            return key;
        }
    }
    throw InternalError("no such key");
}

TEST(Chosen, the_first_law_of_the_list_acts_until_a_word_chooses_another) {
    const KeyList<Settings> keys = key::chosen(&Settings::law, "law", "What it does");
    Settings settings;
    const auto answer = [&] { return settings.law.visit([](const auto& law) { return law.answer(); }); };
    EXPECT_EQ(answer(), 3);
    key_of(keys, "law").set(settings, KeyValue("hard"));
    EXPECT_EQ(answer(), -1);
    EXPECT_EQ(key_of(keys, "law").get(settings), KeyValue("hard"));
}

TEST(Chosen, keys_of_a_law_fill_it_whether_it_is_chosen_before_or_after) {
    const KeyList<Settings> keys = key::chosen(&Settings::law, "law", "What it does");
    Settings settings;
    settings.law.choose<Hard>();
    key_of(keys, "give").set(settings, KeyValue(7.0));
    EXPECT_EQ(settings.law.get<Soft>().give, 7);
    settings.law.choose<Soft>();
    EXPECT_EQ(settings.law.visit([](const auto& law) { return law.answer(); }), 7);
}

TEST(Chosen, the_help_of_the_choice_is_made_of_that_of_its_laws) {
    const KeyList<Settings> keys = key::chosen(&Settings::law, "law", "What it does");
    EXPECT_EQ(key_of(keys, "law").row.help, "What it does. soft: gives way; hard: stands.");
    EXPECT_EQ(key_of(keys, "law").row.words, (std::vector<std::string_view>{"soft", "hard"}));
}

struct AlsoSoft {
    static constexpr std::string_view word = "also_soft", help = "gives way too";
    static KeyList<AlsoSoft> keys() {
        return {key::number(&AlsoSoft::give, "give", dimension::plain, key::positive(), "How far.")};
    }
    double give{3};
};

TEST(Chosen, two_laws_of_a_list_may_not_have_keys_of_one_name) {
    struct Both {
        Chosen<Soft, AlsoSoft> law;
    };
    EXPECT_THROW(key::chosen(&Both::law, "law", "What it does"), InternalError);
}

}  // namespace
}  // namespace riprap
