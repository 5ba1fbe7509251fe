// SPDX-License-Identifier: Apache-2.0
#include "riprap/sim/column_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace riprap::sim {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// "NAME[word]rest", "NAME[word level]rest" or "NAME[word level width]rest" in its parts.
struct Bracketed {
    std::string_view name, word, rest;
    std::vector<double> numbers{};
};

/// Returns how many numbers follow a word.
std::size_t numbers_of(std::string_view word) { return word == "front" ? 2 : word == "above" ? 1 : 0; }

/// The number that a text is; nothing where it is none.
std::optional<double> number_in(std::string_view text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_all = error == std::errc{} && end == text.data() + text.size() && std::isfinite(number);
    return is_all ? std::optional(number) : std::nullopt;
}

std::optional<Bracketed> split_brackets(std::string_view text) {
    const std::size_t open = text.find('['), close = text.find(']');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) {
        return std::nullopt;
    }
    std::string_view inside = text.substr(open + 1, close - open - 1);
    Bracketed parts{text.substr(0, open), inside.substr(0, inside.find(' ')), text.substr(close + 1)};
    for (std::size_t blank = inside.find(' '); blank != std::string_view::npos; blank = inside.find(' ')) {
        inside = inside.substr(blank + 1);
        const std::optional<double> number = number_in(inside.substr(0, inside.find(' ')));
        if (!number) {
            return std::nullopt;
        }
        parts.numbers.push_back(*number);
    }
    const bool is_group = std::find(group_words.begin(), group_words.end(), parts.word) != group_words.end();
    const bool has_width = parts.word != "front" || (parts.numbers.size() == 2 && parts.numbers[1] > 0);
    return is_group && has_width && parts.numbers.size() == numbers_of(parts.word) ? std::optional(parts)
                                                                                   : std::nullopt;
}

/// The first value, from the median on, above which the next `width` holds fewer than `count` of them.
double front_of(std::vector<double> values, double count, double width) {
    std::sort(values.begin(), values.end());
    auto front = values.begin() + std::ssize(values) / 2;
    for (; front != values.end(); ++front) {
        const auto next = std::upper_bound(front, values.end(), *front);
        if (static_cast<double>(std::upper_bound(next, values.end(), *front + width) - next) < count) {
            return *front;
        }
    }
    return missing;
}

/// Adds the columns of all bodies of one entry, of one body where it is no list; false where there is no such quantity.
bool add_bodies(const Model& model, std::string_view name, std::string_view rest, std::vector<Column>& columns) {
    std::optional<Column> first = find_column(model, fmt::format("{}[0]{}", name, rest));
    if (!first) {
        first = find_column(model, fmt::format("{}{}", name, rest));
    }
    if (!first || !first->body.is_valid()) {
        return false;
    }
    const body::BodySet& bodies = model.bodies;
    const std::int32_t entry = bodies.name_id[static_cast<std::size_t>(first->body.value)];
    const bool is_there_already = std::any_of(columns.begin(), columns.end(), [&](const Column& column) {
        return bodies.name_id[static_cast<std::size_t>(column.body.value)] == entry;
    });
    if (is_there_already) {
        return false;  // a body that is named twice would count twice
    }
    for (std::int32_t b = 0; b < bodies.size(); ++b) {
        if (bodies.name_id[static_cast<std::size_t>(b)] == entry) {
            columns.push_back(*first);
            columns.back().body = BodyId{b};
        }
    }
    return true;
}

/// Columns of all bodies of the entries whose names stand with commas between; empty where one is none.
std::vector<Column> columns_of_bodies(const Model& model, const Bracketed& parts) {
    std::vector<Column> columns;
    std::string_view names = parts.name;
    for (std::size_t comma = 0; comma != std::string_view::npos;) {
        comma = names.find(',');
        if (!add_bodies(model, names.substr(0, comma), parts.rest, columns)) {
            return {};
        }
        names = comma == std::string_view::npos ? names : names.substr(comma + 1);
    }
    return columns;
}

/// Distance of a gauge from the first of its profile [m].
double distance_between(const Model& model, const Column& first, const Column& column) {
    const auto point = [&model](const Column& one) {
        return model.output.gauges[static_cast<std::size_t>(one.gauge)].point;
    };
    return norm(point(column) - point(first));
}

}  // namespace

std::optional<Profile> find_profile(const Model& model, std::string_view text) {
    const std::size_t dot = text.find('.');
    const std::string_view name = text.substr(0, dot),
                           component = dot == std::string_view::npos ? std::string_view{} : text.substr(dot);
    const std::vector<Column> records = record_columns(model);
    const auto find = [&](int number, int digits) {
        const std::string wanted = fmt::format("{}_{:0{}}{}", name, number, digits, component);
        return std::find_if(records.begin(), records.end(),
                            [&wanted](const Column& column) { return column.gauge >= 0 && column.name == wanted; });
    };
    constexpr int most_digits = 4;  // of the thousand gauges of a profile
    Profile profile;
    for (int digits = 1; digits <= most_digits && profile.columns.empty(); ++digits) {
        for (int number = 1; find(number, digits) != records.end(); ++number) {
            profile.columns.push_back(*find(number, digits));
            profile.place.push_back(distance_between(model, profile.columns.front(), profile.columns.back()));
        }
    }
    return profile.columns.size() > 1 ? std::optional(std::move(profile)) : std::nullopt;
}

std::optional<ColumnGroup> find_columns(const Model& model, std::string_view text) {
    const std::optional<Bracketed> parts = split_brackets(text);
    if (!parts) {
        const std::optional<Column> column = find_column(model, text);
        return column ? std::optional(ColumnGroup{{}, {*column}}) : std::nullopt;
    }
    ColumnGroup group{*std::find(group_words.begin(), group_words.end(), parts->word),
                      columns_of_bodies(model, *parts)};
    group.level = parts->numbers.empty() ? 0 : parts->numbers.front();
    group.width = parts->numbers.size() < 2 ? 0 : parts->numbers[1];
    if (group.columns.empty()) {
        if (std::optional<Profile> profile = find_profile(model, fmt::format("{}{}", parts->name, parts->rest))) {
            group.columns = std::move(profile->columns);
        }
    }
    if (group.columns.empty()) {
        return std::nullopt;
    }
    for (Column& column : group.columns) {
        column.name = std::string(text);
        column.unit = group.word == "above" ? "-" : column.unit;
    }
    return group;
}

double evaluate(const ColumnGroup& group, const Moment& moment) {
    if (group.word.empty()) {
        return evaluate(group.columns.front(), moment);
    }
    double sum = 0, above = 0, least = std::numeric_limits<double>::infinity(), largest = -least;
    std::vector<double> values;
    for (const Column& column : group.columns) {
        const double value = evaluate(column, moment);
        if (std::isnan(value)) {
            return missing;
        }
        sum += value;
        above += value > group.level ? 1 : 0;
        least = std::min(least, value);
        largest = std::max(largest, value);
        if (group.word == "front") {
            values.push_back(value);
        }
    }
    return group.word == "front"   ? front_of(std::move(values), group.level, group.width)
           : group.word == "mean"  ? sum / static_cast<double>(group.columns.size())
           : group.word == "sum"   ? sum
           : group.word == "above" ? above
           : group.word == "min"   ? least
                                   : largest;
}

double evaluate(const Profile& profile, double place, const Moment& moment) {
    constexpr double forgiven = 1e-9;  // of its length: the last place may be missed by round-off
    const double length = profile.place.back();
    place = std::abs(place - length) < forgiven * length ? length : place;
    const auto next = std::lower_bound(profile.place.begin(), profile.place.end(), place);
    if (next == profile.place.end() || place < 0) {
        return missing;
    }
    const auto i = static_cast<std::size_t>(next - profile.place.begin());
    const double high = evaluate(profile.columns[i], moment);
    if (i == 0 || *next == place) {
        return high;
    }
    const double low = evaluate(profile.columns[i - 1], moment), x = profile.place[i - 1];
    return low + (high - low) * (place - x) / (profile.place[i] - x);
}

}  // namespace riprap::sim
