// SPDX-License-Identifier: Apache-2.0
#pragma once

// Files that a program writes in a folder where others may have put something else under their names: a link that
// leads out of the folder, a second name of a file that lies elsewhere, a named pipe. Nothing is ever written through
// these.

#include "riprap/io/file_descriptor.hpp"

namespace riprap::io {

/// Makes a new, empty file. What stood there under its name is removed: a link goes, what it leads to stays.
/// @param target  the file to name in messages @throws FileError
FileDescriptor create_own(const std::filesystem::path& path, const std::filesystem::path& target);
inline FileDescriptor create_own(const std::filesystem::path& path) { return create_own(path, path); }

/// Opens a file, with the flags of open(2), by its own name alone. @throws FileError for a link and for what is no
/// regular file
FileDescriptor open_plain(const std::filesystem::path& path, int flags);

/// Tells whether a name still leads to this open file, and to it directly.
bool is_in_place(const FileDescriptor& file, const std::filesystem::path& path);

/// Refuses a folder that is a link: what is written into it would lie elsewhere. @throws FileError
void refuse_linked_folder(const std::filesystem::path& path);

}  // namespace riprap::io
