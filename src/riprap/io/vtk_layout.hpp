// SPDX-License-Identifier: Apache-2.0
#pragma once

// Arrays of ParaView's XML files in every layout that VTK writes. What Riprap writes itself is read by vtp_reader.hpp.

#include <cstddef>
#include <string_view>
#include <vector>

#include "riprap/io/vtk_xml.hpp"

namespace riprap::io {

/// Encoding of the arrays of a file.
struct VtkLayout {
    std::string_view appended;    ///< what follows the "_" of AppendedData
    bool is_raw{false};           ///< appended bytes as they are; base64 else
    bool is_compressed{false};    ///< by zlib, in blocks
    std::size_t header_bytes{4};  ///< of one number of a header

    /// @throws FileError for another compressor or order of bytes
    static VtkLayout of(std::string_view file);

    /// The numbers of an array. `most` bounds them, for a few bytes can promise a thousand times as many.
    /// @throws FileError when it is cut or damaged, holds more, or values of another type
    std::vector<double> numbers(const VtkElement& array, std::size_t most) const;
};

}  // namespace riprap::io
