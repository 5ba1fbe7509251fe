// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <zlib.h>

#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "riprap/io/atomic_file.hpp"
#include "riprap/io/checkpoint.hpp"

namespace riprap {

/// Writes another format into the header of a checkpoint, with a checksum that fits.
inline std::string with_format(std::string bytes, std::uint32_t version) {
    constexpr std::size_t version_at = 8, checksum_at = 48;
    std::memcpy(bytes.data() + version_at, &version, sizeof version);
    const auto checksum =
        static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), checksum_at));
    std::memcpy(bytes.data() + checksum_at, &checksum, sizeof checksum);
    return bytes;
}

/// Rewrites a checkpoint as the version would have written it that used this format: fields that came later are left
/// out, and the case has another hash, as its resolved text had other keys.
inline void make_older(const std::filesystem::path& path, std::uint32_t version) {
    const io::Checkpoint now = io::Checkpoint::read(path);
    std::vector<io::Section> sections;
    for (const io::Section& section : now.sections()) {
        const std::string_view judged = "judged.";
        const bool is_judged = section.name.starts_with(judged);
        const std::string_view name = is_judged ? section.name.substr(judged.size()) : section.name;
        if (io::later_field(version, name) == nullptr && !(is_judged && version == 1)) {
            sections.push_back(section);
        }
    }
    io::CheckpointHeader header = now.header();
    header.case_hash += 1;
    const std::filesystem::path written = path.string() + ".older";
    io::write_sections(written, header, sections);
    io::write_file(path, with_format(io::read_file(written, 1U << 24U), version));
    std::filesystem::remove(written);
}

}  // namespace riprap
