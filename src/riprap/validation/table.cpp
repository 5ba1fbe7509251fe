// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "riprap/validation/result.hpp"

namespace riprap::validation {

namespace {

constexpr std::size_t column_count = 7;
using Row = std::array<std::string, column_count>;

std::string number(std::optional<double> value) { return value ? fmt::format("{:.6g}", *value) : "-"; }

std::string published(const Published& paper) {
    if (const auto* value = std::get_if<double>(&paper)) {
        return number(*value);
    }
    const auto* words = std::get_if<std::string>(&paper);
    return words != nullptr ? *words : "-";
}

Row row_of(const Result& result) {
    const std::string quantity =
        result.unit == "-" ? result.quantity : fmt::format("{} [{}]", result.quantity, result.unit);
    const std::string band = result.low ? fmt::format("{:.6g} .. {:.6g}", *result.low, *result.high) : "-";
    std::string verdict(to_string(result.verdict));
    std::replace(verdict.begin(), verdict.end(), '_', ' ');
    return {result.name, quantity, published(result.paper), number(result.exact), number(result.value), band, verdict};
}

/// Columns of a terminal, not bytes: continuation bytes of UTF-8 take no room.
std::size_t width(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string line_of(const Row& row, const std::array<std::size_t, column_count>& widths) {
    std::string line;
    for (std::size_t i = 0; i < column_count; ++i) {
        line += row[i];
        if (i + 1 < column_count) {
            line += std::string(widths[i] - width(row[i]) + 2, ' ');
        }
    }
    return line + "\n";
}

}  // namespace

std::string to_table(std::string_view suite, const std::vector<Result>& results) {
    std::vector<Row> rows{{"case", "quantity", "paper", "exact", "ours", "accepted", "verdict"}};
    for (const Result& result : results) {
        rows.push_back(row_of(result));
        if (rows.size() > 2 && result.name == results[rows.size() - 3].name) {
            rows.back()[0].clear();  // the name of a case is printed once
        }
    }
    std::array<std::size_t, column_count> widths{};
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < column_count; ++i) {
            widths[i] = std::max(widths[i], width(row[i]));
        }
    }
    std::string text = fmt::format("suite {}\n", suite) + line_of(rows[0], widths);
    std::array<int, 4> counts{};
    for (std::size_t i = 0; i < results.size(); ++i) {
        const Result& result = results[i];
        text += line_of(rows[i + 1], widths);
        if (result.verdict != Verdict::reproduced && !result.note.empty()) {
            text += fmt::format("    {}\n", result.note);
        }
        ++counts[static_cast<std::size_t>(result.verdict)];
    }
    return text + fmt::format("{}: {} reproduced, {} close, {} not reproduced, {} under-specified\n", suite, counts[0],
                              counts[1], counts[2], counts[3]);
}

}  // namespace riprap::validation
