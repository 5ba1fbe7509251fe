// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::geometry {

/// A face plane of a convex part.
struct LayerFace {
    Plane plane;
    bool is_cut;  ///< where the part was cut off: no layers follow it, and points keep half a spacing from it
};

/// A point that stands for a piece of a solid.
struct LayerPoint {
    Vec3 position;      ///< [m]
    double depth;       ///< below its face [m]
    double volume;      ///< [m^3]
    std::int32_t face;  ///< that it lies under; the first of several
};

struct LayerSettings {
    double spacing;  ///< dp [m]
    double reach;    ///< layers whose depth is below this are made [m]
    bool is_slab;    ///< a planar scene: the part lies between z = -dp/2 and dp/2, points on z = 0
};

/// Points in layers of thickness t under the faces of a convex part, layer k about depth (k + 1/2) t.
///
/// A layer is the surface of the part drawn in by its depth: points on its corners, along its edges and, on a lattice,
/// inside its faces, at most about dp apart; a box that a lattice fits gets exactly that lattice. The layer stands for
/// the piece of the solid whose nearest face lies between k t and (k + 1) t above it, and each point for what of that
/// piece is nearest to it within the face: areas of Voronoi cells at three depths, integrated by Simpson's rule, exact
/// for the quadratic growth of a convex section. So the volumes of all layers add up to that of the part, and the wall
/// lies exactly at the face. Each point is then moved to the middle of what it stands for, by the first moments of the
/// same cells: under a round face that is less deep than the middle of the layer. A plate of one layer keeps its
/// points: moved from its ends, they would leave a gap above the ground that it stands on.
///
/// t = dp, but a part with inscribed radius R that the layers reach through is divided evenly: t = 2 R/N with
/// N = max(1, round(2 R/dp)); layers of opposite faces then meet in the middle.
///
/// @param inscribed_radius  largest depth below all faces that are not cut [m]
/// @param centre  where it is reached; in a slab on z = 0 [m]
/// @param extent  a length no smaller than the part [m]
std::vector<LayerPoint> layers_under_faces(std::span<const LayerFace> faces, double inscribed_radius,
                                           const Vec3& centre, double extent, const LayerSettings& settings);

}  // namespace riprap::geometry
