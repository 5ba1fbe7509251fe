// SPDX-License-Identifier: Apache-2.0
#include "riprap/core/key.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace riprap {
namespace {

enum class Flow : std::uint8_t { laminar, turbulent };

struct Grains {
    double size{0.5};
    bool is_wet{true};
};
struct Base {
    double spacing{0.25};
    std::int32_t rounds{4};
};
struct Settings : Base {
    Settings() { spacing = 2; }
    Flow flow{Flow::turbulent};
    std::optional<double> speed;
    Vec3 along{1, 0, 0};
    Grains grains;
};

KeyList<Base> base_keys() {
    return {key::number(&Base::spacing, "spacing", dimension::length, key::positive(), "Distance."),
            key::integer(&Base::rounds, "rounds", 1, 10, "Rounds.")};
}

KeyList<Settings> all_keys() {
    using S = Settings;
    return base_keys() +
           KeyList<S>{
               key::choice(&S::flow, "flow", {{"laminar", Flow::laminar}, {"turbulent", Flow::turbulent}}, "Flow."),
               key::number_or_auto(&S::speed, "speed", dimension::velocity, key::positive(), "Speed."),
               key::vector(&S::along, "along", dimension::plain, key::any(), "Way.")} +
           key::within(&S::grains,
                       KeyList<Grains>{key::number(&Grains::size, "size", dimension::length, key::positive(), "Size."),
                                       key::boolean(&Grains::is_wet, "wet", "Wet.")});
}

const BoundKey<Settings>& named(const KeyList<Settings>& keys, std::string_view name) {
    for (const BoundKey<Settings>& key : keys) {
        if (key.row.name == name) {
            return key;
        }
    }
    throw InternalError("no such key");
}

TEST(Key, the_default_is_what_a_default_constructed_struct_holds) {
    const KeyList<Settings> keys = all_keys();
    const Settings settings;
    EXPECT_EQ(named(keys, "spacing").get(settings), KeyValue(2.0));  // the derived struct's own default
    EXPECT_EQ(named(keys, "rounds").get(settings), KeyValue(std::int64_t{4}));
    EXPECT_EQ(named(keys, "flow").get(settings), KeyValue(std::string("turbulent")));
    EXPECT_EQ(named(keys, "speed").get(settings), KeyValue());
    EXPECT_EQ(named(keys, "size").get(settings), KeyValue(0.5));
    EXPECT_EQ(named(keys, "wet").get(settings), KeyValue(true));
    EXPECT_EQ(keys.size(), 7U);
}

TEST(Key, a_value_fills_the_member_that_the_key_is_bound_to) {
    const KeyList<Settings> keys = all_keys();
    Settings settings;
    named(keys, "spacing").set(settings, 3.0);
    named(keys, "rounds").set(settings, std::int64_t{7});
    named(keys, "flow").set(settings, std::string("laminar"));
    named(keys, "speed").set(settings, 1.5);
    named(keys, "along").set(settings, Vec3{0, 1, 0});
    named(keys, "size").set(settings, 0.125);
    named(keys, "wet").set(settings, false);
    EXPECT_EQ(settings.spacing, 3.0);
    EXPECT_EQ(settings.rounds, 7);
    EXPECT_EQ(settings.flow, Flow::laminar);
    EXPECT_EQ(settings.speed, 1.5);
    EXPECT_EQ(settings.along, (Vec3{0, 1, 0}));
    EXPECT_EQ(settings.grains.size, 0.125);
    EXPECT_FALSE(settings.grains.is_wet);
    named(keys, "speed").set(settings, KeyValue());  // "auto"
    EXPECT_FALSE(settings.speed.has_value());
}

TEST(Key, every_word_of_a_choice_reads_back) {
    const KeyList<Settings> keys = all_keys();
    const BoundKey<Settings>& flow = named(keys, "flow");
    for (const std::string_view word : flow.row.words) {
        Settings settings;
        flow.set(settings, std::string(word));
        EXPECT_EQ(flow.get(settings), KeyValue(std::string(word)));
    }
    Settings settings;
    EXPECT_THROW(flow.set(settings, std::string("viscous")), InternalError);
}

TEST(Key, a_later_key_replaces_one_of_the_same_name_in_its_place) {
    const KeyList<Base> keys =
        base_keys() +
        KeyList<Base>{
            key::number(&Base::spacing, "spacing", dimension::length, key::between(1, 2), "Other help.").required()};
    ASSERT_EQ(keys.size(), 2U);
    EXPECT_EQ(keys.begin()->row.help, "Other help.");
    EXPECT_TRUE(keys.begin()->row.is_required);
}

// A word without a value and a word with the value of another enumeration do not compile.
template <class... Parts>
concept MakesAWord = requires(Parts... parts) {
    key::Word<Flow>{parts...};
};
static_assert(MakesAWord<const char*, Flow>);
static_assert(!MakesAWord<const char*>);
static_assert(!MakesAWord<const char*, int>);

// A key without a member, or with a member of another kind, does not compile.
template <class Member>
concept BindsANumber = requires(Member member) {
    key::number(member, "name", dimension::plain, key::any(), "Help.");
};
static_assert(BindsANumber<double Base::*>);
static_assert(!BindsANumber<std::int32_t Base::*>);
static_assert(!BindsANumber<std::nullptr_t>);

// A method without keys, or with the keys of its base, is none.
struct Nameless : Base {
    static constexpr std::string_view method_name = "nameless";
};
struct Heir : Base {
    static constexpr std::string_view method_name = "heir";
    static MethodKeys<Base> keys();
};
struct Whole : Base {
    static constexpr std::string_view method_name = "whole";
    static MethodKeys<Whole> keys();
};
static_assert(MethodSettings<Whole>);
static_assert(!MethodSettings<Nameless>);
static_assert(!MethodSettings<Heir>);

}  // namespace
}  // namespace riprap
