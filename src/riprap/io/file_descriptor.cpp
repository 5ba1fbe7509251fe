// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/file_descriptor.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

namespace riprap::io {

namespace {

const char* remedy(int error_number) {
    switch (error_number) {
        case ENOSPC:
        case EDQUOT:
            return "free some space or choose another folder with --out; `riprap resume` continues a run, the same "
                   "command a study or ensemble";
        case EFBIG:
            return "raise the file size limit (`ulimit -f`) or write fewer frames; `riprap resume` continues a run, "
                   "the same command a study or ensemble";
        case EROFS:
            return "the disk is mounted read-only; write to another one";
        case EACCES:
        case EPERM:
            return "check the permissions or choose another folder with --out";
        case ENOENT:
            return "check that the path exists";
        case ENOTDIR:
        case EEXIST:
            return "a file stands where a folder is needed; choose another folder with --out";
        case EMFILE:
        case ENFILE:
            return "too many open files; raise `ulimit -n`";
        default:
            return "check the disk";
    }
}

}  // namespace

FileError file_error(std::string_view action, const std::filesystem::path& path, int error_number) {
    return FileError("cannot " + std::string(action) + " '" + path.string() + "': " + std::strerror(error_number) +
                     "; " + remedy(error_number));
}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
    if (this != &other) {
        close();
        number_ = other.release();
    }
    return *this;
}

int FileDescriptor::release() { return std::exchange(number_, -1); }

void FileDescriptor::close() {
    if (is_open()) {
        ::close(number_);
        number_ = -1;
    }
}

void write_all(const FileDescriptor& file, const void* data, std::size_t bytes, const std::filesystem::path& path) {
    const auto* next = static_cast<const char*>(data);
    while (bytes > 0) {
        const ssize_t written = ::write(file.number(), next, bytes);
        if (written < 0) {
            if (errno == EINTR) {
                continue;
            }
            throw file_error("write", path, errno);
        }
        next += written;
        bytes -= static_cast<std::size_t>(written);
    }
}

void flush_to_disk(const FileDescriptor& file, const std::filesystem::path& path) {
    while (::fsync(file.number()) != 0) {
        if (errno == EINVAL || errno == ENOTSUP) {
            return;  // pipes and some network file systems cannot flush; nothing more can be asked of them
        }
        if (errno != EINTR) {
            throw file_error("flush", path, errno);
        }
    }
}

void flush_folder(const std::filesystem::path& folder) {
    const FileDescriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!file.is_open()) {
        throw file_error("open folder", folder, errno);
    }
    flush_to_disk(file, folder);
}

}  // namespace riprap::io
