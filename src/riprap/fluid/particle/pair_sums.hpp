// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/sweep/sweep.hpp"

namespace riprap::fluid {

inline SweepReach reach_of(const ParticleSettings& settings) { return {settings.support_radius(), settings.domain}; }

/// Adds the sums of sweep(), in double and one pair at a time where the settings are plain. Defined for the pair
/// physics of a scheme in its kernels.cpp.
template <PairPhysics Pair>
void add_pair_sums(const ParticleSettings& settings, const Pair& pair, const SweepSide<Pair::target_fields>& targets,
                   const SweepSide<Pair::candidate_fields>& candidates,
                   const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, SweepScratch& scratch);

/// Adds those of exchange_within() likewise.
template <MutualPhysics Pair>
void add_pair_sums_within(const ParticleSettings& settings, const Pair& pair,
                          const SweepSide<Pair::target_fields>& particles,
                          const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums,
                          SweepScratch& scratch);

}  // namespace riprap::fluid
