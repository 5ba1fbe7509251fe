// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/contact/narrowphase/hull.hpp"

namespace riprap::contact {

/// Area that both bodies cut from the plane halfway between them, where they overlap by `depth` along `normal` (from A
/// to B): how far edges and corners that meet have grown into each other [m^2]. The bodies are taken as shifted along
/// `normal` until they overlap by that much; a half-space has a section without end.
double common_section(const PlacedHull& a, const PlacedHull& b, const Vec3& normal, double depth);

}  // namespace riprap::contact
