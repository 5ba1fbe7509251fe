// SPDX-License-Identifier: Apache-2.0
#pragma once

// Arrays as ParaView's XML files hold them: inline, zlib-compressed in blocks, base64. The appended layout would be
// smaller, but larger appended files do not load in Debian 12's ParaView (docs/howto/output-files.md).

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "riprap/core/vec3.hpp"
#include "riprap/io/base64.hpp"

namespace riprap::io {

/// The content of a DataArray element of a file with header_type="UInt64" and vtkZLibDataCompressor:
/// base64 of [block count, block size, size of the last partial block or 0, compressed sizes...], then base64 of the
/// compressed blocks.
std::string encode_vtk_array(std::span<const unsigned char> bytes);
/// Encodes the bytes piece by piece: no more than the compressed bytes are in memory.
void encode_vtk_array(std::span<const unsigned char> bytes, const TextSink& put);
/// Decodes the bytes; `most_bytes` bounds their number, because a few bytes can promise a thousand times as many.
/// @throws FileError when the text is not that, or holds more
std::string decode_vtk_array(std::string_view text, std::size_t most_bytes = std::size_t{4} << 30U);

/// One DataArray element, indented for readers, piece by piece. The entry type decides VTK's name for it.
void put_vtk_array(const TextSink& put, std::string_view name, std::span<const float> values, int components = 1);
void put_vtk_array(const TextSink& put, std::string_view name, std::span<const std::int32_t> values);
void put_vtk_array(const TextSink& put, std::string_view name, std::span<const Vec3> values);

/// One DataArray element as one text.
std::string vtk_array(std::string_view name, std::span<const float> values, int components = 1);
std::string vtk_array(std::string_view name, std::span<const double> values, int components = 1);
std::string vtk_array(std::string_view name, std::span<const std::int32_t> values, int components = 1);
std::string vtk_array(std::string_view name, std::span<const std::int64_t> values, int components = 1);
std::string vtk_array(std::string_view name, std::span<const std::uint8_t> values, int components = 1);

/// One DataArray element of FieldData, which states its number of tuples itself.
std::string vtk_field_array(std::string_view name, std::span<const double> values, int components = 1);

}  // namespace riprap::io
