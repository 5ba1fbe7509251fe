// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "riprap/geometry/surface/surface.hpp"

namespace riprap::io {

/// Reads the polygons of a ParaView PolyData file (.vtp) from memory, in the layouts that VTK writes: arrays as text,
/// inline or appended, in base64 or raw, zlib-compressed or plain. Arrays beside points and polygons, lines and single
/// points are not used. Triangle strips, several pieces and other compressors are refused.
/// @param scale  metres per unit of the file [m]
/// @throws CaseError with what the file lacks.
geometry::Surface read_vtp_surface(std::string_view bytes, const std::string& file, double scale);

}  // namespace riprap::io
