// SPDX-License-Identifier: Apache-2.0
// Sums over neighbours: the same functors on the device, on the host in float, and in the plain double sweep.
#include "checks.hpp"
#include "riprap/core/parallel_device.hpp"
#include "riprap/fluid/particle/sweep/cell_sweep.hpp"
#include "some_water.hpp"

namespace selftest {

namespace {

/// Accelerations of some water by the sums in memory of `Where`, [particle][3].
template <class Where>
std::vector<float> sum_up(const Water& water, const riprap::fluid::SweepReach& reach) {
    using namespace riprap::fluid;
    const std::size_t n = water.position.size();
    typename Where::template Array<Vec3> position;
    Where::template upload<Vec3>(water.position, position);
    typename Where::template Array<double> fields[AccelerationPair::target_fields];
    typename Where::template Array<float> sums(3 * n);
    SweepSide<AccelerationPair::target_fields> side{{position.data(), n}, {}};
    for (std::size_t k = 0; k < side.fields.size(); ++k) {
        Where::template upload<double>(water.fields[k], fields[k]);
        side.fields[k] = FieldView{fields[k].data()};
    }
    CellLists<Where> lists;
    const Box box = box_of(water.position);
    lists.place(reach, box, side.position, Box{{1, 1, 1}, {0, 0, 0}}, {});
    cell_sweep(AccelerationPair{water.constants}, reach, side, side,
               fresh<3>({FieldSink{nullptr, 3, false, sums.data()}, FieldSink{nullptr, 3, false, sums.data() + 1},
                         FieldSink{nullptr, 3, false, sums.data() + 2}}),
               lists.fluid_fluid);
    std::vector<float> found(3 * n);
    Where::template download<float>(sums, found);
    return found;
}

}  // namespace

bool check_sweep() {
    const Water water = some_water(24);
    const riprap::fluid::SweepReach reach{2 * water.constants.smoothing_length, water.domain};
    const std::vector<float> sums = sum_up<riprap::parallel::Host>(water, reach);
    const std::vector<float> sums_there = sum_up<riprap::parallel::device::Device>(water, reach);
    const bool ok = same_bits("accelerations of 13 824 particles of water", sums, sums_there);
    const double difference = difference_from_plain(water, reach, sums_there);
    std::printf("%-58s %.1e of the largest\n", "their difference from the plain double sweep", difference);
    return ok && difference < 1e-6;
}

}  // namespace selftest
