// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps_operators/collision.hpp"
#include "riprap/fluid/mps_operators/wall_opening.hpp"
#include "riprap/fluid/mps_operators/wall_pairs.hpp"
#include "riprap/fluid/particle/pair_sums_kernel.hpp"

namespace riprap::fluid {

RIPRAP_INSTANTIATE_SUMS(MpsWallAverages);
RIPRAP_INSTANTIATE_SUMS(MpsPressureOnWalls);
RIPRAP_INSTANTIATE_SUMS(MpsViscosityOnWalls);
RIPRAP_INSTANTIATE_SUMS(MpsWallOpening);
RIPRAP_INSTANTIATE_SUMS(MpsWallsAlong);
RIPRAP_INSTANTIATE_SUMS_WITHIN(MpsCollision);

}  // namespace riprap::fluid
