// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/geometry/polyhedra/convex_view.hpp"

namespace riprap::geometry {

/// True for a prism of a planar scene: one unit thick, both end faces internal.
bool is_planar_prism(const ConvexView& shape);

/// True for a part with sharp edges alone: the normals of its faces are 29 degrees apart at least, and no cut through a
/// concave body, a mesh or a ground bounds it (internal faces that are no end faces). A half-space is sharp.
bool has_sharp_edges(const ConvexView& shape);

}  // namespace riprap::geometry
