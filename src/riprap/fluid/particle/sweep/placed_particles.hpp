// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/blocks.hpp"
#include "riprap/fluid/particle/sweep/box_tree.hpp"
#include "riprap/fluid/particle/sweep/cluster_places.hpp"

namespace riprap::fluid {

/// Numbers of patches of 2048 in the one order of all particles, where only some of them are kept (core/blocks.hpp).
class PatchOrder {
 public:
    void take(const parallel::Blocks& blocks) {
        number_.clear();
        whole_ = blocks.whole();
        for (std::int64_t k = 0; !blocks.are_all() && k < blocks.count(); ++k) {
            number_.push_back(blocks[k].number);
        }
    }
    /// Number of the k-th patch that is kept.
    std::int64_t operator[](std::int64_t k) const { return number_.empty() ? k : number_[static_cast<std::size_t>(k)]; }
    /// Number of all patches, of which `count` are kept.
    std::int64_t whole(std::int64_t count) const { return number_.empty() ? count : whole_; }

 private:
    std::vector<std::int64_t> number_;  ///< empty: all are kept
    std::int64_t whole_{0};
};

/// One set of particles as sweeps see it: places, and boxes around them for the search of neighbours. Lists of several
/// pairs of sets may share it.
class PlacedParticles {
 public:
    void place(std::span<const Vec3> position, const FixedPoint& fixed, int dimension) {
        places_.update(position, fixed, dimension);
    }
    const ClusterPlaces& places() const { return places_; }
    PatchOrder& order() { return order_; }
    const PatchOrder& order() const { return order_; }
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
    PatchOrder order_;
    std::int64_t boxed_{0};  ///< placement of the boxes
};

}  // namespace riprap::fluid
