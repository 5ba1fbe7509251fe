// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/body/body_set.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"

namespace riprap::solid {

/// Depth of an overlap over the smaller inscribed radius from which on a run is ended [-]: where the centre of one body
/// has come to the surface of the other, their contact no longer pushes them apart but on.
inline constexpr double most_overlap = 0.75;

/// Share of the smaller inscribed radius that two bodies approach each other by in a step, at most [-]: so an overlap
/// is seen between 0.75 and 0.95 of it, before that.
inline constexpr double most_approach = 0.2;

/// Distance of the farthest point of a body from its centre of mass, in the plane where the scene is planar and a
/// prism only turns about its length; 0 for half-spaces [m].
double reach_of(const body::BodySet& bodies, const geometry::ShapeSet& shapes, std::int64_t body);

/// The thinnest of what may be met: smallest inscribed radius of the parts [m]; infinite for half-spaces alone.
double smallest_radius(const body::BodySet& bodies, const geometry::ShapeSet& shapes);

/// Largest speed at which two bodies approach each other: the sum of the two largest speeds of a point of a body,
/// |v| + |omega| R, R its circumradius [m/s]. Half-spaces count with the speed of their reference point.
double fastest_approach(const body::BodySet& bodies, const geometry::ShapeSet& shapes, const body::BodyState& state);

/// Upper limit of fastest_approach that takes no turning into body axes, with |omega| <= |L| / I_min [m/s].
double approach_limit(const body::BodySet& bodies, const geometry::ShapeSet& shapes, const body::BodyState& state);

}  // namespace riprap::solid
