// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/sweep_device.hpp"

#include <gmock/gmock.h>

#include "fluid/particle/sample.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/fixed_point.hpp"
#include "riprap/fluid/particle/sweep_plain.hpp"

namespace riprap::fluid {
namespace {

TEST(device_sweep, run_on_the_host_agrees_with_the_plain_one) {
    Sample s = jittered_lattice(3, {13, 12, 11}, 1.5);
    s.domain.is_periodic = {true, false, false};
    const SweepSide<5> side = s.force_side();
    const FixedPoint fixed(s.reach(), s.domain.high);
    std::vector<std::int32_t> places;
    std::vector<float> fields, sums(3 * s.size());
    for (std::size_t i = 0; i < s.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            places.push_back(fixed(s.position[i], axis));
        }
        for (const FieldView& view : side.fields) {
            fields.push_back(static_cast<float>(view[static_cast<std::int64_t>(i)]));
        }
    }
    CellGrid grid;
    grid.build(s.position, s.domain, s.reach().support_radius);
    TargetSweep<3, bench::AccelerationPair> sweep{{s.constants},
                                                  grid.view(),
                                                  s.position.data(),
                                                  places.data(),
                                                  places.data(),
                                                  fields.data(),
                                                  fields.data(),
                                                  {},
                                                  0,
                                                  sums.data()};
    for (int axis = 0; axis < 3; ++axis) {
        sweep.quantum[axis] = static_cast<float>(fixed.quantum()[axis]);
    }
    sweep.reach_squared = static_cast<float>(s.reach().support_radius * s.reach().support_radius);
    parallel::for_each(static_cast<std::int64_t>(s.size()), sweep);

    std::vector<Vec3> plain(s.size());
    sweep_plain(bench::AccelerationPair{s.constants}, s.reach(), side, side,
                {sink_component(plain, 0), sink_component(plain, 1), sink_component(plain, 2)});
    double largest = 0, difference = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        largest = std::max(largest, norm(plain[i]));
        difference = std::max(difference, norm(plain[i] - Vec3{sums[3 * i], sums[3 * i + 1], sums[3 * i + 2]}));
    }
    EXPECT_LT(difference, 1e-6 * largest);
}

}  // namespace
}  // namespace riprap::fluid
