// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/csv.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <utility>

#include "riprap/io/continued_file.hpp"
#include "riprap/io/own_file.hpp"

namespace riprap::io {

namespace {

constexpr std::size_t flush_bytes = std::size_t{1} << 16;

std::string heading_line(std::span<const CsvColumn> columns) { return csv_heading(columns) + '\n'; }

}  // namespace

std::string csv_heading(std::span<const CsvColumn> columns) {
    std::string line;
    for (const CsvColumn& column : columns) {
        if (!line.empty()) {
            line += ',';
        }
        line += csv_text(column.name + " [" + column.unit + "]");
    }
    return line;
}

std::string csv_text(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) {
        return text;
    }
    std::string out = "\"";
    for (const char c : text) {
        out += c;
        if (c == '"') {
            out += c;
        }
    }
    return out + '"';
}

std::string csv_row(std::span<const double> values) {
    std::string line;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) {
            line += ',';
        }
        if (!std::isnan(values[i])) {
            line += fmt::format("{}", values[i]);
        }
    }
    return line;
}

bool has_heading(const std::filesystem::path& path, std::span<const CsvColumn> columns) {
    const std::string heading = heading_line(columns);
    std::string begin(heading.size(), '\0');
    std::ifstream file(path, std::ios::binary);
    return file.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == heading;
}

void require_table(const std::filesystem::path& path, std::span<const CsvColumn> columns, std::uint64_t bytes) {
    const auto refuse = [&path](const std::string& why) {
        throw FileError("'" + path.string() + "' is damaged: " + why +
                        "; put the file back or start again with --force");
    };
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        refuse(std::filesystem::exists(std::filesystem::symlink_status(path, error)) ? "it is no regular file"
                                                                                     : "it is missing");
    }
    if (const std::uintmax_t size = std::filesystem::file_size(path, error); error || size < bytes) {
        refuse("it has " + std::to_string(error ? 0 : size) + " bytes, fewer than the " + std::to_string(bytes) +
               " when the checkpoint was written");
    }
    if (!has_heading(path, columns)) {
        refuse("its columns are not those of this case");
    }
}

GrowingCsv::GrowingCsv(std::filesystem::path path, std::span<const CsvColumn> columns)
    : path_(std::move(path)), file_(create_own(path_)) {
    buffer_ = heading_line(columns);
    flush(false);
}

namespace {

FileDescriptor open_to_continue(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::file_type type = std::filesystem::symlink_status(path, error).type();
    if (type != std::filesystem::file_type::regular && type != std::filesystem::file_type::symlink) {
        const bool is_missing = type == std::filesystem::file_type::not_found;
        throw FileError("cannot continue '" + path.string() +
                        (is_missing ? "': it is missing" : "': it is not a regular file") +
                        "; put the file back or start again with --force");
    }
    return open_own(path, O_RDWR);
}

}  // namespace

GrowingCsv::GrowingCsv(std::filesystem::path path, std::span<const CsvColumn> columns, std::uint64_t bytes)
    : path_(std::move(path)), file_(open_to_continue(path_)), written_(bytes) {
    struct stat status {};
    if (::fstat(file_.number(), &status) != 0) {
        throw file_error("continue", path_, errno);
    }
    const std::string heading = heading_line(columns);
    if (static_cast<std::uint64_t>(status.st_size) < bytes || bytes < heading.size()) {
        throw FileError("cannot continue '" + path_.string() + "': it has " + std::to_string(status.st_size) +
                        " bytes, fewer than the " + std::to_string(bytes) +
                        " when the checkpoint was written; put the file back or start again with --force");
    }
    std::string begin(heading.size(), '\0');
    if (::pread(file_.number(), begin.data(), begin.size(), 0) != static_cast<ssize_t>(begin.size()) ||
        begin != heading) {
        throw FileError("cannot continue '" + path_.string() +
                        "': its columns are not those of this case; start again with --force");
    }
    if (::ftruncate(file_.number(), static_cast<off_t>(bytes)) != 0 ||
        ::lseek(file_.number(), static_cast<off_t>(bytes), SEEK_SET) < 0) {
        throw file_error("cut back", path_, errno);
    }
}

void GrowingCsv::add_row(std::span<const double> values) {
    buffer_ += csv_row(values);
    buffer_ += '\n';
    if (buffer_.size() >= flush_bytes) {
        flush(false);
    }
}

void GrowingCsv::require_in_place() const {
    struct stat status {};
    if (::fstat(file_.number(), &status) != 0) {
        throw file_error("write", path_, errno);
    }
    if (!is_in_place(file_, path_)) {
        throw FileError("cannot write '" + path_.string() +
                        "' any more: it was removed or replaced while the run wrote it; put it back and continue with "
                        "`riprap resume`, or start again with --force");
    }
    if (static_cast<std::uint64_t>(status.st_size) != written_) {
        throw FileError("cannot write '" + path_.string() + "' any more: another program changed it, it has " +
                        std::to_string(status.st_size) + " bytes where the run wrote " + std::to_string(written_) +
                        "; put its rows back and continue with `riprap resume`, or start again with --force");
    }
}

void GrowingCsv::flush(bool to_disk) {
    require_in_place();
    if (!buffer_.empty()) {
        write_all(file_, buffer_.data(), buffer_.size(), path_);
        written_ += buffer_.size();
        buffer_.clear();
    }
    if (to_disk) {
        flush_to_disk(file_, path_);
        require_in_place();  // the last look of a run
    }
}

}  // namespace riprap::io
