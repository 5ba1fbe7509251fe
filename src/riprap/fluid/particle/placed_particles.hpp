// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "riprap/fluid/particle/box_tree.hpp"
#include "riprap/fluid/particle/cluster_places.hpp"

namespace riprap::fluid {

/// One set of particles as sweeps see it: places, and boxes around them for the search of neighbours. Lists of several
/// pairs of sets may share it.
class PlacedParticles {
 public:
    void place(std::span<const Vec3> position, const FixedPoint& fixed, int dimension) {
        places_.update(position, fixed, dimension);
    }
    const ClusterPlaces& places() const { return places_; }
    /// Returns boxes around the positions, which are those of the last placement; made once for each.
    const BoxTree& boxes(std::span<const Vec3> position, const Domain& domain) {
        if (boxed_ != places_.updates()) {
            boxes_.build(position, domain);
            boxed_ = places_.updates();
        }
        return boxes_;
    }
    std::size_t bytes() const { return places_.bytes() + boxes_.bytes(); }

 private:
    ClusterPlaces places_;
    BoxTree boxes_;
    std::int64_t boxed_{0};  ///< placement of the boxes
};

}  // namespace riprap::fluid
