// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/keys/check_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "riprap/scene/keys/check_value.hpp"
#include "riprap/scene/text/limits.hpp"
#include "riprap/scene/text/suggest.hpp"

namespace riprap::scene {

namespace {

std::string join(const std::vector<std::string_view>& words, std::string_view separator) {
    std::string text;
    for (const std::string_view word : words) {
        text += text.empty() ? "" : separator;
        text += word;
    }
    return text;
}

class Checker {
 public:
    Checker(bool is_planar, std::vector<Diagnostic>& problems) : values_(is_planar, problems), problems_(problems) {}

    Value table(const Value& given, const Table& table) {
        if (table.methods.empty()) {
            return keys(given, table);
        }
        const std::string method = method_of(given, table);
        if (!method.empty()) {
            return keys(given, table.part_of(method));
        }
        // Only the word itself is told of: which keys belong to it cannot be known.
        const Table word{table.id, table.header, table.help, {table.keys.front()}};
        Value alone = Value::table();
        alone.place = given.place;
        alone.set("method", *given.find("method"));
        return keys(alone, word);
    }

 private:
    /// The method of a table; the nearest for a misspelt word, empty where none is near.
    static std::string method_of(const Value& given, const Table& table) {
        const Value* word = given.find("method");
        if (word == nullptr) {
            return std::string(table.methods.front());
        }
        return word->is_text() ? nearest(word->text, {table.methods.begin(), table.methods.end()}) : "";
    }

    Value keys(const Value& given, const Table& table) {
        Value out = Value::table();
        out.place = given.place;
        std::vector<std::string_view> seen;
        // Values are stored in the order of the key table, so that the resolved case has one canonical form.
        std::map<std::string_view, Value> accepted;
        for (const Entry& entry : given.entries) {
            take(entry, table, seen, accepted);
        }
        check_groups(given, table, seen);
        for (const Key& key : table.keys) {
            if (const auto it = accepted.find(key.name); it != accepted.end()) {
                out.entries.push_back({std::string(key.name), it->second.place, std::move(it->second)});
            } else if (std::find(seen.begin(), seen.end(), key.name) == seen.end()) {
                add_default(given, table, key, seen, out);
            }
        }
        return out;
    }

    void take(const Entry& entry, const Table& table, std::vector<std::string_view>& seen,
              std::map<std::string_view, Value>& accepted) {
        const Key* key = table.find(entry.key);
        std::optional<Unit> unit;
        if (key == nullptr) {
            if (const auto suffixed = split_unit_suffix(entry.key)) {
                key = table.find(suffixed->base);
                unit = suffixed->unit;
                if (key != nullptr && !accepts_unit(*key, unit->dimension)) {
                    key = nullptr;
                }
            }
        }
        if (key == nullptr) {
            unknown_key(entry, table);
            return;
        }
        if (std::find(seen.begin(), seen.end(), key->name) != seen.end()) {
            problems_.push_back({entry.place, fmt::format("'{}' is given twice in {}", key->name, table.header),
                                 "once, with or without a unit in its name"});
            return;
        }
        seen.push_back(key->name);
        std::optional<Value> value = any_form(entry.value, *key, unit, table);
        if (value) {
            value->place = entry.value.place;
            accepted.emplace(key->name, std::move(*value));
        }
    }

    static bool accepts_unit(const Key& key, const Dimension& dimension) {
        const auto has = [&dimension](const Form& form) {
            const Form* at = &form;
            while (at->kind == FormKind::list && !at->item.empty()) {
                at = &at->item.front();
            }
            return (at->kind == FormKind::number || at->kind == FormKind::vector) && at->dimension == dimension;
        };
        return std::any_of(key.forms.begin(), key.forms.end(), has);
    }

    /// The value in the first form that its kind fits; a problem that names all forms when none does.
    std::optional<Value> any_form(const Value& given, const Key& key, const std::optional<Unit>& unit,
                                  const Table& table) {
        const Form* best = nullptr;
        for (const Form& form : key.forms) {
            if (fits(given, form) && best == nullptr) {
                best = &form;
            }
        }
        // "auto" and "1 ms" are both texts: a text that is no word of the choice is tried as a quantity.
        if (best != nullptr && best->kind == FormKind::choice && key.forms.size() > 1 &&
            std::find(best->words.begin(), best->words.end(), given.text) == best->words.end() && !given.text.empty() &&
            (std::isdigit(static_cast<unsigned char>(given.text.front())) != 0 || given.text.front() == '-' ||
             given.text.front() == '+' || given.text.front() == '.')) {
            best = &key.forms.back();
        }
        if (best == nullptr) {
            std::string allowed;
            for (const Form& form : key.forms) {
                allowed += (allowed.empty() ? "" : ", or ") + describe_form(form);
            }
            problems_.push_back(
                {given.place, fmt::format("{} of {} is {}", key.name, table.header, describe(given.kind)), allowed});
            return std::nullopt;
        }
        const std::string name = fmt::format("{} of {}", key.name, table.header);
        return one_form(given, *best, name, unit);
    }

    std::optional<Value> one_form(const Value& given, const Form& form, const std::string& name,
                                  const std::optional<Unit>& unit) {
        switch (form.kind) {
            case FormKind::table:
                return table(given, form.table());
            case FormKind::table_list: {
                Value out = Value::array();
                for (const Value& item : given.items) {
                    out.items.push_back(table(item, form.table()));
                }
                if (static_cast<std::int64_t>(given.items.size()) < form.min_count) {
                    problems_.push_back({given.place, fmt::format("{} is empty", name),
                                         fmt::format("at least {} wanted", form.min_count)});
                }
                return out;
            }
            case FormKind::named_tables: {
                Value out = Value::table();
                if (static_cast<std::int64_t>(given.entries.size()) > form.max_count) {
                    problems_.push_back({given.place, fmt::format("{} has {} entries", name, given.entries.size()),
                                         fmt::format("at most {} are accepted", form.max_count)});
                    return std::nullopt;
                }
                for (const Entry& entry : given.entries) {
                    if (!entry.value.is_table()) {
                        problems_.push_back({entry.place,
                                             fmt::format("'{}' is {}", entry.key, describe(entry.value.kind)),
                                             fmt::format("{} wants a table", form.table().header)});
                        continue;
                    }
                    if (!is_name(entry.key)) {
                        problems_.push_back({entry.place, fmt::format("'{}' is not a name", entry.key), name_rule});
                        continue;
                    }
                    out.set(entry.key, table(entry.value, form.table()), entry.place);
                }
                return out;
            }
            case FormKind::list: {
                const auto count = static_cast<std::int64_t>(given.items.size());
                if (count < form.min_count || count > form.max_count) {
                    problems_.push_back(
                        {given.place, fmt::format("{} has {} entries", name, count), describe_form(form)});
                    return std::nullopt;
                }
                Value out = Value::array();
                for (const Value& item : given.items) {
                    if (!fits(item, form.item.front())) {
                        problems_.push_back({item.place, fmt::format("an entry of {} is {}", name, describe(item.kind)),
                                             describe_form(form.item.front())});
                        return std::nullopt;
                    }
                    auto value = one_form(item, form.item.front(), "an entry of " + name, unit);
                    if (!value) {
                        return std::nullopt;
                    }
                    out.items.push_back(std::move(*value));
                }
                out.place = given.place;  // of entries of a list, too
                return out;
            }
            default:
                return values_.check(given, form, name, unit);
        }
    }

    void unknown_key(const Entry& entry, const Table& table) {
        std::vector<std::string> known;
        for (const Key& key : table.keys) {
            known.emplace_back(key.name);
            for (const Form& form : key.forms) {
                if (form.dimension == dimension::angle) {
                    known.push_back(std::string(key.name) + "_deg");
                }
            }
        }
        if (problems_.size() > limits::problems) {
            problems_.push_back({entry.place, fmt::format("unknown key '{}'", entry.key), ""});  // will only be counted
            return;
        }
        if (table.whole != nullptr && key_of_another_method(entry, table)) {
            return;
        }
        std::string allowed = nearest(entry.key, known);
        if (!allowed.empty()) {
            allowed = fmt::format("did you mean '{}'?", allowed);
        } else if (const std::string elsewhere = find_elsewhere(entry.key); !elsewhere.empty()) {
            allowed = fmt::format("it is a key of {}", elsewhere);
        } else {
            std::vector<std::string_view> names;
            for (const Key& key : table.keys) {
                names.push_back(key.name);
            }
            allowed = "known keys: " + join(names, ", ");
        }
        problems_.push_back({entry.place, fmt::format("unknown key '{}' in {}", entry.key, table.header), allowed});
    }

    /// A problem where the key is one of a method that is not chosen.
    bool key_of_another_method(const Entry& entry, const Table& part) {
        const auto suffixed = split_unit_suffix(entry.key);
        std::vector<std::string_view> methods;
        for (const Key& key : part.whole->keys) {
            if (key.name == entry.key || (suffixed && key.name == suffixed->base)) {
                methods.insert(methods.end(), key.methods.begin(), key.methods.end());
            }
        }
        if (methods.empty()) {
            return false;
        }
        problems_.push_back({entry.place,
                             fmt::format("'{}' is a key of {} with method = \"{}\"; the method here is \"{}\"",
                                         entry.key, part.header, join(methods, "\" or \""), part.method),
                             "leave it out, or choose that method"});
        return true;
    }

    static std::string find_elsewhere(std::string_view key) {
        for (const Table* table : all_tables()) {
            if (table->find(key) != nullptr) {
                return std::string(table->header);
            }
        }
        return "";
    }

    void check_groups(const Value& given, const Table& table, const std::vector<std::string_view>& seen) {
        for (const Group& group : table.groups) {
            std::vector<std::string_view> present;
            for (const std::string_view key : group.keys) {
                if (std::find(seen.begin(), seen.end(), key) != seen.end()) {
                    present.push_back(key);
                }
            }
            if (group.rule == GroupRule::exactly_one && present.empty()) {
                // A misspelt key has its own problem; "one of these is missing" would only repeat it.
                if (given.entries.size() == seen.size()) {
                    problems_.push_back({given.place, fmt::format("{} lacks one of its keys", table.header),
                                         "exactly one of: " + join(group.keys, ", ")});
                }
            } else if (group.rule != GroupRule::all_or_none && present.size() > 1) {
                problems_.push_back({place_of(given, present[1]),
                                     fmt::format("{} gives both '{}' and '{}'", table.header, present[0], present[1]),
                                     "only one of: " + join(group.keys, ", ")});
            } else if (group.rule == GroupRule::all_or_none && !present.empty() && present.size() < group.keys.size()) {
                problems_.push_back({place_of(given, present[0]),
                                     fmt::format("{} gives '{}' alone", table.header, join(present, "', '")),
                                     "give all or none of: " + join(group.keys, ", ")});
            }
        }
    }

    static SourcePlace place_of(const Value& table, std::string_view key) {
        for (const Entry& entry : table.entries) {
            const auto suffixed = split_unit_suffix(entry.key);
            if (entry.key == key || (suffixed && suffixed->base == key)) {
                return entry.place;
            }
        }
        return table.place;
    }

    void add_default(const Value& given, const Table& table, const Key& key, const std::vector<std::string_view>& seen,
                     Value& out) {
        if (key.is_required) {
            const bool may_be_misspelt =
                std::any_of(given.entries.begin(), given.entries.end(), [&](const Entry& entry) {
                    return table.find(entry.key) == nullptr && nearest(entry.key, {std::string(key.name)}) == key.name;
                });
            if (!may_be_misspelt) {
                problems_.push_back({given.place, fmt::format("{} lacks '{}'", table.header, key.name),
                                     fmt::format("{}: {}", describe_form(key.forms.front()), key.help)});
            }
            return;
        }
        if (!key.otherwise) {
            return;
        }
        for (const Group& group : table.groups) {
            const bool is_member = std::find(group.keys.begin(), group.keys.end(), key.name) != group.keys.end();
            const bool has_rival = std::any_of(group.keys.begin(), group.keys.end(), [&seen](std::string_view other) {
                return std::find(seen.begin(), seen.end(), other) != seen.end();
            });
            if (is_member && has_rival && group.rule != GroupRule::all_or_none) {
                return;
            }
        }
        Value value = *key.otherwise;
        if (key.forms.front().kind == FormKind::table) {
            value = this->table(value, key.forms.front().table());  // a section that is not given has its defaults
        }
        value.place = given.place;
        out.entries.push_back({std::string(key.name), given.place, std::move(value)});
    }

    ValueChecker values_;
    std::vector<Diagnostic>& problems_;
};

}  // namespace

Value check_keys(const Value& root, const Table& table, bool is_planar, std::vector<Diagnostic>& problems) {
    return Checker(is_planar, problems).table(root, table);
}

}  // namespace riprap::scene
