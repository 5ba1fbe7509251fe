// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/frame.hpp"
#include "riprap/geometry/polyhedra/convex_view.hpp"

namespace riprap::contact {

/// A part where it is. A half-space has no vertices.
struct PlacedShape {
    const geometry::ConvexView& shape;
    const Frame& frame;
    bool is_plane() const { return shape.vertex_count == 0; }
};

/// Depth of one body below a face plane of the other: of its deepest corner.
struct FaceDepth {
    double depth;  ///< [m]
    bool is_of_a;  ///< the face
    int face{-1};  ///< -1: no face
};

/// The two faces on which a pair of convex parts lie on each other: that with the least depth, and that of the other
/// part which is most nearly opposed.
///
///     share of the foot s = smooth step of c = -m_A . m_B from 0 at cos(h) to 1 at cos(h/2),
///
/// m outward normals, h half of the least angle to another face of the same part, 45 degrees at most. So a face has no
/// share before another one could take over.
struct FacingFaces {
    int of_a{-1}, of_b{-1};
    Vec3 normal_a{}, normal_b{};  ///< m, world [-]
    double share{0};              ///< s [-]
    double share_by_cosine{0};    ///< ds/dc [-]
    double rise{1};               ///< tan of the least angle to another face of the same part, 1 at most [-]
    FaceDepth least{};            ///< of the two faces
    FaceDepth next{};             ///< of all other faces; infinite where there is none
    Vec3 origin{};                ///< from which places of the pair are measured, world [m]
};

/// Finds the faces of a pair. Internal faces carry no field and are no feet; nor are faces that border a cut through a
/// body, because the field of both of its sides together does not know the cut, and corners on it would; the share is 0
/// where there are no two faces, or where the least depth is none.
FacingFaces find_facing_faces(const PlacedShape& a, const PlacedShape& b);

/// Normal of the face of a depth, and the deepest corner below it, in world axes, from `origin`. Where several are as
/// deep, as of a face that is even with the other, the point between them that is nearest to `near`: the depth has no
/// one slope there, and which corner comes first must not turn the bodies.
struct DeepestCorner {
    Vec3 normal, place;
};
DeepestCorner deepest_corner(const PlacedShape& a, const PlacedShape& b, const FaceDepth& depth, const Vec3& origin,
                             const Vec3& near);

}  // namespace riprap::contact
