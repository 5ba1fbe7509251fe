// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/broadphase/brute_force.hpp"

#include "riprap/contact/broadphase/giants.hpp"

namespace riprap::contact {

std::vector<PartPair> find_pairs_brute_force(const PartBounds& bounds, std::span<const Giant> giants, double skin) {
    GiantPlanes planes;
    planes.assign(bounds, giants);
    const std::int32_t part_count = bounds.size();
    std::vector<std::int32_t> giant_of(static_cast<std::size_t>(part_count), -1);
    for (std::int32_t g = 0; g < planes.size(); ++g) {
        giant_of[static_cast<std::size_t>(planes.part(g))] = g;
    }
    std::vector<PartPair> pairs;
    for (std::int32_t a = 0; a < part_count; ++a) {
        for (std::int32_t b = a + 1; b < part_count; ++b) {
            const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
            const bool has_giant = giant_of[i] >= 0 || giant_of[j] >= 0;
            const bool is_pair =
                has_giant ? giant_within(planes, bounds, giant_of[i], a, giant_of[j], b, skin)
                          : may_pair(bounds, i, j) && spheres_within(bounds.center[i], bounds.radius[i],
                                                                     bounds.center[j], bounds.radius[j], skin);
            if (is_pair) {
                pairs.push_back({a, b});
            }
        }
    }
    return pairs;
}

}  // namespace riprap::contact
