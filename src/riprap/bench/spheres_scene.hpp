// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/sphere_dem/sphere_world.hpp"

namespace riprap::bench {

/// A bed of equal spheres at rest: d = 10 mm, 2500 kg/m^3, E = 5 MPa, nu = 0.3, friction 0.5, restitution 0.3, five
/// frictional walls. Poured from a jittered lattice of 22 x 22 x 21 at a volume fraction of 0.34 and settled in this
/// process; copies of it are set side by side without the walls between them.
solid::sphere_dem::SphereWorld sphere_bed(int tiles_x, int tiles_y);

/// Step at which published peers were timed [s].
inline constexpr double sphere_bed_dt = 50e-6;

}  // namespace riprap::bench
