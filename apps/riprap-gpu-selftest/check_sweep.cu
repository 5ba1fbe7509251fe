// SPDX-License-Identifier: Apache-2.0
// Sums over neighbours: the same functors on the device, on the host in float, and in the plain double sweep.
#include "checks.hpp"
#include "riprap/core/parallel_cuda.hpp"
#include "riprap/fluid/particle/fixed_point.hpp"
#include "riprap/fluid/particle/sweep_device.hpp"
#include "some_water.hpp"

namespace selftest {

namespace {

using riprap::parallel::cuda::DeviceArray;
using Sweep = riprap::fluid::TargetSweep<3, AccelerationPair>;

}  // namespace

bool check_sweep() {
    const Water water = some_water(24);
    const std::size_t n = water.position.size();
    const riprap::fluid::SweepReach reach{2 * water.constants.smoothing_length, water.domain};
    const riprap::fluid::FixedPoint fixed(reach, water.domain.high);
    std::vector<std::int32_t> places;
    std::vector<float> fields, sums(3 * n);
    for (std::size_t i = 0; i < n; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            places.push_back(fixed(water.position[i], axis));
        }
        for (const std::vector<double>& field : water.fields) {
            fields.push_back(static_cast<float>(field[i]));
        }
    }
    riprap::fluid::CellGrid grid;
    grid.build(water.position, water.domain, reach.support_radius);
    Sweep sweep{AccelerationPair{water.constants},
                grid.view(),
                water.position.data(),
                places.data(),
                places.data(),
                fields.data(),
                fields.data(),
                {},
                static_cast<float>(reach.support_radius * reach.support_radius),
                sums.data()};
    for (int axis = 0; axis < 3; ++axis) {
        sweep.quantum[axis] = static_cast<float>(fixed.quantum()[axis]);
    }
    riprap::parallel::for_each(static_cast<std::int64_t>(n), sweep);

    const DeviceArray<std::int32_t> starts_there(grid.starts());
    const DeviceArray<std::uint32_t> points_there(grid.points());
    const DeviceArray<Vec3> position_there{std::span<const Vec3>(water.position)};
    const DeviceArray<std::int32_t> places_there{std::span<const std::int32_t>(places)};
    const DeviceArray<float> fields_there{std::span<const float>(fields)};
    DeviceArray<float> sums_there(sums.size());
    Sweep there = sweep;
    there.grid.start = starts_there.data();
    there.grid.points = points_there.data();
    there.target_position = position_there.data();
    there.target_place = there.candidate_place = places_there.data();
    there.target_fields = there.candidate_fields = fields_there.data();
    there.sums = sums_there.data();
    riprap::parallel::cuda::for_each(static_cast<std::int64_t>(n), there);

    bool ok = same_bits("accelerations of 13 824 particles of water", sums, sums_there.download());
    const double difference = difference_from_plain(water, reach, sums_there.download());
    std::printf("%-58s %.1e of the largest\n", "their difference from the plain double sweep", difference);
    return ok && difference < 1e-6;
}

}  // namespace selftest
