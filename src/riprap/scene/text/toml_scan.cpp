// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/text/toml_scan.hpp"

#include <fmt/format.h>

#include "riprap/scene/text/limits.hpp"

namespace riprap::scene {

int utf8_length(std::string_view text) {
    const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) {
        return 1;
    }
    const int length = first >= 0xC2 && first <= 0xDF   ? 2
                       : (first & 0xF0) == 0xE0         ? 3
                       : first >= 0xF0 && first <= 0xF4 ? 4
                                                        : 0;
    if (length == 0 || text.size() < static_cast<std::size_t>(length)) {
        return 0;
    }
    for (int i = 1; i < length; ++i) {
        if ((byte(static_cast<std::size_t>(i)) & 0xC0U) != 0x80U) {
            return 0;
        }
    }
    const unsigned char second = byte(1);
    const bool is_overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
    const bool is_surrogate = first == 0xED && second >= 0xA0;
    const bool is_beyond = first == 0xF4 && second >= 0x90;
    return is_overlong || is_surrogate || is_beyond ? 0 : length;
}

namespace {

/// Walks the text once, knowing only comments and the four kinds of strings.
class Scanner {
 public:
    explicit Scanner(std::string_view text) : text_(text) {}

    /// Empty when the text may be parsed.
    std::string find_problem() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            std::string problem;
            if (c == '#') {
                problem = skip_comment();
            } else if (c == '"' || c == '\'') {
                problem = skip_string(c);
            } else {
                problem = take_plain(c);
            }
            if (!problem.empty()) {
                return problem;
            }
        }
        return "";
    }
    std::uint32_t line() const { return line_; }
    std::uint32_t column() const { return column_; }

 private:
    /// Steps over one character of a string or comment.
    std::string step() {
        const auto byte = static_cast<unsigned char>(text_[at_]);
        const int length = utf8_length(text_.substr(at_));
        if (length == 0) {
            return fmt::format("byte 0x{:02x} is not valid UTF-8", byte);
        }
        if ((byte < 0x20 && byte != '\n' && byte != '\t' && byte != '\r') || byte == 0x7F) {
            return fmt::format("control character 0x{:02x}", byte);
        }
        at_ += static_cast<std::size_t>(length);
        ++column_;
        if (byte == '\n') {
            ++line_;
            column_ = 1;
        }
        return "";
    }

    std::string skip_comment() {
        while (at_ < text_.size() && text_[at_] != '\n') {
            if (std::string problem = step(); !problem.empty()) {
                return problem;
            }
        }
        return "";
    }

    std::string skip_string(char quote) {
        const std::string three(3, quote);
        const bool is_long = text_.substr(at_, 3) == three;
        for (int i = is_long ? 3 : 1; i > 0; --i) {
            step();
        }
        while (at_ < text_.size()) {
            if (is_long ? text_.substr(at_, 3) == three : text_[at_] == quote) {
                for (int i = is_long ? 3 : 1; i > 0; --i) {
                    step();
                }
                return "";
            }
            if (!is_long && text_[at_] == '\n') {
                return "";  // the parser reports the open string better
            }
            if (quote == '"' && text_[at_] == '\\' && at_ + 1 < text_.size()) {
                step();
            }
            if (std::string problem = step(); !problem.empty()) {
                return problem;
            }
        }
        return "";
    }

    std::string take_plain(char c) {
        if (static_cast<unsigned char>(c) >= 0x80) {
            if (utf8_length(text_.substr(at_)) > 0) {
                return "a character outside ASCII in a key or a bare value; put it in quotes";
            }
            return step();
        }
        if (c == '[' || c == '{') {
            if (++depth_ > limits::nesting) {
                return fmt::format("brackets nested more than {} deep", limits::nesting);
            }
        } else if (c == ']' || c == '}') {
            depth_ = depth_ > 0 ? depth_ - 1 : 0;
        }
        if (c == '.') {
            if (++dots_ > limits::key_segments) {
                return fmt::format("a key of more than {} dotted parts", limits::key_segments);
            }
        } else if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) {
            dots_ = 0;
        }
        return step();
    }

    std::string_view text_;
    std::size_t at_{0};
    std::uint32_t line_{1}, column_{1};
    int depth_{0}, dots_{0};
};

}  // namespace

void scan_toml(std::string_view text, const std::string& name, std::vector<Diagnostic>& problems) {
    if (text.size() > limits::case_bytes) {
        const SourcePlace place{name, 0, 0};
        problems.push_back({place, fmt::format("the case file has {} bytes", text.size()),
                            fmt::format("at most {} are accepted; put long lists in a file", limits::case_bytes)});
        return;
    }
    Scanner scanner(text);
    const std::string problem = scanner.find_problem();
    if (!problem.empty()) {
        const SourcePlace place{name, scanner.line(), scanner.column()};
        problems.push_back({place, problem, "a case file is TOML 1.0 in UTF-8"});
    }
}

}  // namespace riprap::scene
