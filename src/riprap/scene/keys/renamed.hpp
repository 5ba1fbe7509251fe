// SPDX-License-Identifier: Apache-2.0
#pragma once

// Versions of the case file. A key or a word that is given another name gets a row here, so that old files are told the
// new one, and `riprap upgrade` can write it.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "riprap/scene/text/value.hpp"

namespace riprap::scene {

struct Table;

/// Newest format of case files that this program reads: `format` at the top of a file. A file of a newer format may
/// have keys that mean something else here, so nothing else in it is looked at.
constexpr std::int64_t newest_format = 1;

/// A key of a table of the case file, both as the key table names them.
struct KeyPlace {
    std::string_view table, key;
};

/// A key, or a word that a key took, which files of an older version may have.
struct Renamed {
    std::span<const KeyPlace> places;  ///< keys that took the word; of a renamed key, its tables, with the old name
    std::string_view word;             ///< old word; empty: the key was renamed
    std::string_view now;              ///< name today; empty: there is none
    std::string_view advice;           ///< what to write instead, where there is none
    std::string_view since;            ///< first version that refuses the old name
    std::string_view alone{};          ///< the word is an old one only in tables without this key
};

/// All names that are not read any more, newest last.
std::span<const Renamed> renamed_names();

/// An old name, where it stands in a file.
struct OldName {
    const Renamed* row;
    SourcePlace place;   ///< of the key, or of the text with the word
    std::string before;  ///< as it stands in the file: a key keeps the unit at its end
    std::string now;     ///< name today; empty where there is none, or where the table has it already
};

/// Gives old names of a tree those of today, and returns them in the order of the file. Names without one are left.
std::vector<OldName> rename_old(Value& root, const Table& table, std::span<const Renamed> rows = renamed_names());

/// The problem of an old name: what it is called today, or what to write instead.
Diagnostic problem_of(const OldName& old);

/// Appends a problem where the file is of a newer format than this program reads.
void check_format(const Value& root, std::vector<Diagnostic>& problems);

}  // namespace riprap::scene
