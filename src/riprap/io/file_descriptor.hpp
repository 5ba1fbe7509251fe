// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "riprap/core/error.hpp"

namespace riprap::io {

/// FileError for a failed call: what was being done to which file, the system's reason, and a remedy.
FileError file_error(std::string_view action, const std::filesystem::path& path, int error_number);

/// A POSIX file descriptor that closes itself.
class FileDescriptor {
 public:
    FileDescriptor() = default;
    explicit FileDescriptor(int number) : number_(number) {}
    FileDescriptor(FileDescriptor&& other) noexcept : number_(other.release()) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept;
    ~FileDescriptor() { close(); }
    int number() const { return number_; }
    bool is_open() const { return number_ >= 0; }
    int release();
    void close();

 private:
    int number_{-1};
};

/// Writes all bytes. @throws FileError naming `path`.
void write_all(const FileDescriptor& file, const void* data, std::size_t bytes, const std::filesystem::path& path);

/// Flushes a file to the disk. @throws FileError naming `path`.
void flush_to_disk(const FileDescriptor& file, const std::filesystem::path& path);

/// Flushes the entries of a folder to the disk, so that a rename or a new file in it survives a power cut.
void flush_folder(const std::filesystem::path& folder);

}  // namespace riprap::io
