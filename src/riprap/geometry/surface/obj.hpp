// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "riprap/geometry/surface/surface.hpp"

namespace riprap::geometry {

/// Reads the polygons of a Wavefront OBJ file from memory: `v`, `f` with corners `v`, `v/vt`, `v//vn`, `v/vt/vn`,
/// indices from 1 or negative (counted back from the last one defined), polygons of any number of corners, `\` at the
/// end of a line. An index must point to something already defined. Each `o` and `g` opens a body, or opens one of
/// the same name again. Texture coordinates, normals, materials and smoothing groups are checked for form and not
/// used; points and lines are reported in `notes`; free-form curves and surfaces are refused.
/// @param scale  metres per unit of the file [m]
/// @throws CaseError with every problem as file:line:column.
Surface read_obj(std::string_view bytes, const std::string& file, double scale);

}  // namespace riprap::geometry
