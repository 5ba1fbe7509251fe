// SPDX-License-Identifier: Apache-2.0
#pragma once

// The only way a whole file is written: under a temporary name in the same folder, flushed to the disk, then renamed
// over the target, then the folder flushed. Whatever happens in between - disk full, killed process, power cut - the
// target is either the old file or the whole new one, never a part.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "riprap/io/file_descriptor.hpp"

namespace riprap::io {

/// When a file is on the disk. Either way another process sees the old file or the whole new one.
enum class Durability {
    now,    ///< before the call returns: safe against a power cut
    later,  ///< when the system gets to it, or at the next flush_file_system: for files that can be written again
};

/// Flushes everything written to the file system that holds `folder`. One call for many files written with
/// Durability::later. @throws FileError also for earlier writes that failed in the background
void flush_file_system(const std::filesystem::path& folder);

/// A file that appears whole or not at all. Without `commit` the destructor removes the temporary file.
class AtomicFile {
 public:
    /// Opens `.<name>.partial` beside the target. @throws FileError
    explicit AtomicFile(std::filesystem::path target);
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile();

    /// @throws FileError; the target is then untouched.
    void write(const void* data, std::size_t bytes);
    void write(std::string_view text) { write(text.data(), text.size()); }
    /// The file reaches the disk under its temporary name. Called by `commit` where it was not before.
    void flush();
    /// The target is replaced.
    void commit(Durability durability = Durability::now);

 private:
    std::filesystem::path target_, partial_;
    FileDescriptor file_;
    std::string buffer_;
    void write_buffer();
};

/// Replaces the file by `text`, atomically. @throws FileError
void write_file(const std::filesystem::path& path, std::string_view text, Durability durability = Durability::now);

/// Reads a whole file of at most `limit` bytes. @throws FileError
std::string read_file(const std::filesystem::path& path, std::size_t limit);

/// Makes a folder and its parents. @throws FileError
void make_folder(const std::filesystem::path& path);

}  // namespace riprap::io
