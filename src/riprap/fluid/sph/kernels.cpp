// SPDX-License-Identifier: Apache-2.0
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
// a comma in a template argument list would be one in the macro's
template <class Kernel, class Viscosity>
struct Forces {
    using InFluid = Momentum<Kernel, Viscosity>;
    using FromWalls = MomentumFromWalls<Kernel, Viscosity>;
    using OnWalls = ViscosityOnWalls<Kernel, Viscosity>;
};
using Artificial = Forces<WendlandC2, ArtificialViscosity>;
using Laminar = Forces<WendlandC2, LaminarViscosity>;
using MullerArtificial = Forces<SpikyKernel, ArtificialViscosity>;
using MullerLaminar = Forces<SpikyKernel, MullerViscosity>;
RIPRAP_INSTANTIATE_WITHIN(Artificial::InFluid);
RIPRAP_INSTANTIATE(Artificial::FromWalls);
RIPRAP_INSTANTIATE(Artificial::OnWalls);
RIPRAP_INSTANTIATE_WITHIN(Laminar::InFluid);
RIPRAP_INSTANTIATE(Laminar::FromWalls);
RIPRAP_INSTANTIATE(Laminar::OnWalls);
RIPRAP_INSTANTIATE_WITHIN(MullerArtificial::InFluid);
RIPRAP_INSTANTIATE(MullerArtificial::FromWalls);
RIPRAP_INSTANTIATE(MullerArtificial::OnWalls);
RIPRAP_INSTANTIATE_WITHIN(MullerLaminar::InFluid);
RIPRAP_INSTANTIATE(MullerLaminar::FromWalls);
RIPRAP_INSTANTIATE(MullerLaminar::OnWalls);
#undef RIPRAP_INSTANTIATE
#undef RIPRAP_INSTANTIATE_WITHIN

}  // namespace riprap::fluid
