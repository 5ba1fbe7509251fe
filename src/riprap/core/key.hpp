// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "riprap/core/dimension.hpp"
#include "riprap/core/direction.hpp"
#include "riprap/core/error.hpp"
#include "riprap/core/key_problem.hpp"
#include "riprap/core/vec3.hpp"

/// Keys of a case file, each bound to the member of a settings struct that it fills. A method lists its keys beside its
/// settings; the reader of case files makes checks, help, schema, manual and the reading from that list. The default is
/// the value of the member in a default-constructed struct. A key without a member, and a word without a value, do not
/// compile.
///
///     MethodKeys<SphSettings> SphSettings::keys() {
///         using S = SphSettings;
///         return {.help = "smoothed particle hydrodynamics",
///                 .keys = {key::number(&S::courant, "courant", dimension::plain, key::between(0, 1), "Share of ..."),
///                          key::choice(&S::scheme, "scheme", {{"delta_sph", SphScheme::delta_sph}}, "Form of ...")}};
///     }
namespace riprap {

/// Accepted interval of a number.
struct Range {
    double low{-std::numeric_limits<double>::infinity()};
    double high{std::numeric_limits<double>::infinity()};
    bool is_low_open{false};   ///< low itself is refused
    bool is_high_open{false};  ///< high itself is refused
    bool contains(double v) const {
        return (is_low_open ? v > low : v >= low) && (is_high_open ? v < high : v <= high);
    }
    bool is_bounded() const { return low > -1e308 || high < 1e308; }
    friend bool operator==(const Range&, const Range&) = default;
};

/// Value of a key, numbers in SI: nothing where it is not given or given as the word of `number_or`, the word of a
/// choice as text.
using KeyValue = std::variant<std::monostate, bool, std::int64_t, double, Vec3, std::string>;

/// direction, axis: vectors of any length that fill a member with a unit vector; an axis is one of a turn.
enum class KeyKind : std::uint8_t { boolean, integer, number, choice, vector, direction, axis, text, name };

/// A condition under which a key is read: another key of the same method has one of these values.
struct KeyCondition {
    std::string_view key;
    std::vector<std::string_view> words{};  ///< of a choice, or "true" or "false"; none: a number above `above`
    double above{0};
    friend bool operator==(const KeyCondition&, const KeyCondition&) = default;
};

/// Name, meaning and accepted values of a key.
struct KeyRow {
    std::string_view name;
    std::string_view help;  ///< a sentence or two
    KeyKind kind{KeyKind::number};
    Dimension dimension{};                  ///< of numbers and components
    Range range{};                          ///< of numbers, integers and components
    std::vector<std::string_view> words{};  ///< of a choice; of a number the word that stands for no number
    bool is_required{false};
    std::vector<KeyCondition> conditions{};  ///< the key does nothing unless all hold
};

/// A key and the member of S that it fills.
template <class S>
struct BoundKey {
    KeyRow row;
    std::function<KeyValue(const S&)> get;
    std::function<void(S&, const KeyValue&)> set;

    /// Makes the key one without a default: a case has to give it.
    BoundKey required() && {
        row.is_required = true;
        return std::move(*this);
    }
    /// Makes the key one that is read only where `other` has one of the words, or a number above `above`.
    BoundKey read_with(std::string_view other, std::vector<std::string_view> words) && {
        row.conditions.push_back({other, std::move(words)});
        return std::move(*this);
    }
    BoundKey read_above(std::string_view other, double above) && {
        row.conditions.push_back({other, {}, above});
        return std::move(*this);
    }
    /// Keys of a base fill the base of a derived struct.
    template <std::derived_from<S> Derived>
    operator BoundKey<Derived>() const {
        return {row, get, set};
    }
};

/// Keys in the order of the manual. Lists add up; a key replaces one of the same name before it.
template <class S>
class KeyList {
 public:
    KeyList() = default;
    KeyList(std::initializer_list<BoundKey<S>> keys) {
        for (const BoundKey<S>& key : keys) {
            add(key);
        }
    }
    template <class Base>
    requires(std::derived_from<S, Base> && !std::same_as<S, Base>) KeyList(const KeyList<Base>& keys) {
        for (const BoundKey<Base>& key : keys) {
            add(key);
        }
    }

    void add(BoundKey<S> key) {
        const auto same = std::find_if(keys_.begin(), keys_.end(),
                                       [&key](const BoundKey<S>& other) { return other.row.name == key.row.name; });
        if (same != keys_.end()) {
            *same = std::move(key);
        } else {
            keys_.push_back(std::move(key));
        }
    }
    friend KeyList operator+(KeyList first, const KeyList& second) {
        for (const BoundKey<S>& key : second) {
            first.add(key);
        }
        return first;
    }
    /// Adds a condition to every key of the list.
    KeyList read_with(std::string_view other, const std::vector<std::string_view>& words) && {
        for (BoundKey<S>& key : keys_) {
            key.row.conditions.push_back({other, words});
        }
        return std::move(*this);
    }
    auto begin() const { return keys_.begin(); }
    auto end() const { return keys_.end(); }
    std::size_t size() const { return keys_.size(); }

 private:
    std::vector<BoundKey<S>> keys_;
};

/// All that a case can say of a method.
template <class S>
struct MethodKeys {
    std::string_view help;  ///< the method in a few words, without a full stop
    KeyList<S> keys;
    std::vector<std::string_view> scene_keys{};  ///< keys of scene/ that the method reads: "domain", "region", ...
    std::vector<KeyProblem> (*check)(const S&){nullptr};  ///< looks at values together, after each passed its own range
};

/// Settings of a method that a case can choose: its word and its keys.
template <class S>
concept MethodSettings = std::default_initializable<S> && requires {
    { S::method_name } -> std::convertible_to<std::string_view>;
    { S::keys() } -> std::same_as<MethodKeys<S>>;
};

namespace key {

inline Range any() { return {}; }
inline Range positive() { return {.low = 0, .is_low_open = true}; }
inline Range non_negative() { return {.low = 0}; }
inline Range between(double low, double high) { return {.low = low, .high = high}; }
/// low <= value < high
inline Range below(double low, double high) { return {.low = low, .high = high, .is_high_open = true}; }
/// low < value <= high
inline Range above(double low, double high) { return {.low = low, .high = high, .is_low_open = true}; }

template <class S>
BoundKey<S> boolean(bool S::*member, std::string_view name, std::string_view help) {
    return {{.name = name, .help = help, .kind = KeyKind::boolean},
            [member](const S& s) -> KeyValue { return s.*member; },
            [member](S& s, const KeyValue& value) { s.*member = std::get<bool>(value); }};
}

template <class S, std::integral T>
requires(!std::same_as<T, bool>) BoundKey<S> integer(T S::*member, std::string_view name, double low, double high,
                                                     std::string_view help) {
    return {{.name = name, .help = help, .kind = KeyKind::integer, .range = between(low, high)},
            [member](const S& s) -> KeyValue { return static_cast<std::int64_t>(s.*member); },
            [member](S& s, const KeyValue& value) { s.*member = static_cast<T>(std::get<std::int64_t>(value)); }};
}

template <class S>
BoundKey<S> number(double S::*member, std::string_view name, const Dimension& dimension, const Range& range,
                   std::string_view help) {
    return {{.name = name, .help = help, .kind = KeyKind::number, .dimension = dimension, .range = range},
            [member](const S& s) -> KeyValue { return s.*member; },
            [member](S& s, const KeyValue& value) { s.*member = std::get<double>(value); }};
}

/// A number that need not be given: the member then stays empty.
template <class S>
BoundKey<S> number(std::optional<double> S::*member, std::string_view name, const Dimension& dimension,
                   const Range& range, std::string_view help) {
    return {{.name = name, .help = help, .kind = KeyKind::number, .dimension = dimension, .range = range},
            [member](const S& s) { return s.*member ? KeyValue(*(s.*member)) : KeyValue(); },
            [member](S& s, const KeyValue& value) {
                const double* given = std::get_if<double>(&value);
                s.*member = given != nullptr ? std::optional(*given) : std::nullopt;
            }};
}

/// A number, or a word for none: the member is empty for the word.
template <class S>
BoundKey<S> number_or(std::optional<double> S::*member, std::string_view name, std::string_view word,
                      const Dimension& dimension, const Range& range, std::string_view help) {
    BoundKey<S> key = number(member, name, dimension, range, help);
    key.row.words = {word};
    return key;
}
template <class S>
BoundKey<S> number_or_auto(std::optional<double> S::*member, std::string_view name, const Dimension& dimension,
                           const Range& range, std::string_view help) {
    return number_or(member, name, "auto", dimension, range, help);
}

/// @param range  of every component
template <class S>
BoundKey<S> vector(Vec3 S::*member, std::string_view name, const Dimension& dimension, const Range& range,
                   std::string_view help) {
    return {{.name = name, .help = help, .kind = KeyKind::vector, .dimension = dimension, .range = range},
            [member](const S& s) -> KeyValue { return s.*member; },
            [member](S& s, const KeyValue& value) { s.*member = std::get<Vec3>(value); }};
}

/// A vector that need not be given: the member then stays empty.
template <class S>
BoundKey<S> vector(std::optional<Vec3> S::*member, std::string_view name, const Dimension& dimension,
                   std::string_view help) {
    return {{.name = name, .help = help, .kind = KeyKind::vector, .dimension = dimension},
            [member](const S& s) { return s.*member ? KeyValue(*(s.*member)) : KeyValue(); },
            [member](S& s, const KeyValue& value) { s.*member = std::get<Vec3>(value); }};
}

/// A vector that gives a direction, or the axis of a turn: the member is a unit vector.
template <class S>
BoundKey<S> direction(Vec3 S::*member, std::string_view name, std::string_view help) {
    return {{.name = name, .help = help, .kind = KeyKind::direction},
            [member](const S& s) -> KeyValue { return s.*member; },
            [member](S& s, const KeyValue& value) { s.*member = direction_of(std::get<Vec3>(value)); }};
}
template <class S>
BoundKey<S> axis(Vec3 S::*member, std::string_view name, std::string_view help) {
    BoundKey<S> key = direction(member, name, help);
    key.row.kind = KeyKind::axis;
    return key;
}

/// A text; one that is a name is safe in columns and file names. Without a default where the member is empty.
template <class S>
BoundKey<S> text(std::string S::*member, std::string_view name, std::string_view help) {
    return {{.name = name, .help = help, .kind = KeyKind::text},
            [member](const S& s) { return (s.*member).empty() ? KeyValue() : KeyValue(s.*member); },
            [member](S& s, const KeyValue& value) { s.*member = std::get<std::string>(value); }};
}
template <class S>
BoundKey<S> name(std::string S::*member, std::string_view name, std::string_view help) {
    BoundKey<S> key = text(member, name, help);
    key.row.kind = KeyKind::name;
    return key;
}

/// A word of a choice and the value that it stands for.
template <class E>
struct Word {
    constexpr Word(std::string_view word, E meaning) : text(word), value(meaning) {}
    std::string_view text;
    E value;
};

template <class E>
std::vector<std::string_view> texts_of(const std::vector<Word<E>>& words) {
    std::vector<std::string_view> texts;
    for (const Word<E>& word : words) {
        texts.push_back(word.text);
    }
    return texts;
}
template <class E>
std::string word_of(const std::vector<Word<E>>& words, E value) {
    for (const Word<E>& word : words) {
        if (word.value == value) {
            return std::string(word.text);
        }
    }
    throw InternalError("the default of a choice has no word");
}
template <class E>
E value_of(const std::vector<Word<E>>& words, const std::string& text) {
    for (const Word<E>& word : words) {
        if (word.text == text) {
            return word.value;
        }
    }
    throw InternalError("'" + text + "' is no word of its choice");
}

/// One of a few words.
template <class S, class E>
BoundKey<S> choice(E S::*member, std::string_view name, std::vector<Word<std::type_identity_t<E>>> words,
                   std::string_view help) {
    return {
        {.name = name, .help = help, .kind = KeyKind::choice, .words = texts_of(words)},
        [member, words](const S& s) -> KeyValue { return word_of(words, s.*member); },
        [member, words](S& s, const KeyValue& value) { s.*member = value_of(words, std::get<std::string>(value)); }};
}

/// Keys of a part of the settings.
template <class S, class Part>
KeyList<S> within(Part S::*part, const KeyList<Part>& keys) {
    KeyList<S> list;
    for (const BoundKey<Part>& key : keys) {
        list.add({key.row, [part, get = key.get](const S& s) { return get(s.*part); },
                  [part, set = key.set](S& s, const KeyValue& value) { set(s.*part, value); }});
    }
    return list;
}

}  // namespace key
}  // namespace riprap
