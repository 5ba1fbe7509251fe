// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joints/placed_fours.hpp"

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::coupling {

template <class Real>
void place_fours(std::span<const JointFour> fours, const SampleView& near, const body::Motion& motion,
                 const fluid::BoundaryParticles& walls, const fluid::FixedPoint& fixed,
                 std::vector<PlacedFour<Real>>& placed) {
    make_room(placed, fours.size());
    parallel::for_each(std::ssize(fours), [&](std::int64_t number) {
        const JointFour& four = fours[at(number)];
        PlacedFour<Real>& here = placed[at(number)];
        here = {};
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            if (!four.has(lane)) {
                continue;
            }
            const std::size_t i = four.sample(lane);
            const Vec3 normal = rotate(motion.pose[at(near.body(i).value)].orientation, near.normal(i));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const int k = static_cast<int>(axis);
                here.place[axis][lane] = fixed(walls.position[i], k);
                here.normal[axis][lane] = static_cast<Real>(normal[k]);
            }
            here.depth[lane] = static_cast<Real>(near.depth(i));
            here.volume[lane] = static_cast<Real>(near.volume(i));
        }
    });
}

template void place_fours(std::span<const JointFour>, const SampleView&, const body::Motion&,
                          const fluid::BoundaryParticles&, const fluid::FixedPoint&, std::vector<PlacedFour<float>>&);
template void place_fours(std::span<const JointFour>, const SampleView&, const body::Motion&,
                          const fluid::BoundaryParticles&, const fluid::FixedPoint&, std::vector<PlacedFour<double>>&);

}  // namespace riprap::coupling
