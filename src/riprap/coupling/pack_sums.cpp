// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/pack_sums.hpp"

#include "riprap/fluid/particle/sweep/sweep_kernel.hpp"

namespace riprap::fluid {

RIPRAP_INSTANTIATE_EXCHANGE_WITHIN(PackedSlope);
RIPRAP_INSTANTIATE_SWEEP(PackedSlopeOfRest);
RIPRAP_INSTANTIATE_SWEEP(PackedCount);

}  // namespace riprap::fluid
