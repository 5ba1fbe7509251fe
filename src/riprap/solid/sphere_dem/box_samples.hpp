// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/solid/sphere_dem/surface_sample.hpp"

namespace riprap::solid::sphere_dem {

/// Spheres that stand for a box.
struct BoxSampling {
    Vec3 size;         ///< edge lengths [m]
    double radius{0};  ///< R, at most half the shortest edge [m]
    double sharp{0};   ///< radius of the samples of edges and corners [m]
    bool is_planar{false};
    bool meets_triangles{false};
};

/// Returns spheres at the nodes of a grid on the faces of a box, in the plane on its outline, two radii apart at most,
/// each with the area next to its node: the whole cell inside a face, half of the cells in an edge, a quarter in a
/// corner, of several faces their mean. Springs that count by area push as an even pressure does, by the trapezoidal
/// rule: through the centre of a face, and with (1 + 2/n^2) times its stiffness against tilting, n cells along an edge.
/// In edges and corners the spheres are small, for parts to meet; where there are triangles another one of radius R
/// lies inside of each, for them.
std::vector<SurfaceSample> box_samples(const BoxSampling& box);

/// Number of nodes of a box, for those that are better not made [-].
double box_sample_count(const BoxSampling& box);

}  // namespace riprap::solid::sphere_dem
