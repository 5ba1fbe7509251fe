// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/core/vec3.hpp"

namespace riprap::contact {

/// Normal of the contact of two surface spheres k and l, from k to l [Amaro2021, A19]: against the outward face normal
/// of l where l lies in a face, else along that of k where k lies in a face, else along the centres. It removes the
/// bumps of a face that is sampled by spheres. A sphere in an edge or corner has the face normal 0.
///
/// @param face_k, face_l  outward unit normals, world axes; 0 of a sphere in an edge or corner [-]
/// @param centres         unit vector from the centre of k to that of l [-]
inline Vec3 closest_pair_normal(const Vec3& face_k, const Vec3& face_l, const Vec3& centres) {
    if (norm_squared(face_l) > 0) {
        return -face_l;
    }
    return norm_squared(face_k) > 0 ? face_k : centres;
}

/// Depth of the overlap of two spheres along a contact normal [m]: l_k/2 + l_l/2 less the distance of the centres along
/// it; along the centres that is the overlap of the spheres.
inline double overlap_along(const Vec3& normal, const Vec3& from_k_to_l, double radius_k, double radius_l) {
    return radius_k + radius_l - dot(normal, from_k_to_l);
}

}  // namespace riprap::contact
