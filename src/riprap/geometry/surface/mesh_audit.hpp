// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/core/error.hpp"
#include "riprap/geometry/surface/triangle_mesh.hpp"

namespace riprap::geometry {

/// Lists what is odd about a mesh as ground or walls.
struct MeshAudit {
    std::vector<Diagnostic> problems;   ///< of its polygons, and of its winding: the solid would lie on both sides
    std::vector<std::string> warnings;  ///< told with the name of the file
};

/// Leaves out triangles that repeat others, and looks at the winding: triangles that share an edge run through it in
/// opposite senses, but where more than two meet; none lies on another back to back. Warns of rims that would meet if
/// points a little apart were one: cracks, at which bodies catch.
/// @param mesh  of `surface`, with the faces that its triangles come from
MeshAudit audit_mesh(TriangleMesh& mesh, const Surface& surface);

}  // namespace riprap::geometry
