// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/pair_sums_kernel.hpp"
#include "riprap/fluid/sph/sound_sums.hpp"

namespace riprap::fluid {

RIPRAP_INSTANTIATE_SUMS_WITHIN(SoundContinuity);
RIPRAP_INSTANTIATE_SUMS_WITHIN(SoundForce);
RIPRAP_INSTANTIATE_SUMS_WITHIN(Concentration);
RIPRAP_INSTANTIATE_SUMS(WallSlope);
RIPRAP_INSTANTIATE_SUMS(SoundOnWalls);

}  // namespace riprap::fluid
