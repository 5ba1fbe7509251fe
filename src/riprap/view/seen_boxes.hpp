// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "riprap/view/pack_bodies.hpp"

namespace riprap::view {

/// Bounding box of a scene.
struct Box {
    Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};  // [m]
    void add(const Vec3& x) {
        low = min(low, x);
        high = max(high, x);
    }
    void add(const Box& box) {
        low = min(low, box.low);
        high = max(high, box.high);
    }
    bool is_empty() const { return low.x > high.x; }
    double length() const { return is_empty() ? 0 : norm(high - low); }
    /// Tells whether all of the box lies within `by` of the other one [m].
    bool is_near(const Box& other, double by) const {
        const Vec3 reach{by, by, by};
        const Vec3 below = other.low - reach - low, above = high - other.high - reach;
        return std::max({below.x, below.y, below.z, above.x, above.y, above.z}) <= 0;
    }
    /// The part of it within `by` of the other one [m]; empty where there is none.
    Box within(const Box& other, double by) const {
        const Vec3 reach{by, by, by};
        const Box part{max(low, other.low - reach), min(high, other.high + reach)};
        return part.low.x > part.high.x || part.low.y > part.high.y || part.low.z > part.high.z ? Box() : part;
    }
};

/// Finds which part of the scene a reader wants to see over the run.
class SeenBoxes {
 public:
    struct Found {
        Box first, all;  ///< of what moves, and of the water
        Box fixed;       ///< of bodies that stand still
    };

    /// Notes where the bodies of a frame are, in the order of the frames.
    void note(const BodyFrame& frame, const DrawnBodies& bodies);
    void add_water(const Vec3& low, const Vec3& high);

    /// Free bodies and water, and of driven bodies what is near them. Pieces that fly off by more than the length of
    /// the start are left out, where nine in ten of the bodies stay.
    Found find() const;

 private:
    /// Boxes that one body was seen to fill.
    struct Path {
        Box start, all;
        bool is_free{false}, moves{false};
    };
    std::vector<Path> paths_;  ///< of the bodies; half-spaces have none
    std::vector<double> first_pose_;
    Box water_;
};

}  // namespace riprap::view
