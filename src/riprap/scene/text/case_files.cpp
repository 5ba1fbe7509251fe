// SPDX-License-Identifier: Apache-2.0
#include "riprap/scene/text/case_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "riprap/core/fields.hpp"

namespace riprap::scene {

namespace fs = std::filesystem;

namespace {

/// Returns the reason why a path is refused; empty when it stays in the folder.
std::string path_problem(const fs::path& folder, const std::string& path) {
    const fs::path relative(path);
    if (path.find('\0') != std::string::npos || path.size() > 1024) {
        return "is not a usable path";
    }
    if (relative.is_absolute() || path.find('\\') != std::string::npos) {
        return "is not a plain relative path";
    }
    if (std::find(relative.begin(), relative.end(), fs::path("..")) != relative.end()) {
        return "leaves the folder of the case";
    }
    std::error_code error;
    const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
    if (error) {
        return fmt::format("cannot be read: the folder of the case is not accessible ({})", error.message());
    }
    const fs::path real = fs::canonical(root / relative, error);
    if (error) {
        return fmt::format("cannot be read: {}", error.message());
    }
    const auto [at_root, at_real] = std::mismatch(root.begin(), root.end(), real.begin(), real.end());
    if (at_root != root.end()) {
        return "is a link that leaves the folder of the case";
    }
    return fs::is_regular_file(real, error) ? "" : "is not a regular file";
}

std::string_view next_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.empty() && line.back() == '\r') {
        line.remove_suffix(1);
    }
    return line;
}

/// Reads comma-separated numbers; a message when the line is not `columns` of them.
std::string read_row(std::string_view line, std::size_t columns, std::vector<double>& row) {
    row.clear();
    while (true) {
        const std::size_t comma = std::min(line.find(','), line.size());
        std::string_view cell = line.substr(0, comma);
        while (!cell.empty() && (cell.front() == ' ' || cell.front() == '\t' || cell.front() == '+')) {
            cell.remove_prefix(1);
        }
        while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\t')) {
            cell.remove_suffix(1);
        }
        double number = 0;
        const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
        if (code != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(number)) {
            return fmt::format("column {} is not a finite number", row.size() + 1);
        }
        row.push_back(number);
        if (comma == line.size()) {
            break;
        }
        line.remove_prefix(comma + 1);
    }
    return row.size() == columns ? "" : fmt::format("{} columns instead of {}", row.size(), columns);
}

}  // namespace

std::optional<std::string> CaseFiles::read(const std::string& path, std::size_t max_bytes, const SourcePlace& place,
                                           std::vector<Diagnostic>& problems) {
    const auto refuse = [&](const std::string& why, std::string allowed) {
        problems.push_back({place, fmt::format("file \"{}\" {}", path.substr(0, 200), why), std::move(allowed)});
        return std::nullopt;
    };
    if (const std::string why = path_problem(folder_, path); !why.empty()) {
        return refuse(why, "a file in the folder of the case, given by a path without \"..\"");
    }
    const fs::path full = folder_ / path;
    std::error_code error;
    const auto size = fs::file_size(full, error);
    if (error || size > max_bytes) {
        return error ? refuse(fmt::format("cannot be read: {}", error.message()), "")
                     : refuse(fmt::format("has {} bytes", size), fmt::format("at most {} are accepted", max_bytes));
    }
    std::ifstream stream(full, std::ios::binary);
    std::string text(static_cast<std::size_t>(size), '\0');
    stream.read(text.data(), static_cast<std::streamsize>(size));
    if (!stream) {
        return refuse("cannot be read", "check its permissions");
    }
    Hasher hasher;
    hasher.add(text.data(), text.size());
    inputs_[path] = hasher.value();
    return text;
}

std::optional<std::vector<std::vector<double>>> CaseFiles::read_table(const std::string& path, std::size_t columns,
                                                                      std::size_t max_rows, const SourcePlace& place,
                                                                      std::vector<Diagnostic>& problems) {
    const std::optional<std::string> bytes = read(path, std::size_t{64} << 20U, place, problems);
    if (!bytes) {
        return std::nullopt;
    }
    std::string_view text = *bytes;
    next_line(text);  // header
    std::vector<std::vector<double>> rows;
    std::vector<double> row;
    for (std::uint32_t line = 2; !text.empty(); ++line) {
        const std::string_view content = next_line(text);
        if (content.find_first_not_of(" \t") == std::string_view::npos) {
            continue;
        }
        if (const std::string why = read_row(content, columns, row); !why.empty()) {
            const SourcePlace at{path, line, 1};
            problems.push_back({at, why, fmt::format("a header line, then rows of {} numbers", columns)});
            return std::nullopt;
        }
        if (rows.size() >= max_rows) {
            problems.push_back({place, fmt::format("file \"{}\" has more than {} rows", path, max_rows), ""});
            return std::nullopt;
        }
        rows.push_back(row);
    }
    return rows;
}

std::vector<InputFile> CaseFiles::inputs() const {
    std::vector<InputFile> files;
    for (const auto& [path, hash] : inputs_) {
        files.push_back({path, hash});
    }
    return files;
}

}  // namespace riprap::scene
