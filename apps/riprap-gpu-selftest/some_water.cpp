// SPDX-License-Identifier: Apache-2.0
#include "some_water.hpp"

#include <algorithm>
#include <random>

#include "riprap/fluid/particle/sweep/sweep_plain.hpp"

namespace selftest {

Water some_water(int count) {
    Water water;
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    water.fields.resize(AccelerationPair::target_fields);
    for (int k = 0; k < count * count * count; ++k) {
        const Vec3 place{0.5 + k % count, 0.5 + k / count % count, 0.5 + k / (count * count)};
        water.position.push_back(water.spacing * (place + 0.25 * Vec3{unit(random), unit(random), unit(random)}));
        for (int axis = 0; axis < 3; ++axis) {
            water.fields[static_cast<std::size_t>(axis)].push_back(unit(random));
        }
        water.fields[3].push_back(1e-2 * unit(random));
        water.fields[4].push_back(1000 + unit(random));
    }
    const double h = 1.5 * water.spacing;
    water.domain.high = water.spacing * Vec3{1.0 * count, 1.0 * count, 1.0 * count};
    water.domain.is_periodic = {true, false, false};
    water.constants = {riprap::fluid::WendlandC2(h, 3), h, 20, 1000, 1e-3, 0.1, 0.1, {0, 0, -9.81}};
    return water;
}

double difference_from_plain(const Water& water, const riprap::fluid::SweepReach& reach,
                             const std::vector<float>& sums) {
    riprap::fluid::SweepSide<5> side{water.position, {}};
    for (std::size_t k = 0; k < side.fields.size(); ++k) {
        side.fields[k] = riprap::fluid::field(water.fields[k]);
    }
    std::vector<Vec3> plain(water.position.size());
    riprap::fluid::sweep_plain(AccelerationPair{water.constants}, reach, side, side,
                               {riprap::fluid::sink_component(plain, 0), riprap::fluid::sink_component(plain, 1),
                                riprap::fluid::sink_component(plain, 2)});
    double largest = 0, difference = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        largest = std::max(largest, norm(plain[i]));
        difference = std::max(difference, norm(plain[i] - Vec3{sums[3 * i], sums[3 * i + 1], sums[3 * i + 2]}));
    }
    return difference / largest;
}

}  // namespace selftest
