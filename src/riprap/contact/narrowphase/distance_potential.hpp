// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/contact_set.hpp"
#include "riprap/contact/frame.hpp"
#include "riprap/contact/narrowphase/distance_potential_options.hpp"
#include "riprap/contact/narrowphase/separating_cache.hpp"
#include "riprap/geometry/polyhedra/convex_view.hpp"

namespace riprap::contact {

/// Distance-potential contact of two convex parts (see docs/theory/distance-potential.md).
/// @param stiffness_a  k_n of A, factor of its field [Pa]; stiffness_b likewise.
/// @returns false when the parts do not overlap; `contact` is then untouched.
bool find_contact(const geometry::ConvexView& a, const Frame& frame_a, double stiffness_a,
                  const geometry::ConvexView& b, const Frame& frame_b, double stiffness_b,
                  const DistancePotentialOptions& options, SeparatingCache& cache, NormalContact& contact);

}  // namespace riprap::contact
