// SPDX-License-Identifier: Apache-2.0
#pragma once

// Checkpoints of older versions: which fields they do not have, and how these begin.

#include <cstdint>
#include <string_view>

namespace riprap::io {

/// A field that came with a format of checkpoints.
struct LaterField {
    std::string_view name;
    std::uint32_t since;  ///< first format that has it
    /// Field with an entry for each of its own, which are zero; none: the field keeps what a State begins with.
    std::string_view belongs_to;
};

/// The field of that name where files of this format do not have it yet; else null.
const LaterField* later_field(std::uint32_t version, std::string_view name);

/// The versions of Riprap that write a format of checkpoints.
std::string_view writer_of(std::uint32_t version);

}  // namespace riprap::io
