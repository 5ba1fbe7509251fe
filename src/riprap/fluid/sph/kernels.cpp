// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sweep_kernel.hpp"
#include "riprap/fluid/particle/sweep_plain.hpp"
#include "riprap/fluid/sph/continuity.hpp"
#include "riprap/fluid/sph/momentum.hpp"
#include "riprap/fluid/sph/pair_sums.hpp"
#include "riprap/fluid/sph/wall_averages.hpp"

namespace riprap::fluid {

template <PairPhysics Pair>
void add_pair_sums(const SphSettings& settings, const Pair& pair, const SweepSide<Pair::target_fields>& targets,
                   const SweepSide<Pair::candidate_fields>& candidates,
                   const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, SweepScratch& scratch) {
    const SweepReach reach{settings.support_radius(), settings.domain};
    if (settings.is_plain) {
        sweep_plain(pair, reach, targets, candidates, sums);
    } else {
        sweep(pair, reach, targets, candidates, sums, scratch);
    }
}

#define RIPRAP_INSTANTIATE(Pair)                                                                              \
    template void add_pair_sums<Pair>(const SphSettings&, const Pair&, const SweepSide<Pair::target_fields>&, \
                                      const SweepSide<Pair::candidate_fields>&,                               \
                                      const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>&,     \
                                      SweepScratch&)
RIPRAP_INSTANTIATE(Continuity);
RIPRAP_INSTANTIATE(ContinuityAtWalls);
RIPRAP_INSTANTIATE(WallAverages);
RIPRAP_INSTANTIATE(Momentum<ArtificialViscosity>);
RIPRAP_INSTANTIATE(MomentumFromWalls<ArtificialViscosity>);
RIPRAP_INSTANTIATE(MomentumOnWalls<ArtificialViscosity>);
RIPRAP_INSTANTIATE(Momentum<LaminarViscosity>);
RIPRAP_INSTANTIATE(MomentumFromWalls<LaminarViscosity>);
RIPRAP_INSTANTIATE(MomentumOnWalls<LaminarViscosity>);
#undef RIPRAP_INSTANTIATE

}  // namespace riprap::fluid
