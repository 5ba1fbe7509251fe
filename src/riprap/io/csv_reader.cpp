// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/csv_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "riprap/core/printable.hpp"

namespace riprap::io {

namespace {

constexpr std::size_t table_limit = std::size_t{1} << 30U;  // bytes

/// The fields of one line; `is_whole` is false when a quote is not closed.
std::vector<std::string> fields_of(std::string_view line, bool& is_whole) {
    std::vector<std::string> fields(1);
    bool is_quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"') {
            if (is_quoted && i + 1 < line.size() && line[i + 1] == '"') {
                fields.back() += c;
                ++i;
            } else {
                is_quoted = !is_quoted;
            }
        } else if (c == ',' && !is_quoted) {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    is_whole = !is_quoted;
    return fields;
}

CsvColumn column_of(const std::string& heading) {
    const std::size_t unit = heading.rfind(" [");
    if (unit == std::string::npos || heading.back() != ']') {
        return {heading, ""};
    }
    return {heading.substr(0, unit), heading.substr(unit + 2, heading.size() - unit - 3)};
}

/// The number of a field, NaN where it is empty; nothing where it is neither.
std::optional<double> number_of(const std::string& field) {
    if (field.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    double value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    return error == std::errc{} && end == field.data() + field.size() ? std::optional(value) : std::nullopt;
}

[[noreturn]] void refuse_field(const std::filesystem::path& path, std::size_t line, std::size_t column,
                               const std::string& field) {
    constexpr std::size_t most = 40;
    throw FileError(fmt::format("cannot read '{}': line {}, column {} is \"{}\", where a number should be",
                                path.string(), line, column + 1, printable(field.substr(0, most))));
}

}  // namespace

CsvTable read_csv(const std::filesystem::path& path, std::string_view text_column) {
    const std::string text = read_file(path, table_limit);
    CsvTable table;
    std::size_t at = text.find('\n');
    bool is_whole = false;
    for (const std::string& heading : fields_of(std::string_view(text).substr(0, at), is_whole)) {
        table.columns.push_back(column_of(heading));
    }
    if (at == std::string::npos || !is_whole || table.columns.front().name != "time") {
        throw FileError(
            fmt::format("cannot read '{}': it is no table of a run; its first line does not begin with "
                        "'time [s]'",
                        path.string()));
    }
    const auto named = std::find_if(table.columns.begin(), table.columns.end(),
                                    [&](const CsvColumn& column) { return column.name == text_column; });
    const auto text_index = static_cast<std::size_t>(named - table.columns.begin());
    table.values.resize(table.columns.size());
    std::size_t line = 2;
    for (++at; at < text.size(); ++line) {
        const std::size_t end = text.find('\n', at);
        std::vector<std::string> fields = fields_of(std::string_view(text).substr(at, end - at), is_whole);
        if (end == std::string::npos || !is_whole || fields.size() != table.columns.size()) {
            table.is_cut = true;
            table.lost_from = end == std::string::npos || end + 1 == text.size() ? 0 : line;
            break;
        }
        for (std::size_t k = 0; k < fields.size(); ++k) {
            const std::optional<double> number = number_of(fields[k]);
            if (!number && k != text_index) {
                refuse_field(path, line, k, fields[k]);
            }
            table.values[k].push_back(number.value_or(std::numeric_limits<double>::quiet_NaN()));
        }
        if (text_index < fields.size()) {
            table.texts.push_back(std::move(fields[text_index]));
        }
        at = end + 1;
    }
    return table;
}

CsvTable read_record(const std::filesystem::path& path) {
    CsvTable table = read_csv(path);
    const std::vector<double>& time = table.values.front();
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (!std::isfinite(time[i]) || (i > 0 && time[i] < time[i - 1])) {
            throw FileError(fmt::format("cannot read '{}': the time in line {} is {}, which does not follow",
                                        path.string(), i + 2, time[i]));
        }
    }
    return table;
}

}  // namespace riprap::io
