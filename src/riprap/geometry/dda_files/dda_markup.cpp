// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/dda_files/dda_markup.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace riprap::geometry {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Walks through the text and keeps the position.
class Walker {
 public:
    Walker(std::string_view text, const std::string& file, ProblemList& problems)
        : text_(text), file_(file), problems_(problems) {
        elements_.emplace_back();
        elements_.back().name = "";
        elements_.back().line = elements_.back().column = 1;
        open_.push_back(0);
    }

    std::vector<MarkupElement> walk() {
        while (position_ < text_.size()) {
            if (text_[position_] == '<') {
                tag();
            } else if (text_[position_] == ';') {
                elements_[open_.back()].marks.push_back(elements_[open_.back()].words.size());
                advance(1);
            } else if (is_space(text_[position_])) {
                advance(1);
            } else {
                elements_[open_.back()].words.push_back(word(" \t\r\n<;"));
            }
        }
        while (open_.size() > 1) {
            const MarkupElement& element = elements_[open_.back()];
            report(element.line, element.column, fmt::format("<{}> is not closed", element.name));
            open_.pop_back();
        }
        return std::move(elements_);
    }

 private:
    void advance(std::size_t count) {
        for (std::size_t k = 0; k < count && position_ < text_.size(); ++k, ++position_) {
            if (text_[position_] == '\n') {
                ++line_;
                line_begin_ = position_ + 1;
            }
        }
    }
    std::uint32_t column() const { return static_cast<std::uint32_t>(position_ - line_begin_ + 1); }
    void report(std::uint32_t line, std::uint32_t column, std::string message) {
        problems_.add(SourcePlace{file_, line, column}, std::move(message), "");
    }
    /// The characters up to one of `ends`.
    Word word(std::string_view ends) {
        const std::size_t end = std::min(text_.find_first_of(ends, position_), text_.size());
        const Word found{text_.substr(position_, end - position_), line_, column()};
        advance(end - position_);
        return found;
    }
    void skip_past(std::string_view end, const char* what) {
        const std::size_t found = text_.find(end, position_);
        if (found == std::string_view::npos) {
            report(line_, column(), fmt::format("{} is not closed", what));
            position_ = text_.size();
        } else {
            advance(found + end.size() - position_);
        }
    }
    void skip_spaces() {
        while (position_ < text_.size() && is_space(text_[position_])) {
            advance(1);
        }
    }
    static std::string_view without_prefix(std::string_view name) {
        const std::size_t colon = name.find(':');
        return colon == std::string_view::npos ? name : name.substr(colon + 1);
    }

    void tag() {
        const std::string_view rest = text_.substr(position_);
        if (rest.substr(0, 4) == "<!--") {
            skip_past("-->", "a comment");
        } else if (rest.substr(0, 2) == "<?" || rest.substr(0, 2) == "<!") {
            skip_past(">", "a declaration");
        } else if (rest.substr(0, 2) == "</") {
            const std::uint32_t at_column = column();
            advance(2);
            const Word name = word(" \t\r\n>");
            if (open_.size() == 1 || elements_[open_.back()].name != without_prefix(name.text)) {
                report(name.line, at_column, fmt::format("</{}> closes nothing", name.text));
            } else {
                open_.pop_back();
            }
            skip_past(">", "a tag");
        } else {
            begin_element();
        }
    }

    void begin_element() {
        MarkupElement element;
        element.line = line_;
        element.column = column();
        advance(1);
        element.name = without_prefix(word(" \t\r\n/>").text);
        bool is_empty = false;
        for (skip_spaces(); position_ < text_.size() && text_[position_] != '>'; skip_spaces()) {
            if (text_[position_] == '/') {
                is_empty = true;
                advance(1);
                continue;
            }
            const Word key = word(" \t\r\n=/>");
            skip_spaces();
            if (position_ >= text_.size() || text_[position_] != '=') {
                report(key.line, key.column, fmt::format("attribute {} has no value", quote(key.text)));
                if (key.text.empty()) {
                    advance(1);
                }
                continue;
            }
            advance(1);
            skip_spaces();
            const char mark = position_ < text_.size() ? text_[position_] : ' ';
            if (mark != '"' && mark != '\'') {
                report(line_, column(), fmt::format("the value of {} is not in quotes", quote(key.text)));
                continue;
            }
            advance(1);
            element.attributes.emplace_back(without_prefix(key.text), word(std::string_view(&mark, 1)));
            advance(1);
        }
        advance(1);
        elements_[open_.back()].children.push_back(elements_.size());
        elements_.push_back(std::move(element));
        if (!is_empty) {
            open_.push_back(elements_.size() - 1);
        }
    }

    std::string_view text_;
    const std::string& file_;
    ProblemList& problems_;
    std::size_t position_{0}, line_begin_{0};
    std::uint32_t line_{1};
    std::vector<MarkupElement> elements_;
    std::vector<std::size_t> open_;
};

}  // namespace

const Word* MarkupElement::attribute(std::string_view key) const {
    for (const auto& [name_of, value] : attributes) {
        if (name_of == key) {
            return &value;
        }
    }
    return nullptr;
}

std::vector<MarkupElement> read_markup(std::string_view text, const std::string& file, ProblemList& problems) {
    return Walker(text, file, problems).walk();
}

}  // namespace riprap::geometry
