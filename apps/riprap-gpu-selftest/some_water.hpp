// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "riprap/bench/sph_pairs.hpp"
#include "riprap/fluid/particle/sweep/sweep.hpp"

namespace selftest {

using riprap::Vec3;
using riprap::bench::AccelerationPair;

/// A jittered block of water, periodic along x.
struct Water {
    double spacing{0.01};
    riprap::fluid::Domain domain;
    std::vector<Vec3> position;
    std::vector<std::vector<double>> fields;  ///< of AccelerationPair
    riprap::bench::SphConstants constants;
};

Water some_water(int count);

/// Largest difference from the plain double sweep over the largest acceleration; sums are [particle][3].
double difference_from_plain(const Water& water, const riprap::fluid::SweepReach& reach,
                             const std::vector<float>& sums);

}  // namespace selftest
