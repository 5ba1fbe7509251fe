// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/coupling/joints/joint_pairs.hpp"
#include "riprap/fluid/particle/sweep/box_tree.hpp"

namespace riprap::coupling {

/// Units of one solid, with places counted from the first of them on.
struct FoundUnits {
    std::vector<JointUnit> units;
    std::vector<JointSlot> slots;
    std::vector<JointEntry> met, joined;
};

/// Fours of one solid that follow each other: the fours of one solid among 64 numbers.
struct FourRange {
    std::int32_t solid;
    std::int32_t first, last;  ///< last included
};
/// Cuts the fours of all solids that move into such ranges.
std::vector<FourRange> ranges_of_fours(std::span<const JointFour> fours);

/// Finds what is near fours, with a distance beyond the reach.
class JointSearch {
 public:
    /// Distances within which pairs are listed [m].
    struct Reach {
        float met;     ///< of all pairs
        float joined;  ///< of pairs with any faces that are part of a joint
        float facing;  ///< n_i . n_j below which faces may come to look at each other
    };
    JointSearch(std::span<const JointFour> fours, std::span<const PlacedFour<float>> placed,
                const fluid::FixedPoint& fixed, const fluid::BoxTree& boxes, const Reach& reach)
        : fours_(fours), placed_(placed), fixed_(fixed), boxes_(boxes), reach_(reach) {}

    /// Finds the units of some fours: all pairs with solids of lower number.
    void find(const FourRange& range, FoundUnits& found) const;

 private:
    std::span<const JointFour> fours_;
    std::span<const PlacedFour<float>> placed_;
    const fluid::FixedPoint& fixed_;
    const fluid::BoxTree& boxes_;
    Reach reach_;
};

}  // namespace riprap::coupling
