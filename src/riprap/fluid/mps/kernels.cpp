// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps/mps_pairs.hpp"
#include "riprap/fluid/particle/sweep_kernel.hpp"
#include "riprap/fluid/particle/sweep_plain.hpp"
#include "riprap/fluid/wcmps/pair_sums.hpp"

namespace riprap::fluid::mps {

template <PairPhysics Pair>
void add_pair_sums(const MpsSettings& settings, const Pair& pair, const SweepSide<Pair::target_fields>& targets,
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
void add_pair_sums_within(const MpsSettings& settings, const Pair& pair,
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

using wcmps::MpsCollision;
using wcmps::MpsPressureOnWalls;
using wcmps::MpsViscosityOnWalls;
using wcmps::MpsWallAverages;
using wcmps::WallOpening;
using wcmps::WallsAlong;

#define RIPRAP_INSTANTIATE_WITHIN(Pair)                                                                              \
    template void add_pair_sums_within<Pair>(const MpsSettings&, const Pair&, const SweepSide<Pair::target_fields>&, \
                                             const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>&,     \
                                             SweepScratch&)
#define RIPRAP_INSTANTIATE(Pair)                                                                              \
    template void add_pair_sums<Pair>(const MpsSettings&, const Pair&, const SweepSide<Pair::target_fields>&, \
                                      const SweepSide<Pair::candidate_fields>&,                               \
                                      const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>&,     \
                                      SweepScratch&)
RIPRAP_INSTANTIATE_WITHIN(Viscosity);
RIPRAP_INSTANTIATE(ViscosityFromWalls);
RIPRAP_INSTANTIATE(SlopeAtWalls);
RIPRAP_INSTANTIATE(PressureAtWalls);
RIPRAP_INSTANTIATE_WITHIN(Approach);
RIPRAP_INSTANTIATE(Approach);
RIPRAP_INSTANTIATE(CollisionWithWalls);
RIPRAP_INSTANTIATE_WITHIN(MpsCollision);
RIPRAP_INSTANTIATE(MpsPressureOnWalls);
RIPRAP_INSTANTIATE(MpsViscosityOnWalls);
RIPRAP_INSTANTIATE(MpsWallAverages);
RIPRAP_INSTANTIATE(WallOpening);
RIPRAP_INSTANTIATE(WallsAlong);
#undef RIPRAP_INSTANTIATE
#undef RIPRAP_INSTANTIATE_WITHIN

}  // namespace riprap::fluid::mps
