// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "riprap/fluid/particle/sweep.hpp"
#include "riprap/fluid/sph/sph_settings.hpp"

namespace riprap::fluid {

/// sweep(), or the plain one where the settings ask for it. Defined for the pair physics of this folder in kernels.cpp.
template <PairPhysics Pair>
void add_pair_sums(const SphSettings& settings, const Pair& pair, const SweepSide<Pair::target_fields>& targets,
                   const SweepSide<Pair::candidate_fields>& candidates,
                   const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, SweepScratch& scratch);

/// exchange_within(), or the plain sweep where the settings ask for it.
template <MutualPhysics Pair>
void add_pair_sums_within(const SphSettings& settings, const Pair& pair,
                          const SweepSide<Pair::target_fields>& particles,
                          const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums,
                          SweepScratch& scratch);

}  // namespace riprap::fluid
