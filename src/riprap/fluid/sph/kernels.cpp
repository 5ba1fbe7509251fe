// SPDX-License-Identifier: Apache-2.0
#include <tuple>
#include <utility>

#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/sweep_kernel.hpp"
#include "riprap/fluid/particle/sweep_plain.hpp"
#include "riprap/fluid/sph/continuity.hpp"
#include "riprap/fluid/sph/momentum.hpp"
#include "riprap/fluid/sph/muller_kernels.hpp"
#include "riprap/fluid/sph/pair_sums.hpp"
#include "riprap/fluid/sph/transposed_stress.hpp"
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

template <MutualPhysics Pair>
void add_pair_sums_within(const SphSettings& settings, const Pair& pair,
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

#define RIPRAP_INSTANTIATE_WITHIN(Pair)                                                                              \
    template void add_pair_sums_within<Pair>(const SphSettings&, const Pair&, const SweepSide<Pair::target_fields>&, \
                                             const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>&,     \
                                             SweepScratch&)
#define RIPRAP_INSTANTIATE(Pair)                                                                              \
    template void add_pair_sums<Pair>(const SphSettings&, const Pair&, const SweepSide<Pair::target_fields>&, \
                                      const SweepSide<Pair::candidate_fields>&,                               \
                                      const std::array<FieldSink, static_cast<std::size_t>(Pair::sums)>&,     \
                                      SweepScratch&)
RIPRAP_INSTANTIATE_WITHIN(Continuity);
RIPRAP_INSTANTIATE(ContinuityAtWalls);
RIPRAP_INSTANTIATE(WaterOnWalls<WendlandC2>);
RIPRAP_INSTANTIATE(WaterOnWalls<SpikyKernel>);
RIPRAP_INSTANTIATE(DensitySum);
RIPRAP_INSTANTIATE_WITHIN(DensitySum);
RIPRAP_INSTANTIATE_WITHIN(VelocityGradient);
RIPRAP_INSTANTIATE(VelocityGradientAtWalls);
RIPRAP_INSTANTIATE_WITHIN(TransposedStress);
RIPRAP_INSTANTIATE(TransposedFromWalls);
RIPRAP_INSTANTIATE(TransposedOnWalls);
#undef RIPRAP_INSTANTIATE
#undef RIPRAP_INSTANTIATE_WITHIN

namespace {
/// The sums of forces that a viscosity needs with a kernel. What takes their addresses has them compiled here.
template <class Law, class Kernel>
constexpr auto sums_of() {
    using Viscosity = decltype(std::declval<const Law&>().pair(std::declval<const ParticleSettings&>(),
                                                               std::declval<const Kernel&>()));
    return std::tuple{&add_pair_sums_within<Momentum<Kernel, Viscosity>>,
                      &add_pair_sums<MomentumFromWalls<Kernel, Viscosity>>,
                      &add_pair_sums<ViscosityOnWalls<Kernel, Viscosity>>};
}
template <class... Laws>
constexpr auto sums_of_all(const Chosen<Laws...>* /*list*/) {
    return std::tuple{sums_of<Laws, WendlandC2>()..., sums_of<Laws, SpikyKernel>()...};
}
[[gnu::used]] constexpr auto sums_of_viscosities = sums_of_all(static_cast<const Viscosities*>(nullptr));
}  // namespace

}  // namespace riprap::fluid
