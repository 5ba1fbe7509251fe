// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/keys/methods.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <variant>

#include "riprap/scene/keys/check_keys.hpp"
#include "riprap/scene/text/toml_reader.hpp"

namespace riprap::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Two methods that share the key "spacing"; their "courant" differ in default and range.
struct Particles {
    double spacing{0};
};
struct Waves : Particles {
    static constexpr std::string_view method_name = "waves";
    static MethodKeys<Waves> keys();
    double courant{0.5};
    double damping{0};
};
struct Drops : Particles {
    static constexpr std::string_view method_name = "drops";
    static MethodKeys<Drops> keys();
    double courant{0.25};
    double tension{0.07};
    double least{1}, most{2}, angle{1};
    bool wets{false};
};

KeyList<Particles> shared_keys() {
    return {key::number(&Particles::spacing, "spacing", dimension::length, key::positive(), "Spacing.").required()};
}
MethodKeys<Waves> Waves::keys() {
    return {.help = "waves",
            .keys = shared_keys() +
                    KeyList<Waves>{
                        key::number(&Waves::courant, "courant", dimension::plain, key::between(0, 1), "Share."),
                        key::number(&Waves::damping, "damping", dimension::plain, key::between(0, 1), "Damping.")},
            .scene_keys = {"room"}};
}
MethodKeys<Drops> Drops::keys() {
    return {.help = "drops",
            .keys = shared_keys() +
                    KeyList<Drops>{
                        key::number(&Drops::courant, "courant", dimension::plain, key::between(0, 0.3), "Share."),
                        key::number(&Drops::tension, "tension", dimension::plain, key::positive(), "Tension."),
                        key::boolean(&Drops::wets, "wets", "Wets walls.").read_above("tension", 0.1),
                        key::number(&Drops::angle, "angle", dimension::plain, key::positive(), "Angle.")
                            .read_with("wets", {"true"}),
                        key::number(&Drops::least, "least", dimension::plain, key::positive(), "Least."),
                        key::number(&Drops::most, "most", dimension::plain, key::positive(), "Most.")},
            .check = [](const Drops& drops) {
                std::vector<KeyProblem> problems;
                if (drops.least > drops.most) {
                    problems.push_back({"least", "least is above most", "least <= most"});
                }
                return problems;
            }};
}

using Methods = MethodList<std::variant<Waves, Drops>>;

const Table& table() {
    static const Table made = with_methods({"liquid", "[liquid]", "A liquid.", {}}, "Kind of liquid.", Methods::all(),
                                           {{"room", {form::number(dimension::length)}, "Room.", Value::of(1.0)},
                                            {"unused", {form::boolean()}, "Nobody names it.", Value::of(true)}});
    return made;
}

struct Read {
    std::variant<Waves, Drops> settings;
    std::vector<std::string> problems, warnings;
};

Read read(const std::string& text) {
    Read out;
    std::vector<Diagnostic> problems;
    const Value resolved = check_keys(parse_toml(text, "case.toml", problems), table(), false, problems);
    if (problems.empty()) {
        out.settings = Methods::read(resolved, "[liquid]", problems, out.warnings);
    }
    for (const Diagnostic& problem : problems) {
        out.problems.push_back(to_string(problem));
    }
    return out;
}

TEST(Methods, the_first_of_the_list_is_the_default) {
    const Read out = read("spacing = 0.1\n");
    EXPECT_THAT(out.problems, IsEmpty());
    EXPECT_EQ(std::get<Waves>(out.settings).spacing, 0.1);
    EXPECT_EQ(std::get<Waves>(out.settings).courant, 0.5);
}

TEST(Methods, a_word_chooses_the_settings_that_its_keys_fill) {
    const Read out = read("method = \"drops\"\nspacing_mm = 2\ntension = 0.5\n");
    EXPECT_THAT(out.problems, IsEmpty());
    const auto& drops = std::get<Drops>(out.settings);
    EXPECT_EQ(drops.spacing, 2e-3);
    EXPECT_EQ(drops.tension, 0.5);
    EXPECT_EQ(drops.courant, 0.25);
}

TEST(Methods, a_key_of_a_method_that_is_not_chosen_is_refused_with_place_and_owner) {
    EXPECT_THAT(read("spacing = 0.1\ntension = 0.5\n").problems,
                ElementsAre("case.toml:2:1: 'tension' is a key of [liquid] with method = \"drops\"; the method here is "
                            "\"waves\"; leave it out, or choose that method"));
    EXPECT_THAT(read("method = \"drops\"\nspacing = 0.1\nroom_cm = 3\n").problems,
                ElementsAre(HasSubstr("case.toml:3:1: 'room_cm' is a key of [liquid] with method = \"waves\"")));
}

TEST(Methods, a_key_that_is_not_read_beside_others_is_told_with_what_reads_it) {
    const std::string drops = "method = \"drops\"\nspacing = 0.1\n";
    EXPECT_THAT(
        read(drops + "angle = 2\n").warnings,
        ElementsAre("case.toml:3:9: 'angle' of [liquid] does nothing here: wets is false; leave it out, or wets "
                    "= true"));
    EXPECT_THAT(read(drops + "wets = true\nangle = 2\n").warnings,
                ElementsAre("case.toml:3:8: 'wets' of [liquid] does nothing here: tension is 0.07; leave it out, or "
                            "tension above 0.1"));
    EXPECT_THAT(read(drops + "tension = 0.5\nwets = true\nangle = 2\n").warnings, IsEmpty());
    EXPECT_THAT(read(drops + "angle = 1.0\n").warnings, IsEmpty());  // its default says nothing that could be lost
}

TEST(Methods, a_key_of_no_method_is_unknown) {
    EXPECT_THAT(read("spacing = 0.1\ncourantt = 0.5\n").problems, ElementsAre(HasSubstr("did you mean 'courant'?")));
    EXPECT_THAT(read("spacing = 0.1\nunused = true\n").problems, ElementsAre(HasSubstr("unknown key 'unused'")));
}

TEST(Methods, a_shared_name_keeps_the_range_of_each_method) {
    EXPECT_THAT(read("spacing = 0.1\ncourant = 0.9\n").problems, IsEmpty());
    EXPECT_THAT(read("method = \"drops\"\nspacing = 0.1\ncourant = 0.9\n").problems,
                ElementsAre(HasSubstr("courant of [liquid] = 0.9; a number, 0 <= value <= 0.3")));
}

TEST(Methods, a_misspelt_word_is_one_problem) {
    EXPECT_THAT(read("method = \"dropss\"\nspacing = 0.1\ntension = 1.0\n").problems,
                ElementsAre(HasSubstr("did you mean \"drops\"?")));
    EXPECT_THAT(read("method = \"phlogiston\"\nspacing = 0.1\ntension = 1.0\n").problems,
                ElementsAre(HasSubstr("one of \"waves\", \"drops\"")));
    EXPECT_THAT(read("method = 3\ntension = 1.0\n").problems,
                ElementsAre(HasSubstr("method of [liquid] is an integer")));
}

TEST(Methods, values_that_do_not_go_together_are_refused_at_the_key) {
    EXPECT_THAT(read("method = \"drops\"\nspacing = 0.1\nleast = 3.0\n").problems,
                ElementsAre("case.toml:3:9: least is above most; least <= most"));
}

TEST(Methods, equal_rows_stand_once_and_name_their_methods) {
    std::vector<std::string> rows;
    for (const Key& key : table().keys) {
        std::string row(key.name);
        for (const std::string_view method : key.methods) {
            row.append(" ").append(method);
        }
        rows.push_back(row);
    }
    EXPECT_THAT(rows,
                ElementsAre("method", "spacing", "courant waves", "damping waves", "courant drops", "tension drops",
                            "wets drops", "angle drops", "least drops", "most drops", "room waves"));
}

TEST(Methods, a_scene_key_that_does_not_exist_is_a_bug_of_the_method) {
    EXPECT_THROW(with_methods({"liquid", "[liquid]", "A liquid.", {}}, "Kind.", Methods::all(), {}), InternalError);
}

}  // namespace
}  // namespace riprap::scene
