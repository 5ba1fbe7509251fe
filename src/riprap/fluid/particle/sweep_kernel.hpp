// SPDX-License-Identifier: Apache-2.0
#pragma once

// The definition of sweep(). For files of kernels only, see sweep.hpp. For now it is the plain sweep.

#include "riprap/fluid/particle/sweep_plain.hpp"

namespace riprap::fluid {

template <PairPhysics Pair>
void sweep(const Pair& pair, const SweepReach& reach, const SweepSide<Pair::target_fields>& targets,
           const SweepSide<Pair::candidate_fields>& candidates,
           const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, SweepScratch&) {
    sweep_plain(pair, reach, targets, candidates, sums);
}

}  // namespace riprap::fluid

/// Defines the sweep of one type of pair physics here; at namespace scope of riprap::fluid.
#define RIPRAP_INSTANTIATE_SWEEP(Pair)                                                               \
    template void sweep<Pair>(const Pair&, const SweepReach&, const SweepSide<Pair::target_fields>&, \
                              const SweepSide<Pair::candidate_fields>&,                              \
                              const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>&, SweepScratch&)
