// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/markdown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace riprap::view {

namespace {

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
    return begin == std::string_view::npos ? std::string_view() : text.substr(begin, end - begin + 1);
}

std::string element(std::string_view tag, const std::string& content) {
    return fmt::format("<{0}>{1}</{0}>", tag, content);
}

/// Code, bold, emphasis and links of a paragraph.
std::string inline_html(std::string_view text) {
    std::string html;
    const auto between = [&text](std::size_t at, std::string_view mark) {
        const std::size_t begin = at + mark.size(), end = text.find(mark, begin);
        return end == std::string_view::npos || end == begin ? std::string_view() : text.substr(begin, end - begin);
    };
    for (std::size_t at = 0; at < text.size();) {
        const bool is_word_before = at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0;
        if (text[at] == '`' && !between(at, "`").empty()) {
            const std::string_view code = between(at, "`");
            html += element("code", escape_html(code));
            at += code.size() + 2;
        } else if (text.substr(at, 2) == "**" && !between(at, "**").empty()) {
            const std::string_view bold = between(at, "**");
            html += element("b", inline_html(bold));
            at += bold.size() + 4;
        } else if (text[at] == '*' && !is_word_before && !between(at, "*").empty() && between(at, "*")[0] != ' ') {
            const std::string_view words = between(at, "*");
            html += element("em", inline_html(words));
            at += words.size() + 2;
        } else if (text[at] == '[' && text.find("](", at) != std::string_view::npos &&
                   text.find(']', at) == text.find("](", at)) {
            const std::size_t middle = text.find("](", at), end = std::min(text.find(')', middle), text.size() - 1);
            html += inline_html(text.substr(at + 1, middle - at - 1));  // it would lead out of the report
            at = end + 1;
        } else {
            html += escape_html(text.substr(at, 1));
            ++at;
        }
    }
    return html;
}

/// Cells of a row of a table; a bar within code belongs to it.
std::string row_html(std::string_view line, std::string_view tag) {
    std::string html;
    line = trimmed(line);
    line.remove_prefix(1);
    bool is_code = false;
    std::size_t begin = 0;
    for (std::size_t at = 0; at <= line.size(); ++at) {
        if (at == line.size() || (line[at] == '|' && !is_code)) {
            const std::string_view cell = trimmed(line.substr(begin, at - begin));
            if (at < line.size() || !cell.empty()) {
                html += element(tag, inline_html(cell));
            }
            begin = at + 1;
        } else if (line[at] == '`') {
            is_code = !is_code;
        }
    }
    return element("tr", html) + '\n';
}

class Page {
 public:
    explicit Page(std::string_view text) : lines_(lines_of(text)) {}

    std::string html() {
        while (at_ < lines_.size()) {
            const std::string_view line = trimmed(lines_[at_]);
            if (line.empty()) {
                ++at_;
            } else if (line.starts_with("```")) {
                fence();
            } else if (lines_[at_].starts_with("    ")) {
                code();
            } else if (const std::size_t level = line.find_first_not_of('#');
                       level > 0 && level <= 6 && level < line.size() && line[level] == ' ') {
                html_ += element(fmt::format("h{}", std::min<std::size_t>(level + 3, 6)),
                                 inline_html(trimmed(line.substr(level)))) +
                         '\n';
                ++at_;
            } else if (line.starts_with('|')) {
                table();
            } else if (marker(line) > 0) {
                list();
            } else {
                html_ += element("p", inline_html(paragraph())) + '\n';
            }
        }
        return std::move(html_);
    }

 private:
    /// Length of "- " or "12. " at the begin of a line; 0 where there is none.
    static std::size_t marker(std::string_view line) {
        if (line.starts_with("- ") || line.starts_with("* ")) {
            return 2;
        }
        const std::size_t digits = line.find_first_not_of("0123456789");
        return digits != std::string_view::npos && digits > 0 && digits < 4 && line.substr(digits, 2) == ". "
                   ? digits + 2
                   : 0;
    }

    bool is_start(std::string_view line) const {
        const std::string_view words = trimmed(line);
        return words.empty() || words.starts_with("```") || words.starts_with("# ") || words.starts_with("## ") ||
               words.starts_with("### ") || words.starts_with('|') || marker(words) > 0;
    }

    /// Lines up to the next block, as one.
    std::string paragraph() {
        std::string text;
        do {
            text += text.empty() ? "" : " ";
            text += trimmed(lines_[at_++]);
        } while (at_ < lines_.size() && !is_start(lines_[at_]));
        return text;
    }

    void fence() {
        std::string text;
        for (++at_; at_ < lines_.size() && !trimmed(lines_[at_]).starts_with("```"); ++at_) {
            text += escape_html(lines_[at_]) + '\n';
        }
        ++at_;
        html_ += element("pre", text) + '\n';
    }

    void code() {
        std::string text;
        for (; at_ < lines_.size() && (lines_[at_].starts_with("    ") || trimmed(lines_[at_]).empty()); ++at_) {
            text += escape_html(lines_[at_].substr(std::min<std::size_t>(4, lines_[at_].size()))) + '\n';
        }
        html_ += element("pre", text) + '\n';
    }

    void table() {
        std::string rows = row_html(lines_[at_++], "th");
        for (; at_ < lines_.size() && trimmed(lines_[at_]).starts_with('|'); ++at_) {
            if (lines_[at_].find_first_not_of("|-: \t\r") != std::string_view::npos) {  // else the line below the head
                rows += row_html(lines_[at_], "td");
            }
        }
        html_ += element("table", rows) + '\n';
    }

    void list() {
        const bool is_ordered = std::isdigit(static_cast<unsigned char>(trimmed(lines_[at_])[0])) != 0;
        std::string items;
        while (at_ < lines_.size() && marker(trimmed(lines_[at_])) > 0) {
            const std::size_t mark = marker(trimmed(lines_[at_]));
            items += element("li", inline_html(paragraph().substr(mark))) + '\n';
        }
        html_ += element(is_ordered ? "ol" : "ul", items) + '\n';
    }

    std::vector<std::string_view> lines_;
    std::size_t at_{0};
    std::string html_;
};

}  // namespace

std::string escape_html(std::string_view text) {
    std::string html;
    for (const char c : text) {
        switch (c) {
            case '&':
                html += "&amp;";
                break;
            case '<':
                html += "&lt;";
                break;
            case '>':
                html += "&gt;";
                break;
            case '"':
                html += "&quot;";
                break;
            default:
                html += c;
        }
    }
    return html;
}

std::string html_of_markdown(std::string_view markdown) { return Page(markdown).html(); }

}  // namespace riprap::view
