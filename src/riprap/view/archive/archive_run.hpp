// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace riprap::view {

struct ArchiveOptions {
    std::filesystem::path folder;  ///< of the run
    std::filesystem::path out;     ///< NAME.tar.gz; empty: beside the folder
    bool has_frames{false};        ///< frames for ParaView too
    bool has_checkpoint{false};    ///< and the State, to go on from
    bool force{false};             ///< replaces an archive that is there
};

struct Archived {
    std::filesystem::path archive;
    std::size_t files;
    std::uintmax_t bytes;              ///< of the archive
    std::vector<std::string> notices;  ///< what the reader of the archive should know
};

/// Makes one archive of a run, to hand on: its case with every file that it reads, tables, log, summary, page, and
/// pack.json, which has version, hash of the State, and name, size and XXH3 of each file. Unpacked it is a run folder:
/// `riprap run NAME` runs it again.
///
/// Files are copied first, so that the list and the archive are of the same bytes; GNU tar writes the archive under a
/// hidden name and compares it with the copies, then it takes its place: it is whole or not there.
/// @throws FileError where there is no run, another process writes there, a file cannot be read, or there is no tar
/// @throws BadRequest where the archive is there already, or would lie in the run folder
Archived archive_run(const ArchiveOptions& options);

}  // namespace riprap::view
