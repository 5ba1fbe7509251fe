// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/dda_files/dda_unread.hpp"

#include <algorithm>
#include <numeric>

#include "riprap/geometry/text/heading_words.hpp"

namespace riprap::geometry::dda_text {

namespace {

/// Letters to put in, leave out or change to make one word of another.
std::size_t changes_between(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

bool holds_numbers(const std::vector<MarkupElement>& elements, const MarkupElement& element) {
    return std::any_of(element.words.begin(), element.words.end(),
                       [](const Word& word) { return parse_number(word.text).has_value(); }) ||
           std::any_of(element.children.begin(), element.children.end(),
                       [&](std::size_t child) { return holds_numbers(elements, elements[child]); });
}

}  // namespace

void take_unread(const std::vector<MarkupElement>& elements, const MarkupElement& element,
                 const std::vector<std::string_view>& known, Numbers& numbers, std::vector<std::string>& notes) {
    const std::string name = lower_case(element.name);
    std::string_view nearest;
    std::size_t least = name.size() / 3 + 1;
    std::string all;
    for (const std::string_view one : known) {
        const std::size_t changes = changes_between(name, lower_case(one));
        nearest = changes < least ? one : nearest;
        least = std::min(least, changes);
        all += fmt::format("{}<{}>", all.empty() ? "" : ", ", one);
    }
    constexpr std::size_t slip = 2;
    if (!holds_numbers(elements, element) && (nearest.empty() || least > slip)) {
        note_unused(notes, element);
        return;
    }
    numbers.report({element.name, element.line, element.column}, fmt::format("<{}> is not read", element.name),
                   nearest.empty() ? fmt::format("{}; leave out what the blocks do not need", all)
                                   : fmt::format("<{}>?", nearest));
}

void compare_counts(const MarkupElement& element, std::int64_t count, std::string_view entries, Numbers& numbers) {
    for (const auto& [key, value] : element.attributes) {
        if (!lower_case(key).starts_with("num")) {
            continue;
        }
        const std::string name(key);
        if (numbers.count(value, name.c_str()) != count) {
            numbers.report(value, fmt::format("{} is {}, and {} {} follow", name, quote(value.text), count, entries),
                           fmt::format("the number of {}", entries));
        }
    }
}

}  // namespace riprap::geometry::dda_text
