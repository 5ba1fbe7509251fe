// SPDX-License-Identifier: Apache-2.0
#include "riprap/io/continued_file.hpp"

#include <sys/stat.h>

#include <limits>

#include "riprap/io/atomic_file.hpp"
#include "riprap/io/own_file.hpp"

namespace riprap::io {

FileDescriptor open_own(const std::filesystem::path& path, int flags) {
    struct stat status {};
    if (::lstat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink > 1) {
        write_file(path, read_file(path, std::numeric_limits<std::size_t>::max()));
    }
    return open_plain(path, flags);
}

}  // namespace riprap::io
