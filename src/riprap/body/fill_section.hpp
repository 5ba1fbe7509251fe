// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/body/multisphere.hpp"

namespace riprap::body {

/// Discs on a square lattice inside the section z = 0 of a planar body, a prism about it; those with all four lattice
/// neighbours left out. As fill_surface otherwise.
/// @param prism    closed, outward faces
/// @param spacing  of the lattice; the discs have half of it as radius [m]
geometry::Outcome<Multisphere> fill_section(const geometry::Polyhedron& prism, double spacing);

}  // namespace riprap::body
