// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/keys/check_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "riprap/scene/text/suggest.hpp"

namespace riprap::scene {

bool is_name(std::string_view text) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto is_allowed = [&](char c) {
        return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
    };
    return !text.empty() && text.size() <= 64 && is_letter(text.front()) &&
           std::all_of(text.begin(), text.end(), is_allowed);
}

bool fits(const Value& given, const Form& form) {
    switch (form.kind) {
        case FormKind::boolean:
            return given.kind == ValueKind::boolean;
        case FormKind::integer:
            return given.kind == ValueKind::integer;
        case FormKind::number:
            return given.is_number() || given.is_text();
        case FormKind::text:
        case FormKind::name:
        case FormKind::path:
        case FormKind::choice:
            return given.is_text();
        case FormKind::vector:
        case FormKind::list:
            return given.is_array();
        case FormKind::table_list:
            return given.is_array() && std::all_of(given.items.begin(), given.items.end(),
                                                   [](const Value& item) { return item.is_table(); });
        case FormKind::table:
        case FormKind::named_tables:
            return given.is_table();
    }
    return false;
}

std::string describe_range(const Range& range) {
    if (!range.is_bounded()) {
        return "";
    }
    std::string text;
    if (range.low > -1e308) {
        text += fmt::format("{} {} ", range.low, range.is_low_open ? "<" : "<=");
    }
    text += "value";
    if (range.high < 1e308) {
        text += fmt::format(" {} {}", range.is_high_open ? "<" : "<=", range.high);
    }
    return text;
}

namespace {

/// The range in a unit of its own, for keys that name theirs and for angles, which few know in radians.
std::string range_in(const Range& range, const Unit& unit, std::string_view name) {
    const auto convert = [&unit](double x) {  // to the digits that are shown
        return std::abs(x) < 1e308 ? std::strtod(fmt::format("{:.6g}", x / to_si(1, unit)).c_str(), nullptr) : x;
    };
    Range scaled = range;
    scaled.low = convert(range.low);
    scaled.high = convert(range.high);
    const std::string text = describe_range(scaled);
    return text.empty() ? text : fmt::format("{} {}", text, name);
}

/// The name of a unit of one word; empty for others.
std::string name_of(const Unit& unit) {
    std::string names = suffixes_for(unit.dimension);
    for (std::size_t begin = 0; begin < names.size();) {
        const std::size_t end = std::min(names.find('|', begin), names.size());
        const std::string name = names.substr(begin, end - begin);
        if (const auto named = parse_unit(name); named && to_si(1, *named) == to_si(1, unit)) {
            return name;
        }
        begin = end + 1;
    }
    return "";
}

/// What a number may be, in the unit that the name of its key ends with.
std::string describe_number(const Form& form, const std::optional<Unit>& unit) {
    const std::string name = unit && form.range.is_bounded() ? name_of(*unit) : "";
    return name.empty() ? describe_form(form)
                        : fmt::format("{}, {}", describe(form.dimension), range_in(form.range, *unit, name));
}

}  // namespace

std::string describe_form(const Form& form) {
    const std::string range = describe_range(form.range);
    const std::string tail = range.empty() ? "" : ", " + range;
    switch (form.kind) {
        case FormKind::boolean:
            return "true or false";
        case FormKind::integer:
            return "an integer" + tail;
        case FormKind::number:
            return form.dimension.is_plain()
                       ? "a number" + tail
                       : fmt::format("{} [{}]{}", describe(form.dimension), si_unit(form.dimension), tail);
        case FormKind::text:
            return "a text";
        case FormKind::name:
            return "a name";
        case FormKind::path:
            return "a file in the folder of the case";
        case FormKind::choice: {
            std::string text;
            for (const std::string_view word : form.words) {
                text += fmt::format("{}\"{}\"", text.empty() ? "" : ", ", word);
            }
            return form.words.size() == 1 ? text : "one of " + text;
        }
        case FormKind::vector:
            return form.is_nonzero ? "a vector that is not zero"
                                   : fmt::format("a vector [{}]{}", si_unit(form.dimension), tail);
        case FormKind::list: {
            const std::string count = form.min_count == form.max_count
                                          ? fmt::format("{}", form.min_count)
                                          : fmt::format("{} to {}", form.min_count, form.max_count);
            return fmt::format("an array of {} entries, each {}", count, describe_form(form.item.front()));
        }
        case FormKind::table:
        case FormKind::named_tables:
            return fmt::format("a table, {}", form.table().header);
        case FormKind::table_list:
            return fmt::format("an array of tables, {}", form.table().header);
    }
    return "";
}

std::optional<Value> ValueChecker::refuse(const Value& given, std::string message, std::string allowed) {
    problems_.push_back({given.place, std::move(message), std::move(allowed)});
    return std::nullopt;
}

std::optional<Value> ValueChecker::check(const Value& given, const Form& form, const std::string& name,
                                         const std::optional<Unit>& unit) {
    const auto at_place = [&given](Value out) {  // of entries of a list, too
        out.place = given.place;
        return out;
    };
    switch (form.kind) {
        case FormKind::boolean:
            return at_place(Value::of(given.boolean));
        case FormKind::integer:
            if (!form.range.contains(static_cast<double>(given.integer))) {
                return refuse(given, fmt::format("{} = {}", name, given.integer), describe_form(form));
            }
            return at_place(Value::of(given.integer));
        case FormKind::number:
            return number(given, form, name, unit);
        case FormKind::vector:
            return vector(given, form, name, unit);
        default:
            return text(given, form, name);
    }
}

std::optional<Value> ValueChecker::number(const Value& given, const Form& form, const std::string& name,
                                          const std::optional<Unit>& unit) {
    double value = given.as_number();
    if (given.is_text()) {
        if (unit) {
            return refuse(given,
                          fmt::format("{} = {}: the unit is already in the name of the key", name, excerpt(given)),
                          "a bare number");
        }
        const Quantity quantity = parse_quantity(given.text, form.dimension);
        if (!quantity.problem.empty()) {
            return refuse(given, fmt::format("{} = {}: {}", name, excerpt(given), quantity.problem),
                          describe_form(form));
        }
        value = quantity.value;
    } else if (unit) {
        value = to_si(value, *unit);
    }
    if (!std::isfinite(value)) {
        return refuse(given, fmt::format("{} = {} is not a finite number", name, excerpt(given)), describe_form(form));
    }
    if (!form.range.contains(value)) {
        const bool is_angle = form.dimension == dimension::angle && !unit;
        const std::string degrees = is_angle ? range_in(form.range, *parse_unit("deg"), "deg") : "";
        return refuse(given, fmt::format("{} = {}", name, excerpt(given)),
                      describe_number(form, unit) + (degrees.empty() ? "" : " (" + degrees + ")"));
    }
    Value out = Value::of(value == 0 ? 0.0 : value);  // no negative zero: one canonical form
    out.place = given.place;
    return out;
}

std::optional<Value> ValueChecker::vector(const Value& given, const Form& form, const std::string& name,
                                          const std::optional<Unit>& unit) {
    const std::size_t count = given.items.size();
    if (count != 3 && !(is_planar_ && count == 2 && !form.is_axial)) {
        return refuse(given, fmt::format("{} has {} components", name, count),
                      is_planar_ && !form.is_axial ? "2 components in a planar scene" : "3 components");
    }
    Value out = Value::array();
    bool is_zero = true;
    for (const Value& item : given.items) {
        if (!item.is_number() && !item.is_text()) {
            return refuse(item, fmt::format("a component of {} is {}", name, describe(item.kind)), describe_form(form));
        }
        const auto component =
            number(item, {.kind = FormKind::number, .dimension = form.dimension, .range = form.range}, name, unit);
        if (!component) {
            return std::nullopt;
        }
        is_zero = is_zero && component->number == 0;
        out.items.push_back(*component);
    }
    if (count == 3 && is_planar_) {
        const bool is_size = !form.range.contains(0);
        const bool is_in_plane = form.is_axial ? out.items[0].number == 0 && out.items[1].number == 0
                                               : out.items[2].number == (is_size ? 1.0 : 0.0);
        if (!is_in_plane) {
            return refuse(given,
                          fmt::format("{} = {} leaves the plane of a scene with dimension = 2", name, excerpt(given)),
                          form.is_axial ? "only the z component"
                          : is_size     ? "x and y; z is 1 m"
                                        : "x and y; z is 0");
        }
    }
    if (count == 2) {
        // Sizes (which must be positive) are one unit thick in a planar scene; everything else lies in the plane.
        out.items.push_back(Value::of(form.range.contains(0) ? 0.0 : 1.0));
    }
    if (form.is_nonzero && is_zero) {
        return refuse(given, fmt::format("{} is zero", name), "a direction of any length but zero");
    }
    out.place = given.place;
    return out;
}

std::optional<Value> ValueChecker::text(const Value& given, const Form& form, const std::string& name) {
    if (form.kind == FormKind::name && !is_name(given.text)) {
        return refuse(given, fmt::format("{} = {} is not a name", name, excerpt(given)), name_rule);
    }
    if (form.kind == FormKind::path && given.text.empty()) {
        return refuse(given, fmt::format("{} is empty", name), describe_form(form));
    }
    if (form.kind == FormKind::choice) {
        const std::string_view word = given.text;
        if (std::find(form.words.begin(), form.words.end(), word) == form.words.end()) {
            const std::string meant = nearest(word, {form.words.begin(), form.words.end()});
            return refuse(given, fmt::format("{} = {} is not known", name, excerpt(given)),
                          meant.empty() ? describe_form(form)
                                        : fmt::format("did you mean \"{}\"? {}", meant, describe_form(form)));
        }
    }
    Value out = Value::of(given.text);
    out.place = given.place;
    return out;
}

}  // namespace riprap::scene
