// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/text/text_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace riprap::geometry {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

void ProblemList::add(SourcePlace place, std::string message, std::string allowed) {
    ++count_;
    if (problems_.size() < cap) {
        problems_.push_back({std::move(place), std::move(message), std::move(allowed)});
    }
}

void ProblemList::add(const std::string& file, std::string message, std::string allowed) {
    SourcePlace place;
    place.file = file;
    add(std::move(place), std::move(message), std::move(allowed));
}

std::vector<Diagnostic> ProblemList::take() const {
    std::vector<Diagnostic> list = problems_;
    if (count_ > problems_.size()) {
        Diagnostic rest;
        rest.place.file = list.front().place.file;
        rest.message = fmt::format("{} more problems not listed", count_ - cap);
        list.push_back(std::move(rest));
    }
    return list;
}

void ProblemList::throw_if_any() const {
    if (!is_empty()) {
        throw CaseError(take());
    }
}

void refuse(const std::string& file, std::string message, std::string allowed) {
    Diagnostic problem;
    problem.place.file = file;
    problem.message = std::move(message);
    problem.allowed = std::move(allowed);
    throw CaseError(std::move(problem));
}

void TextReader::skip_blanks() {
    while (position_ < text_.size() && is_blank(text_[position_])) {
        ++position_;
    }
}

Word TextReader::here() const { return {{}, line_, static_cast<std::uint32_t>(position_ - line_begin_ + 1)}; }

Word TextReader::take_word() {
    Word word = here();
    const std::size_t begin = position_;
    while (position_ < text_.size() && !is_blank(text_[position_]) && text_[position_] != '\n') {
        ++position_;
    }
    word.text = text_.substr(begin, position_ - begin);
    return word;
}

Word TextReader::next_word_on_line() {
    skip_blanks();
    return take_word();
}

Word TextReader::next_word() {
    skip_blanks();
    while (position_ < text_.size() && text_[position_] == '\n') {
        next_line();
        skip_blanks();
    }
    return take_word();
}

Word TextReader::rest_of_line() {
    skip_blanks();
    Word rest = here();
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    rest.text = text_.substr(position_, end - position_);
    position_ = end;
    while (!rest.text.empty() && is_blank(rest.text.back())) {
        rest.text.remove_suffix(1);
    }
    return rest;
}

bool TextReader::next_line() {
    const std::size_t end = text_.find('\n', position_);
    if (end == std::string_view::npos) {
        position_ = text_.size();
        return false;
    }
    position_ = end + 1;
    line_begin_ = position_;
    ++line_;
    return position_ < text_.size();
}

Word TextReader::peek_word() const {
    TextReader copy = *this;
    return copy.next_word();
}

std::optional<double> parse_number(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') {
        word.remove_prefix(1);
    }
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) {
        return std::nullopt;
    }
    return value;
}

std::optional<std::int64_t> parse_integer(std::string_view word) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) {
        return std::nullopt;
    }
    return value;
}

bool is_same_keyword(std::string_view word, std::string_view keyword) {
    return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                      [](char a, char b) { return lower(a) == lower(b); });
}

std::string quote(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string text = "\"";
    for (const char c : word.substr(0, longest)) {
        if (c >= ' ' && c <= '~' && c != '"' && c != '\\') {
            text += c;
        } else {
            text += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        }
    }
    return text + (word.size() > longest ? "...\"" : "\"");
}

}  // namespace riprap::geometry
