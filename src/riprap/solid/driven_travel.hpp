// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/body/body_set.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"

namespace riprap::solid {

/// Longest way that a point of a driven body goes between two times, |dx| + R |turn| over four pieces of it, R its
/// reach [m]. A motion may be at rest at both ends, as a table with a step in it is: speeds tell less.
double driven_travel(const body::BodySet& bodies, const geometry::ShapeSet& shapes, double from, double to);

}  // namespace riprap::solid
