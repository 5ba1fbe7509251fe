// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/io/file_descriptor.hpp"

namespace riprap::io {

/// Opens a file to go on writing it. Where it has a second name (a hard link), it is copied first, so that the other
/// one keeps what it has. @throws FileError as open_plain
FileDescriptor open_own(const std::filesystem::path& path, int flags);

}  // namespace riprap::io
