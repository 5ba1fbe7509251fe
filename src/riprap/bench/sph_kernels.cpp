// SPDX-License-Identifier: Apache-2.0
#include "riprap/bench/sph_pairs.hpp"
#include "riprap/fluid/particle/sweep/sweep_kernel.hpp"

namespace riprap::fluid {

RIPRAP_INSTANTIATE_EXCHANGE(bench::DensityRatePair);
RIPRAP_INSTANTIATE_SWEEP(bench::AccelerationPair);
RIPRAP_INSTANTIATE_EXCHANGE(bench::AccelerationPair);
RIPRAP_INSTANTIATE_EXCHANGE_WITHIN(bench::DensityRatePair);
RIPRAP_INSTANTIATE_EXCHANGE_WITHIN(bench::AccelerationPair);
RIPRAP_INSTANTIATE_SWEEP(bench::CountPair);

}  // namespace riprap::fluid
