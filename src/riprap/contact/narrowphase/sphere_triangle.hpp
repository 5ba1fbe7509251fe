// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/narrowphase/sphere_convex.hpp"
#include "riprap/geometry/surface/triangle.hpp"

namespace riprap::contact {

using geometry::nearest_on_triangle;
using geometry::TriangleFeature;
using geometry::TrianglePoint;

}  // namespace riprap::contact
