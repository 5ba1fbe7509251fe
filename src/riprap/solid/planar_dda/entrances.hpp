// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/solid/planar_dda/seams.hpp"

namespace riprap::solid::planar_dda {

/// Ways in at two convex corners: none where their cones leave none from outside, one, or two that share it.
struct Entrances {
    int count{0};
    Key key[2]{};
    bool is_at_seam{false};  ///< the other one is hidden by a third block
};

/// Finds the entrances at two corners; see find_contacts().
Entrances find_entrances(const Scene& scene, const Seams& seams, std::int32_t v, std::int32_t w);

}  // namespace riprap::solid::planar_dda
