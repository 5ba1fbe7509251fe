// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps/mps_pairs.hpp"
#include "riprap/fluid/particle/pair_sums_kernel.hpp"

namespace riprap::fluid {

RIPRAP_INSTANTIATE_SUMS_WITHIN(mps::Viscosity);
RIPRAP_INSTANTIATE_SUMS(mps::ViscosityFromWalls);
RIPRAP_INSTANTIATE_SUMS(mps::SlopeAtWalls);
RIPRAP_INSTANTIATE_SUMS(mps::PressureAtWalls);
RIPRAP_INSTANTIATE_SUMS_WITHIN(mps::Approach);
RIPRAP_INSTANTIATE_SUMS(mps::Approach);
RIPRAP_INSTANTIATE_SUMS(mps::CollisionWithWalls);

}  // namespace riprap::fluid
