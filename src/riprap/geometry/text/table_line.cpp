// SPDX-License-Identifier: Apache-2.0
#include "riprap/geometry/text/table_line.hpp"

#include <algorithm>
#include <cmath>

#include "riprap/geometry/text/text_reader.hpp"

namespace riprap::geometry {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

/// Follows the quotes of a line: one opens where a cell may begin, so that x ["] is a unit and no quote.
class Quotes {
 public:
    /// Takes the next character. @returns whether it stands in quotes; the last quote does not
    bool hold(char c) {
        const bool may_open = is_blank(before_) || before_ == ',' || before_ == ';' || before_ == '"';
        if (c == '"' && (is_inside_ || may_open)) {
            is_inside_ = !is_inside_;
        }
        before_ = c;
        return is_inside_;
    }

 private:
    char before_{','};
    bool is_inside_{false};
};

/// Marks that separate the cells of one line.
struct Separators {
    bool has_semicolon{false}, has_comma{false}, has_tab{false};
    bool has_blank_between{false};  ///< blanks with no other separator beside them stand between two cells
    bool has_comma_inside{false};   ///< a comma with no blank beside it
};

Separators look_at(std::string_view line) {
    Separators found;
    Quotes quotes;
    char before = ',';  // of the last character that is no blank
    bool after_blank = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quotes.hold(c)) {
            before = c;
            after_blank = false;
            continue;
        }
        found.has_semicolon = found.has_semicolon || c == ';';
        found.has_tab = found.has_tab || c == '\t';
        if (c == ',') {
            found.has_comma = true;
            const bool before_blank = i + 1 == line.size() || is_blank(line[i + 1]);
            found.has_comma_inside = found.has_comma_inside || (!after_blank && !before_blank && i > 0);
        }
        if (is_blank(c)) {
            after_blank = true;
            continue;
        }
        const bool is_mark = c == ',' || c == ';';
        found.has_blank_between =
            found.has_blank_between || (after_blank && !is_mark && before != ',' && before != ';');
        before = c;
        after_blank = false;
    }
    return found;
}

TableCell trimmed(std::string_view line, std::size_t begin, std::size_t end, bool may_have_decimal_comma) {
    while (begin < end && is_blank(line[begin])) {
        ++begin;
    }
    while (end > begin && is_blank(line[end - 1])) {
        --end;
    }
    const bool is_quoted = end - begin >= 2 && line[begin] == '"' && line[end - 1] == '"';
    const std::size_t quote = is_quoted ? 1 : 0;
    return {line.substr(begin + quote, end - begin - 2 * quote), static_cast<std::uint32_t>(begin + quote + 1),
            may_have_decimal_comma || is_quoted};
}

/// Splits at every mark that `is_mark` knows, outside quotes.
template <class IsMark>
void split_at(std::string_view line, bool may_have_decimal_comma, IsMark is_mark, std::vector<TableCell>& cells) {
    std::size_t begin = 0;
    Quotes quotes;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        if (i == line.size() || (!quotes.hold(line[i]) && is_mark(line[i]))) {
            cells.push_back(trimmed(line, begin, i, may_have_decimal_comma));
            begin = i + 1;
        }
    }
}

/// Joins "x" and "[mm]" of a heading between blanks.
void join_units(std::string_view line, std::vector<TableCell>& cells) {
    std::vector<TableCell> joined;
    for (const TableCell& cell : cells) {
        if (!joined.empty() && !cell.text.empty() && (cell.text.front() == '[' || cell.text.front() == '(')) {
            const std::size_t begin = joined.back().column - 1;
            joined.back().text = line.substr(begin, cell.column - 1 + cell.text.size() - begin);
        } else {
            joined.push_back(cell);
        }
    }
    cells = std::move(joined);
}

std::string_view without_comment(std::string_view line) {
    Quotes quotes;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (!quotes.hold(line[i]) && line[i] == '#') {
            return line.substr(0, i);
        }
    }
    return line;
}

}  // namespace

LineReader::LineReader(std::string_view text) : rest_(text) {
    if (rest_.starts_with("\xEF\xBB\xBF")) {
        rest_.remove_prefix(3);
    }
}

std::optional<std::string_view> LineReader::next() {
    if (rest_.empty()) {
        return std::nullopt;
    }
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    const bool is_crlf = end + 1 < rest_.size() && rest_[end] == '\r' && rest_[end + 1] == '\n';
    rest_.remove_prefix(std::min(end + (is_crlf ? 2U : 1U), rest_.size()));
    ++number_;
    return line;
}

bool is_heading(std::string_view line) {
    std::vector<TableCell> cells;
    split_table_line(line, cells);
    const auto first =
        std::find_if(cells.begin(), cells.end(), [](const TableCell& cell) { return !cell.text.empty(); });
    if (first == cells.end() || parse_number(first->text)) {  // "nan" and "inf" are numbers, if none that is taken
        return false;
    }
    const auto c = static_cast<unsigned char>(first->text.front());
    return c >= 0x80 || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '[' || c == '(';
}

void split_table_line(std::string_view whole, std::vector<TableCell>& cells) {
    cells.clear();
    const std::string_view line = without_comment(whole);
    if (line.find_first_not_of(" \t\v\f") == std::string_view::npos) {
        return;
    }
    const Separators found = look_at(line);
    const std::size_t first = line.find_first_not_of(" \t\v\f\"");
    const auto begin = static_cast<unsigned char>(first == std::string_view::npos ? ' ' : line[first]);
    const bool is_text = begin >= 'A' && begin != '[' && begin != '\\';
    if (found.has_semicolon) {
        split_at(
            line, true, [](char c) { return c == ';'; }, cells);
    } else if (found.has_comma && (!found.has_blank_between || is_text)) {
        split_at(
            line, false, [](char c) { return c == ','; }, cells);
    } else if (found.has_tab && is_text) {
        split_at(
            line, true, [](char c) { return c == '\t'; }, cells);
    } else {
        // Commas beside blanks separate like these; a comma with digits on both sides is left in its cell.
        const bool is_inside = found.has_comma_inside;
        split_at(
            line, true, [is_inside](char c) { return is_blank(c) || (c == ',' && !is_inside); }, cells);
        std::erase_if(cells, [](const TableCell& cell) { return cell.text.empty(); });
        if (is_text) {
            join_units(line, cells);
        }
    }
    while (!cells.empty() && cells.back().text.empty()) {
        cells.pop_back();
    }
}

}  // namespace riprap::geometry
