// SPDX-License-Identifier: Apache-2.0
// Sums over neighbours: the same functors on the device, on the host in float, and in the plain double sweep.
#include "checks.hpp"
#include "riprap/core/parallel_cuda.hpp"
#include "riprap/fluid/particle/fixed_point.hpp"
#include "riprap/fluid/particle/sweep_device.hpp"
#include "some_water.hpp"

namespace selftest {

namespace {

using riprap::Field;
using riprap::Residence;
using Sweep = riprap::fluid::TargetSweep<3, AccelerationPair>;

}  // namespace

bool check_sweep() {
    const Water water = some_water(24);
    const std::size_t n = water.position.size();
    const riprap::fluid::SweepReach reach{2 * water.constants.smoothing_length, water.domain};
    const riprap::fluid::FixedPoint fixed(reach, water.domain.high);
    std::vector<std::int32_t> places;
    std::vector<float> fields;
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
    riprap::parallel::cuda::Memory memory;
    const auto copy_of = [](auto values) { return std::vector(values.begin(), values.end()); };
    Field<std::int32_t> cell_starts(copy_of(grid.starts()), &memory);
    Field<std::uint32_t> cell_points(copy_of(grid.points()), &memory);
    Field<Vec3> position(water.position, &memory);
    Field<std::int32_t> place(places, &memory);
    Field<float> field(fields, &memory), sum(3 * n, &memory);
    const auto sum_up = [&](Residence where) {
        Sweep sweep{AccelerationPair{water.constants},
                    grid.view(),
                    position.read(where).data(),
                    place.read(where).data(),
                    place.read(where).data(),
                    field.read(where).data(),
                    field.read(where).data(),
                    {},
                    static_cast<float>(reach.support_radius * reach.support_radius),
                    sum.overwrite(where).data()};
        sweep.grid.start = cell_starts.read(where).data();
        sweep.grid.points = cell_points.read(where).data();
        for (int axis = 0; axis < 3; ++axis) {
            sweep.quantum[axis] = static_cast<float>(fixed.quantum()[axis]);
        }
        riprap::parallel::cuda::for_each(where, {0, static_cast<std::int64_t>(n)}, sweep);
        return copy_of(sum.read(Residence::host));
    };
    const std::vector<float> sums = sum_up(Residence::host), sums_there = sum_up(Residence::device);

    bool ok = same_bits("accelerations of 13 824 particles of water", sums, sums_there);
    const double difference = difference_from_plain(water, reach, sums_there);
    std::printf("%-58s %.1e of the largest\n", "their difference from the plain double sweep", difference);
    return ok && difference < 1e-6;
}

}  // namespace selftest
