// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "riprap/io/own_file.hpp"

namespace riprap::io {

namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 18;

std::filesystem::path folder_of(const std::filesystem::path& file) {
    return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

std::filesystem::path partial_name(const std::filesystem::path& target) {
    std::string name(".");
    name += target.filename().string();
    name += ".partial";
    return folder_of(target) / name;
}

}  // namespace

void flush_file_system(const std::filesystem::path& folder) {
    const FileDescriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!file.is_open()) {
        throw file_error("open folder", folder, errno);
    }
    if (::syncfs(file.number()) != 0) {
        throw file_error("flush the disk of", folder, errno);
    }
}

AtomicFile::AtomicFile(std::filesystem::path target)
    : target_(std::move(target)), partial_(partial_name(target_)), file_(create_own(partial_, target_)) {
    buffer_.reserve(buffer_bytes);
}

AtomicFile::~AtomicFile() {
    if (file_.is_open() && is_in_place(file_, partial_)) {
        ::unlink(partial_.c_str());
    }
}

void AtomicFile::write(const void* data, std::size_t bytes) {
    if (buffer_.size() + bytes > buffer_bytes) {
        write_buffer();
    }
    if (bytes >= buffer_bytes) {
        write_all(file_, data, bytes, target_);
    } else {
        buffer_.append(static_cast<const char*>(data), bytes);
    }
}

void AtomicFile::write_buffer() {
    write_all(file_, buffer_.data(), buffer_.size(), target_);
    buffer_.clear();
}

void AtomicFile::flush() {
    write_buffer();
    flush_to_disk(file_, target_);
}

void AtomicFile::commit(Durability durability) {
    if (durability == Durability::now) {
        flush();
    } else {
        write_buffer();
    }
    if (!is_in_place(file_, partial_)) {
        throw FileError("cannot write '" + target_.string() + "': '" + partial_.string() +
                        "' was removed or replaced while it was written; two programs write the same file");
    }
    if (::rename(partial_.c_str(), target_.c_str()) != 0) {
        throw file_error("write", target_, errno);
    }
    file_.close();
    if (durability == Durability::now) {
        flush_folder(folder_of(target_));
    }
}

void write_file(const std::filesystem::path& path, std::string_view text, Durability durability) {
    AtomicFile file(path);
    file.write(text);
    file.commit(durability);
}

std::string read_file(const std::filesystem::path& path, std::size_t limit) {
    // Opening a named pipe would wait for a writer; regular files do not heed the flag.
    const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (!file.is_open() || ::fstat(file.number(), &status) != 0) {
        throw file_error("read", path, errno);
    }
    if (!S_ISREG(status.st_mode)) {
        throw FileError("cannot read '" + path.string() + "': not a regular file");
    }
    if (static_cast<std::uintmax_t>(status.st_size) > limit) {
        throw FileError("cannot read '" + path.string() + "': " + std::to_string(status.st_size) +
                        " bytes, more than the limit of " + std::to_string(limit));
    }
    // The file may change size while it is read: the limit holds for what is read, not for what was promised.
    std::string text;
    text.reserve(static_cast<std::size_t>(status.st_size));
    char chunk[1 << 16];
    while (true) {
        const ssize_t count = ::read(file.number(), chunk, sizeof chunk);
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            throw file_error("read", path, errno);
        }
        if (count == 0) {
            return text;
        }
        if (text.size() + static_cast<std::size_t>(count) > limit) {
            throw FileError("cannot read '" + path.string() + "': more than the limit of " + std::to_string(limit) +
                            " bytes");
        }
        text.append(chunk, static_cast<std::size_t>(count));
    }
}

void make_folder(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error || !std::filesystem::is_directory(path)) {
        throw file_error("make folder", path, error ? error.value() : ENOTDIR);
    }
}

}  // namespace riprap::io
