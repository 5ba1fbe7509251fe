// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sweep_kernel.hpp"
#include "riprap/fluid/particle/sweep_plain.hpp"
#include "riprap/fluid/wcmps/pair_sums.hpp"

namespace riprap::fluid::wcmps {

template <PairPhysics Pair>
void add_pair_sums(const WcmpsSettings& settings, const Pair& pair, const SweepSide<Pair::target_fields>& targets,
                   const SweepSide<Pair::candidate_fields>& candidates,
                   const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums, SweepScratch& scratch) {
    const SweepReach reach{settings.support_radius(), settings.domain};
    if (settings.is_plain) {
        sweep_plain(pair, reach, targets, candidates, sums);
    } else {
        sweep(pair, reach, targets, candidates, sums, scratch);
    }
}

template <MutualPhysics Pair>
void add_pair_sums_within(const WcmpsSettings& settings, const Pair& pair,
                          const SweepSide<Pair::target_fields>& particles,
                          const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>& sums,
                          SweepScratch& scratch) {
    const SweepReach reach{settings.support_radius(), settings.domain};
    if (settings.is_plain) {
        sweep_plain(pair, reach, particles, particles, sums);
    } else {
        exchange_within(pair, reach, particles, sums, scratch);
    }
}

#define RIPRAP_INSTANTIATE_WITHIN(Pair)                                                                                \
    template void add_pair_sums_within<Pair>(const WcmpsSettings&, const Pair&, const SweepSide<Pair::target_fields>&, \
                                             const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>&,       \
                                             SweepScratch&)
#define RIPRAP_INSTANTIATE(Pair)                                                                                \
    template void add_pair_sums<Pair>(const WcmpsSettings&, const Pair&, const SweepSide<Pair::target_fields>&, \
                                      const SweepSide<Pair::candidate_fields>&,                                 \
                                      const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>&,       \
                                      SweepScratch&)
RIPRAP_INSTANTIATE_WITHIN(NumberContinuity);
RIPRAP_INSTANTIATE(WallOpening);
RIPRAP_INSTANTIATE(WallsAlong);
RIPRAP_INSTANTIATE(NumberContinuityAtWalls);
RIPRAP_INSTANTIATE_WITHIN(MpsMomentum);
RIPRAP_INSTANTIATE(MpsMomentumFromWalls);
RIPRAP_INSTANTIATE(MpsWallAverages);
RIPRAP_INSTANTIATE(MpsPressureOnWalls);
RIPRAP_INSTANTIATE(MpsViscosityOnWalls);
RIPRAP_INSTANTIATE_WITHIN(MpsSurface);
RIPRAP_INSTANTIATE_WITHIN(MpsApproach);
RIPRAP_INSTANTIATE_WITHIN(MpsCollision);
#undef RIPRAP_INSTANTIATE
#undef RIPRAP_INSTANTIATE_WITHIN

}  // namespace riprap::fluid::wcmps
