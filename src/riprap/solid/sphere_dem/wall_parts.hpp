// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/contact/broadphase/pair_cache.hpp"
#include "riprap/solid/sphere_dem/place.hpp"
#include "riprap/solid/sphere_dem/sphere_model.hpp"
#include "riprap/solid/sphere_dem/sphere_state.hpp"

// Spheres that touch convex parts: which faces, edges and corners of flush and notched parts count.

namespace riprap::solid::sphere_dem {

/// Portion by which the springs of a sphere count; of the deepest contact alone, which stands for all, the whole.
inline double portion_of(const SphereModel& model, std::int32_t sphere) {
    return model.settings.sharing == contact::Sharing::closest
               ? 1
               : model.spheres.portion[static_cast<std::size_t>(sphere)];
}

/// A part that a sphere touches.
struct Touched {
    WallContact contact;
    std::int32_t face;  ///< that the contact is on; -1: an edge or corner
};

/// Returns the contact of a sphere and a part; its overlap is below 0 where they are apart.
Touched touch(const SphereModel& model, const Placed& placed, contact::PartPair pair);

/// Adds the contacts of a sphere with the parts that it touches, those left out that others hide or cover.
void add_parts(const SphereModel& model, const Placed& placed, const std::vector<Touched>& touched,
               std::vector<WallContact>& out);

/// Adds the contacts with parts that a sphere has left through the side of another one in their notch.
void add_missed(const SphereModel& model, const Placed& placed, const std::vector<Touched>& touched,
                const std::vector<Touched>& missed, std::vector<WallContact>& out);

}  // namespace riprap::solid::sphere_dem
