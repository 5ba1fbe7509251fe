// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "riprap/geometry/surface/surface.hpp"

namespace riprap::geometry {

/// True if the bytes are a binary STL file: 80 bytes of header, a count n (little-endian), and exactly 50 n bytes, or
/// something that is no text. The first word decides nothing: binary files that begin with "solid" are common, and
/// no text within SurfaceLimits has bytes 80 to 83 that state its own length.
bool is_binary_stl(std::string_view bytes);

/// Reads an STL file, ASCII or binary, from memory. Every `solid` of an ASCII file is a body of its own. The winding
/// of a facet states its outer side; a stated normal that contradicts it is reported in `notes`, and normals are
/// not used for anything else. Numbers that are not finite are refused, also in normals.
/// @param scale  metres per unit of the file [m]
/// @throws CaseError with every problem: file:line:column, or the byte offset in a binary file.
Surface read_stl(std::string_view bytes, const std::string& file, double scale);

}  // namespace riprap::geometry
