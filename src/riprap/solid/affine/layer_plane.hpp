// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/narrowphase/common_plane.hpp"

namespace riprap::solid::affine {

/// The common plane of a pair (contact::common_plane), but never one across a layer that both blocks fill. Sections of
/// many metres are in by more than the metre by which prisms of planar scenes are thick, and what overlaps least is
/// then the thickness: such blocks went through each other.
contact::CommonPlane plane_between(const contact::PlacedHull& a, const contact::PlacedHull& b,
                                   const contact::PlaneFeature& before, double reach);

}  // namespace riprap::solid::affine
