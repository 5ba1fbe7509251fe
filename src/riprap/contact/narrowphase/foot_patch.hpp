// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/contact/narrowphase/facing_faces.hpp"

namespace riprap::contact {

/// A point or direction in the plane of a patch.
struct PatchPoint {
    double x{0}, y{0};
};

/// Edge of one of the two faces, counter-clockwise about n.
struct PatchEdge {
    bool is_of_b;
    bool is_free;      ///< no internal face lies behind it
    PatchPoint along;  ///< unit direction in the plane [-]
    Vec3 whole;        ///< from end to end, world [m]
};

/// Corner of a patch.
struct PatchCorner {
    PatchPoint place{};   ///< q [m]
    int edge{0};          ///< number of the edge that goes out, to the next corner
    double turn{0};       ///< exterior angle theta [rad]
    double weight{0};     ///< w of the area [m^2], set by CornerFoot
    double depth{0};      ///< d = z_A(q) - z_B(q), z height of the face planes along n [m]
    Vec3 on_a{}, on_b{};  ///< points of the face planes over q, world, from FacingFaces::origin [m]
};

/// The patch P that two faces share: both projected along n = (m_A - m_B)/|m_A - m_B| and cut by each other, whatever
/// their depth.
struct FootPatch {
    Vec3 n{}, e1{}, e2{};             ///< axes, n from A to B [-]
    PatchPoint slope_a{}, slope_b{};  ///< gradients of z_A and z_B [-]
    PatchPoint centroid{};            ///< [m]
    double area{0};                   ///< [m^2]
    double free_length{0};            ///< of the free edges [m]
    std::vector<PatchEdge> edges{};
    std::vector<PatchCorner> corners{};  ///< counter-clockwise about n

    std::size_t size() const { return corners.size(); }
    const PatchCorner& next(std::size_t i) const { return corners[i + 1 < size() ? i + 1 : 0]; }
    const PatchCorner& last(std::size_t i) const { return corners[i > 0 ? i - 1 : size() - 1]; }
    const PatchEdge& edge_from(const PatchCorner& corner) const { return edges[static_cast<std::size_t>(corner.edge)]; }
    /// 2 area/free_length: of a long patch the distance of its sides [m]; infinite without free edges.
    double width() const;
    Vec3 in_space(const PatchPoint& p) const { return p.x * e1 + p.y * e2; }
};

/// @returns false where the faces share nothing
bool find_foot_patch(const PlacedShape& a, const PlacedShape& b, const FacingFaces& faces, FootPatch& patch);

/// Where the two faces of a patch overlap: the part of it with d > 0.
struct ClosedPatch {
    double area;      ///< [m^2]
    PatchPoint push;  ///< centre of pressure of an even field, whose pressure grows with d [m]
};
ClosedPatch closed_part(const FootPatch& patch);

}  // namespace riprap::contact
