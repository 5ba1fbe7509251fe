// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "riprap/contact/narrowphase/common_plane.hpp"

namespace riprap::contact {

/// Kind of contact by the number of corners that touch the common plane from either side [Ding2021, table 4.1].
enum class ContactType : std::uint8_t {
    none,
    vertex_vertex,
    vertex_edge,
    vertex_face,
    edge_vertex,
    edge_edge,
    edge_face,
    face_vertex,
    face_edge,
    face_face
};
std::string_view to_string(ContactType type);

/// A pair of points that face each other across the common plane, one on the surface of each body.
struct PlaneContact {
    Vec3 on_a, on_b;        ///< [m]
    double gap;             ///< n . (on_b - on_a), negative where the bodies overlap there [m]
    double area;            ///< share of the contact polygon [m^2]; 0 where corners and edges meet
    std::uint64_t feature;  ///< names the pair of points while it lasts: corner of A, corner of B, or two edges
};

inline constexpr int most_plane_contacts = 48;

/// All contacts of a pair across its common plane.
struct PlaneContacts {
    ContactType type{ContactType::none};
    Vec3 normal{};   ///< from A to B [-]
    double area{0};  ///< of the contact polygon [m^2]
    int count{0};
    std::array<PlaneContact, most_plane_contacts> contacts;
};

/// Reduces a common plane to contacts. The corners of A and B within `tolerance` of the nearest one are projected on
/// the plane; the two convex sets (points, segments, polygons) are intersected there, and every corner of the
/// intersection is a contact: a corner of one body on the face of the other, or a crossing of two edges. Differs
/// from [Ding2021], where faces that cross without a corner inside each other have no contact. `area` sums to that of
/// the intersection: a corner has the part of it nearest along the boundary.
/// @param tolerance  [m]; see contact_tolerance
void find_plane_contacts(const PlacedHull& a, const PlacedHull& b, const CommonPlane& plane, double tolerance,
                         PlaneContacts& found);

/// Distance within which corners count as touching: 2 |gap| + 1e-4 of the smaller body, at most a tenth of it [m].
double contact_tolerance(const PlacedHull& a, const PlacedHull& b, const CommonPlane& plane);

/// Do the touching features (corners within `tolerance`) lie opposite each other? If not, the plane is no optimum.
bool do_features_meet(const PlacedHull& a, const PlacedHull& b, const CommonPlane& plane, double tolerance);

}  // namespace riprap::contact
