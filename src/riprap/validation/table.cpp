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

using Widths = std::array<std::size_t, column_count>;

/// The lines of one kind; the name of a case is printed once.
std::string lines_of(Kind kind, const std::vector<Result>& results, const Widths& widths) {
    std::string text, last;
    for (const Result& result : results) {
        if (result.kind != kind) {
            continue;
        }
        Row row = row_of(result);
        if (result.name == last) {
            row[0].clear();
        }
        last = result.name;
        text += line_of(row, widths);
        if (result.verdict != Verdict::reproduced && !result.note.empty()) {
            text += fmt::format("    {}\n", result.note);
        }
    }
    return text;
}

/// "zhao, physics: 12 reproduced, 1 close, 0 not reproduced, 2 under-specified"; nothing where there is no such line.
std::string counts_of(std::string_view suite, Kind kind, const std::vector<Result>& results) {
    std::array<int, 4> counts{};
    int sum = 0;
    for (const Result& result : results) {
        if (result.kind == kind) {
            ++counts[static_cast<std::size_t>(result.verdict)];
            ++sum;
        }
    }
    return sum == 0 ? ""
                    : fmt::format("{}, {}: {} reproduced, {} close, {} not reproduced, {} under-specified\n", suite,
                                  to_string(kind), counts[0], counts[1], counts[2], counts[3]);
}

}  // namespace

std::string to_table(std::string_view suite, const std::vector<Result>& results) {
    const Row head{"case", "quantity", "paper", "exact", "ours", "accepted", "verdict"};
    Widths widths{};
    const auto make_room = [&widths](const Row& row) {
        for (std::size_t i = 0; i < column_count; ++i) {
            widths[i] = std::max(widths[i], width(row[i]));
        }
    };
    make_room(head);
    for (const Result& result : results) {
        make_room(row_of(result));
    }
    const std::string accounts = lines_of(Kind::bookkeeping, results, widths);
    return fmt::format("suite {}\n", suite) + line_of(head, widths) + lines_of(Kind::physics, results, widths) +
           (accounts.empty() ? "" : fmt::format("bookkeeping of {}\n", suite)) + accounts +
           counts_of(suite, Kind::physics, results) + counts_of(suite, Kind::bookkeeping, results);
}

}  // namespace riprap::validation
