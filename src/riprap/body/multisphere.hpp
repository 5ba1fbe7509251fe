// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "riprap/core/ids.hpp"
#include "riprap/core/mat3.hpp"
#include "riprap/geometry/polyhedra/outcome.hpp"
#include "riprap/geometry/polyhedra/polyhedron.hpp"

namespace riprap::body {

/// One sphere of a body that is made of spheres.
struct ShapeSphere {
    Vec3 centre;         ///< in the frame of the shape [m]
    double radius{0};    ///< [m]
    Vec3 face_normal{};  ///< outward normal of the face or round side that the sphere lies in; 0 in edges and corners
                         ///< [-]
};

/// Spheres that a case gives a body to be met by.
struct GivenSpheres {
    BodyId body;
    std::vector<ShapeSphere> spheres;  ///< in the body frame, about its centre of mass
};

/// Spheres that stand for a body in contact, and the volume integrals of the true shape where it is known.
struct Multisphere {
    std::vector<ShapeSphere> spheres;
    geometry::MassProperties shape{};  ///< of the true shape; volume 0 = known by its spheres only
};

/// Integrals over the union of spheres: each of rays x rays lines along z crosses it in intervals that are merged
/// exactly, and their integrals are summed. 200 rays a side give 0.1 % or better.
geometry::MassProperties union_of_spheres(const std::vector<ShapeSphere>& spheres, int rays = 400);

/// Shell of a box: spheres of equal radius in its faces, flush with them, about 2 r apart and no farther; at least two
/// a side. Spheres inside faces carry their normal.
/// @param size    edge lengths [m]
/// @param radius  of the spheres; at most half the shortest edge [m]
geometry::Outcome<Multisphere> box_shell(const Vec3& size, double radius);

/// Shell of a box with n x n x n spheres a side of the whole grid, less its inside: radius = shortest edge/(2 n).
geometry::Outcome<Multisphere> box_shell(const Vec3& size, int count);

/// Shell of a rectangle in a planar scene: discs along its edges, flush with them, as box_shell places them.
/// @param size  edge lengths along x and y [m]; z is not looked at
geometry::Outcome<Multisphere> rectangle_shell(const Vec3& size, double radius);

/// Ring of `count` spheres in the x-y plane whose outermost points lie on the circle of `outer_radius`; stands for a
/// cylinder of that radius and of `length` along z.
geometry::Outcome<Multisphere> ring(double outer_radius, double sphere_radius, int count, double length);

/// Spheres on a cubic lattice whose centres lie inside a closed surface by at least their radius less `spacing`/2,
/// those with all six lattice neighbours left out (they can touch nothing). Points are inside by the solid angle of the
/// surface about them.
/// @param surface  closed, outward faces
/// @param spacing  of the lattice; the spheres have half of it as radius [m]
geometry::Outcome<Multisphere> fill_surface(const geometry::Polyhedron& surface, double spacing);

/// Reads lines `x y z radius` [m] separated by blanks or commas; `#` begins a comment.
/// @param name  of the file, for messages
geometry::Outcome<Multisphere> read_sphere_list(const std::string& text, const std::string& name);

/// Refuses a shape without spheres, spheres of no radius, and spheres that lie inside another one.
geometry::Outcome<Multisphere> checked(Multisphere shape);

}  // namespace riprap::body
