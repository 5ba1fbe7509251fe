// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "riprap/core/error.hpp"

namespace riprap::scene {

/// A file that the case reads besides itself (a surface, a table), with the path as the case writes it.
struct InputFile {
    std::string path;       ///< relative to the folder of the case, no "..", no links out of it
    std::uint64_t hash{0};  ///< of the bytes
};

/// The folder of a case, and the only way to read other files from it: no absolute paths, no "..", no links that
/// lead out, regular files only, within a size limit.
class CaseFiles {
 public:
    explicit CaseFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Reads a file into memory. Nothing, and a problem at `place`, when that is refused or fails.
    std::optional<std::string> read(const std::string& path, std::size_t max_bytes, const SourcePlace& place,
                                    std::vector<Diagnostic>& problems);

    /// Files read so far, by path.
    std::vector<InputFile> inputs() const;

 private:
    std::filesystem::path folder_;
    std::map<std::string, std::uint64_t> inputs_;
};

}  // namespace riprap::scene
