// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/io/atomic_file.hpp"

namespace riprap::io {

/// One column of a CSV file; the heading is `name [unit]`.
struct CsvColumn {
    std::string name;
    std::string unit;
};

/// `name [unit],name [unit]...`; names with commas or quotes are quoted.
std::string csv_heading(std::span<const CsvColumn> columns);

/// A text as a field: quoted where it must be.
std::string csv_text(const std::string& text);

/// Numbers with the fewest digits that read back as the same double; a missing value (NaN) as an empty field.
std::string csv_row(std::span<const double> values);

/// Tells whether a file begins with the heading of these columns.
bool has_heading(const std::filesystem::path& path, std::span<const CsvColumn> columns);

/// Looks at a table that a run has left, without opening it to write. @param bytes  what its checkpoint knows of it
/// @throws FileError when the file is missing, shorter, or starts with another heading
void require_table(const std::filesystem::path& path, std::span<const CsvColumn> columns, std::uint64_t bytes);

/// A CSV file that grows while a run goes on. Rows reach the system at `flush`; after a crash the file may be longer
/// than the last checkpoint knows, so a resumed run cuts it back to the length that its checkpoint recorded.
class GrowingCsv {
 public:
    GrowingCsv() = default;
    /// Starts a new file with a heading, replacing what was there. @throws FileError
    GrowingCsv(std::filesystem::path path, std::span<const CsvColumn> columns);
    /// Continues a file from its first `bytes` bytes.
    /// @throws FileError when the file is missing, shorter, or starts with another heading
    GrowingCsv(std::filesystem::path path, std::span<const CsvColumn> columns, std::uint64_t bytes);

    void add_row(std::span<const double> values);
    /// Hands all rows to the system and, with `to_disk`, to the disk.
    /// @throws FileError also where the file was removed or another put in its place: its rows would be lost
    void flush(bool to_disk);
    /// Length with all rows so far.
    std::uint64_t bytes() const { return written_ + buffer_.size(); }

 private:
    void require_in_place() const;

    std::filesystem::path path_;
    FileDescriptor file_;
    std::string buffer_;
    std::uint64_t written_{0};
};

}  // namespace riprap::io
