// SPDX-License-Identifier: Apache-2.0
#pragma once

// The definitions of pair_sums.hpp. For files of kernels only, which instantiate the sums of their own pair physics.

#include "riprap/fluid/particle/pair_sums.hpp"
#include "riprap/fluid/particle/sweep/sweep_kernel.hpp"
#include "riprap/fluid/particle/sweep/sweep_plain.hpp"

namespace riprap::fluid {

template <PairPhysics Pair>
void add_pair_sums(const ParticleSettings& settings, const Pair& pair, const SweepSide<Pair::target_fields>& targets,
                   const SweepSide<Pair::candidate_fields>& candidates,
                   const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, SweepScratch& scratch) {
    if (settings.is_plain) {
        sweep_plain(pair, reach_of(settings), targets, candidates, sums);
    } else {
        sweep(pair, reach_of(settings), targets, candidates, sums, scratch);
    }
}

template <MutualPhysics Pair>
void add_pair_sums_within(const ParticleSettings& settings, const Pair& pair,
                          const SweepSide<Pair::target_fields>& particles,
                          const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums,
                          SweepScratch& scratch) {
    if (settings.is_plain) {
        sweep_plain(pair, reach_of(settings), particles, particles, sums);
    } else {
        exchange_within(pair, reach_of(settings), particles, sums, scratch);
    }
}

}  // namespace riprap::fluid

/// Define the sums of one type of pair physics here; at namespace scope of riprap::fluid.
#define RIPRAP_INSTANTIATE_SUMS(Pair)                                                                              \
    template void add_pair_sums<Pair>(const ParticleSettings&, const Pair&, const SweepSide<Pair::target_fields>&, \
                                      const SweepSide<Pair::candidate_fields>&,                                    \
                                      const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>&,          \
                                      SweepScratch&)
#define RIPRAP_INSTANTIATE_SUMS_WITHIN(Pair)                                         \
    template void add_pair_sums_within<Pair>(                                        \
        const ParticleSettings&, const Pair&, const SweepSide<Pair::target_fields>&, \
        const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>&, SweepScratch&)
