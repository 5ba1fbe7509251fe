// SPDX-License-Identifier: Apache-2.0
#include <tuple>
#include <utility>

#include "riprap/fluid/particle/kernel.hpp"
#include "riprap/fluid/particle/pair_sums_kernel.hpp"
#include "riprap/fluid/sph/continuity.hpp"
#include "riprap/fluid/sph/density_sum.hpp"
#include "riprap/fluid/sph/momentum.hpp"
#include "riprap/fluid/sph/transposed_stress.hpp"
#include "riprap/fluid/sph/viscosities.hpp"
#include "riprap/fluid/sph/wall_averages.hpp"

namespace riprap::fluid {

RIPRAP_INSTANTIATE_SUMS_WITHIN(Continuity);
RIPRAP_INSTANTIATE_SUMS(ContinuityAtWalls);
RIPRAP_INSTANTIATE_SUMS(WaterOnWalls<WendlandC2>);
RIPRAP_INSTANTIATE_SUMS(WaterOnWalls<SpikyKernel>);
RIPRAP_INSTANTIATE_SUMS(DensitySum);
RIPRAP_INSTANTIATE_SUMS_WITHIN(DensitySum);
RIPRAP_INSTANTIATE_SUMS_WITHIN(VelocityGradient);
RIPRAP_INSTANTIATE_SUMS(VelocityGradientAtWalls);
RIPRAP_INSTANTIATE_SUMS_WITHIN(TransposedStress);
RIPRAP_INSTANTIATE_SUMS(TransposedFromWalls);
RIPRAP_INSTANTIATE_SUMS(TransposedOnWalls);

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
