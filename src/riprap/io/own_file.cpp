// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/own_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace riprap::io {

namespace {

constexpr mode_t own_mode = 0644;

[[noreturn]] void refuse_kind(const std::filesystem::path& path, bool is_link) {
    throw FileError("cannot write '" + path.string() + "': it is " +
                    (is_link ? "a link, and nothing is written through links; put a copy of what it leads to in its "
                               "place, or remove it"
                             : "not a regular file; remove it"));
}

/// What stands there by itself, not what a link leads to. False where nothing does.
bool look_at(const std::filesystem::path& path, struct stat& status) {
    if (::lstat(path.c_str(), &status) == 0) {
        return true;
    }
    if (errno != ENOENT) {
        throw file_error("write", path, errno);
    }
    return false;
}

}  // namespace

FileDescriptor create_own(const std::filesystem::path& path, const std::filesystem::path& target) {
    constexpr int most_tries = 3;  // another process may put something there in between
    for (int i = 0; i < most_tries; ++i) {
        FileDescriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, own_mode));
        if (file.is_open()) {
            return file;
        }
        if (errno != EEXIST || (::unlink(path.c_str()) != 0 && errno != ENOENT)) {
            break;
        }
    }
    throw file_error("write", target, errno);
}

FileDescriptor open_plain(const std::filesystem::path& path, int flags) {
    struct stat status {};
    if (look_at(path, status) && !S_ISREG(status.st_mode)) {
        refuse_kind(path, S_ISLNK(status.st_mode));
    }
    // Opening a named pipe would wait for its other end; regular files do not heed the flag.
    FileDescriptor file(::open(path.c_str(), flags | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, own_mode));
    if (!file.is_open()) {
        throw file_error("write", path, errno);
    }
    if (::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode)) {
        refuse_kind(path, false);
    }
    return file;
}

bool is_in_place(const FileDescriptor& file, const std::filesystem::path& path) {
    struct stat open {
    }, named{};
    return ::fstat(file.number(), &open) == 0 && ::lstat(path.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
           open.st_ino == named.st_ino;
}

void refuse_linked_folder(const std::filesystem::path& path) {
    std::error_code error;
    if (std::filesystem::is_symlink(path, error)) {
        throw FileError("cannot write into '" + path.string() +
                        "': it is a link, and nothing is written through links; move the folder that it leads to into "
                        "its place, or choose another folder with --out");
    }
}

}  // namespace riprap::io
