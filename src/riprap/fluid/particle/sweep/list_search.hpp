// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/fluid/particle/sweep/cluster_list.hpp"

namespace riprap::fluid {

/// Finds what is near clusters of targets, sixteen clusters of targets at a time. No branch depends on a single box:
/// the finds are written one behind the other, and the misses overwritten.
class ListSearch {
 public:
    /// Neighbours and their distances.
    struct Question {
        const ClusterPlaces& targets;
        const ClusterPlaces& candidates;
        const BoxTree& target_boxes;
        const BoxTree& candidate_boxes;
        const FixedPoint& fixed;
        int dimension;
        bool is_each_once;  ///< no candidates before the target
        float distance;     ///< of pairs in the lists [m]
        float watched;      ///< distance beyond it at which blocks are still watched [m]
    };
    explicit ListSearch(const Question& question);

    /// Makes the lists of a patch.
    void fill(std::int64_t first_block, std::int64_t block_count, Patch& patch);

 private:
    void find_around(std::int64_t target_block);
    void find(std::int64_t target, std::vector<std::int32_t>& found);
    void number_clusters(Patch& patch);

    Question question_;
    float box_distance_;
    std::vector<std::int32_t> blocks_, near_blocks_, near_clusters_, entries_, start_;
    std::vector<BoxTree::Block> block_boxes_;
    std::vector<std::uint16_t> named_;          ///< clusters of every block that the patch names
    std::vector<std::int32_t> place_of_block_;  ///< in the patch
};

}  // namespace riprap::fluid
