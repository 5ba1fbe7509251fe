// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/core/error.hpp"

namespace riprap::geometry {

/// The problems found while one input is read or audited: all of them up to a cap, then only their number, so that
/// a hostile file cannot make the list itself a burden.
class ProblemList {
 public:
    static constexpr std::size_t cap = 50;

    void add(SourcePlace place, std::string message, std::string allowed = {});
    /// A problem of the file as a whole.
    void add(const std::string& file, std::string message, std::string allowed);
    bool is_empty() const { return count_ == 0; }
    std::size_t count() const { return count_; }
    /// Returns the problems found; when there are more than `cap`, a last entry says how many are not listed.
    std::vector<Diagnostic> take() const;
    /// @throws CaseError with everything found, if anything was.
    void throw_if_any() const;

 private:
    std::vector<Diagnostic> problems_;
    std::size_t count_{0};
};

/// Refuses an input for one reason. @throws CaseError
[[noreturn]] void refuse(const std::string& file, std::string message, std::string allowed);

/// One word of a text and where it begins (line and column from 1).
struct Word {
    std::string_view text;
    std::uint32_t line{0};
    std::uint32_t column{0};

    bool is_empty() const { return text.empty(); }
};

/// Splits a text in memory into blank-separated words and keeps the position. Knows nothing of any format and never
/// copies; the text must outlive the words.
class TextReader {
 public:
    explicit TextReader(std::string_view text) : text_(text) {}

    /// The next word, on this line or a later one; empty at the end of the text.
    Word next_word();
    /// The next word on the current line; empty at its end.
    Word next_word_on_line();
    /// Returns the rest of the current line, without blanks at either end.
    Word rest_of_line();
    /// Goes to the next line; false at the end of the text.
    bool next_line();
    /// The word that next_word() would return, left in place.
    Word peek_word() const;
    bool is_at_end() const { return position_ >= text_.size(); }
    /// Where the reader stands.
    Word here() const;

 private:
    void skip_blanks();
    Word take_word();

    std::string_view text_;
    std::size_t position_{0};
    std::size_t line_begin_{0};
    std::uint32_t line_{1};
};

/// A number in C notation, whatever the locale; a leading `+` is allowed; the whole word must be the number. Not-a-
/// number and infinity are returned as such; empty when the word is no number or its size does not fit a double.
std::optional<double> parse_number(std::string_view word);

/// An integer in decimal notation that fills the whole word.
std::optional<std::int64_t> parse_integer(std::string_view word);

/// True if two words are equal when case is ignored (ASCII letters only).
bool is_same_keyword(std::string_view word, std::string_view keyword);

/// A word of the input for a message: in quotes, cut to 40 characters, unprintable bytes as \xNN.
std::string quote(std::string_view word);

}  // namespace riprap::geometry
