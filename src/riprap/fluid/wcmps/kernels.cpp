// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/pair_sums_kernel.hpp"
#include "riprap/fluid/wcmps/continuity_pairs.hpp"
#include "riprap/fluid/wcmps/momentum_pairs.hpp"
#include "riprap/fluid/wcmps/surface_pairs.hpp"

namespace riprap::fluid {

RIPRAP_INSTANTIATE_SUMS_WITHIN(wcmps::NumberContinuity);
RIPRAP_INSTANTIATE_SUMS(wcmps::NumberContinuityAtWalls);
RIPRAP_INSTANTIATE_SUMS_WITHIN(wcmps::MpsMomentum);
RIPRAP_INSTANTIATE_SUMS(wcmps::MpsMomentumFromWalls);
RIPRAP_INSTANTIATE_SUMS_WITHIN(wcmps::MpsSurface);
RIPRAP_INSTANTIATE_SUMS_WITHIN(wcmps::MpsApproach);

}  // namespace riprap::fluid
