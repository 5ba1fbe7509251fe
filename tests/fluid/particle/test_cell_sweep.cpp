// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sweep/cell_sweep.hpp"

#include <gmock/gmock.h>

#include "fluid/particle/sample.hpp"
#include "riprap/fluid/particle/sweep/sweep_plain.hpp"

namespace riprap::fluid {
namespace {

using parallel::Host;

/// Largest difference between the sums by cells and the plain ones, over the largest.
double difference_from_plain(const Sample& s) {
    const SweepSide<5> side = s.force_side();
    CellLists<Host> lists;
    const Box box = box_of(s.position);
    lists.place(s.reach(), box, s.position, box_of({}), {});
    const auto sums_by = [&](auto&& sweep) {
        std::vector<Vec3> sums(s.size(), Vec3{1, 2, 3});
        sweep(fresh<3>({sink_component(sums, 0), sink_component(sums, 1), sink_component(sums, 2)}));
        return sums;
    };
    const bench::AccelerationPair pair{s.constants};
    const auto fast = sums_by(
        [&](const std::array<FieldSink, 3>& to) { cell_sweep(pair, s.reach(), side, side, to, lists.fluid_fluid); });
    const auto plain =
        sums_by([&](const std::array<FieldSink, 3>& to) { sweep_plain(pair, s.reach(), side, side, to); });
    double largest = 0, difference = 0;
    for (std::size_t i = 0; i < plain.size(); ++i) {
        largest = std::max(largest, norm(plain[i]));
        difference = std::max(difference, norm(plain[i] - fast[i]));
    }
    return difference / largest;
}

TEST(CellSweep, agrees_with_the_plain_one) {
    EXPECT_LT(difference_from_plain(jittered_lattice(3, {13, 12, 11}, 1.5)), 1e-6);
    EXPECT_LT(difference_from_plain(jittered_lattice(2, {23, 22, 1}, 1.5)), 1e-6);
}

TEST(CellSweep, meets_the_nearest_image_along_a_periodic_axis) {
    for (const std::size_t axis : {0, 1, 2}) {
        Sample s = jittered_lattice(3, {13, 12, 11}, 1.5);
        s.domain.is_periodic[axis] = true;
        EXPECT_LT(difference_from_plain(s), 1e-6) << axis;
        if (axis < 2) {
            s = jittered_lattice(2, {23, 22, 1}, 1.5);
            s.domain.is_periodic[axis] = true;
            EXPECT_LT(difference_from_plain(s), 1e-6) << axis << ", in the plane";
        }
    }
}

TEST(CellSweep, adds_to_what_is_there_and_leaves_targets_out_of_reach_as_they_are) {
    const Sample s = jittered_lattice(3, {8, 8, 8}, 1.5);
    std::vector<Vec3> targets = s.position;
    targets.push_back({50, 0, 0});
    const SweepSide<5> candidates = s.force_side();
    CellLists<Host> lists;
    lists.place(s.reach(), box_of(s.position), s.position, box_of(targets), targets);
    std::vector<double> count(targets.size(), 10.0);
    cell_sweep(bench::CountPair{s.constants}, s.reach(), {targets, {}}, {candidates.position, {}}, {sink(count)},
               lists.walls_fluid);
    EXPECT_GT(count[0], 11);
    EXPECT_EQ(count.back(), 10);
}

}  // namespace
}  // namespace riprap::fluid
