// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/geometry/dda_files/dda_markup.hpp"

// Shares what both readers of the files of the 2D-DDA family need.

namespace riprap::geometry::dda_text {

constexpr std::int64_t most_entries = 10'000'000;
constexpr const char* not_negative = "a number of 0 or more";

/// Tells markup from rows of bare numbers.
inline bool is_markup(std::string_view bytes) {
    const std::size_t first = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return first != std::string_view::npos && bytes[first] == '<';
}

/// Turns words into numbers and reports those that are none.
class Numbers {
 public:
    Numbers(const std::string& file, ProblemList& problems) : file_(file), problems_(problems) {}

    double number(const Word& word, const char* what) {
        const std::optional<double> value = parse_number(word.text);
        if (value && std::isfinite(*value)) {
            return *value;
        }
        if (!has_ended(word, what)) {
            report(word, fmt::format("{} is {}, not a finite number", what, quote(word.text)));
        }
        return 0;
    }
    std::int64_t count(const Word& word, const char* what) {
        const std::optional<std::int64_t> value = parse_integer(word.text);
        if (value && *value >= 0 && *value <= most_entries) {
            return *value;
        }
        if (!has_ended(word, what)) {
            report(word, fmt::format("{} is {}", what, quote(word.text)),
                   fmt::format("an integer from 0 to {}", most_entries));
        }
        return 0;
    }
    /// A number that must be within a range.
    double number_in(const Word& word, const char* what, double low, double high, const char* allowed) {
        const double value = number(word, what);
        if (!(value >= low && value <= high)) {
            report(word, fmt::format("{} is {}", what, quote(word.text)), allowed);
        }
        return value;
    }
    void report(const Word& word, std::string message, std::string allowed = {}) {
        problems_.add(SourcePlace{file_, word.line, word.column}, std::move(message), std::move(allowed));
    }
    bool has_problems() const { return !problems_.is_empty(); }

    /// The numbers of an element's text, as many as asked for.
    template <std::size_t N>
    std::array<double, N> list(const MarkupElement& element) {
        std::array<double, N> values{};
        if (element.words.size() != N) {
            report({element.name, element.line, element.column},
                   fmt::format("<{}> holds {} numbers", element.name, element.words.size()), fmt::format("{}", N));
            return values;
        }
        for (std::size_t k = 0; k < N; ++k) {
            values[k] = number(element.words[k], "a coordinate or value");
        }
        return values;
    }
    /// The one number of an element's text, within a range.
    double value_in(const MarkupElement& element, double low, double high, const char* allowed) {
        const double value = list<1>(element)[0];
        if (!(value >= low && value <= high)) {
            report(element.words.empty() ? Word{element.name, element.line, element.column} : element.words[0],
                   fmt::format("<{}> is {:g}", element.name, value), allowed);
        }
        return value;
    }
    /// The value of an attribute; null, with a problem, where there is none.
    const Word* attribute(const MarkupElement& element, std::string_view key) {
        const Word* word = element.attribute(key);
        if (word == nullptr) {
            report({element.name, element.line, element.column}, fmt::format("<{}> has no {}", element.name, key));
        }
        return word;
    }
    double amount(const MarkupElement& element, std::string_view key) {
        const Word* word = attribute(element, key);
        return word == nullptr ? 0 : number_in(*word, std::string(key).c_str(), 0, HUGE_VAL, "a number of 0 or more");
    }
    std::int32_t whole(const MarkupElement& element, std::string_view key) {
        const Word* word = attribute(element, key);
        return word == nullptr ? 0 : static_cast<std::int32_t>(count(*word, std::string(key).c_str()));
    }

 private:
    /// Tells whether the text has no more words; reports that at the first one that is missing.
    bool has_ended(const Word& word, const char* what) {
        if (word.is_empty() && !is_end_told_) {
            report(word, fmt::format("the text ends before {}", what));
            is_end_told_ = true;
        }
        return word.is_empty();
    }

    const std::string& file_;
    ProblemList& problems_;
    bool is_end_told_{false};
};

/// Notes an element that says nothing to Riprap.
inline void note_unused(std::vector<std::string>& notes, const MarkupElement& element) {
    notes.push_back(fmt::format("line {}: <{}> is not used", element.line, element.name));
}

}  // namespace riprap::geometry::dda_text
