// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/upgrade.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "riprap/scene/text/toml_reader.hpp"

namespace riprap::scene {

namespace {

/// First byte of the line with that number, from 1.
std::size_t begin_of_line(std::string_view text, std::uint32_t line) {
    std::size_t at = 0;
    for (std::uint32_t i = 1; i < line && at < text.size(); ++i) {
        at = std::min(text.find('\n', at), text.size() - 1) + 1;
    }
    return at;
}

/// First byte of a column, which counts characters of UTF-8 from 1.
std::size_t byte_of(std::string_view text, const SourcePlace& place) {
    std::size_t at = begin_of_line(text, place.line);
    const auto is_inside = [&text](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U; };
    for (std::uint32_t i = 1; i < place.column && at < text.size(); ++i) {
        do {
            ++at;
        } while (at < text.size() && is_inside(at));
    }
    return at;
}

/// Where the old name begins in the text, behind a quotation mark if it has one; nothing where it is not written out.
std::optional<std::size_t> find_written(std::string_view text, const OldName& old) {
    const std::size_t place = byte_of(text, old.place);
    const bool is_quoted = place < text.size() && (text[place] == '"' || text[place] == '\'');
    const std::size_t begin = place + (is_quoted ? 1 : 0);
    if (text.substr(std::min(begin, text.size()), old.before.size()) != old.before) {
        return std::nullopt;
    }
    return begin;
}

}  // namespace

UpgradedCase upgrade_case_text(std::string_view text, const std::string& name, const Table& table,
                               std::span<const Renamed> rows) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    const std::string_view mark = text.substr(0, text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
    const std::string_view plain = text.substr(mark.size());
    std::vector<Diagnostic> problems;
    Value root = parse_toml(plain, name, problems);
    check_format(root, problems);
    if (!problems.empty()) {
        throw CaseError(std::move(problems));
    }
    UpgradedCase upgraded{"", rename_old(root, table, rows)};
    std::size_t done = 0;
    for (const OldName& old : upgraded.renamed) {
        const std::optional<std::size_t> at = find_written(plain, old);
        if (old.now.empty()) {
            problems.push_back(problem_of(old));
        } else if (!at || *at < done) {
            problems.push_back({old.place, fmt::format("'{}' is not written here letter by letter", old.before),
                                fmt::format("write '{}' in its place", old.now)});
        } else {
            upgraded.text += fmt::format("{}{}", plain.substr(done, *at - done), old.now);
            done = *at + old.before.size();
        }
    }
    if (!problems.empty()) {
        throw CaseError(std::move(problems));
    }
    upgraded.text = fmt::format("{}{}{}", mark, upgraded.text, plain.substr(done));
    return upgraded;
}

}  // namespace riprap::scene
