// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joints/solid_slopes.hpp"

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/sweep/cell_grid.hpp"

namespace riprap::coupling {

namespace {

/// Slopes of the samples `members`, at `place`, among themselves.
void find_slopes(const SampleSet& samples, const std::vector<std::size_t>& members, const std::vector<Vec3>& place,
                 const fluid::WendlandC2& kernel, double reach, const fluid::Domain& domain,
                 std::vector<Vec3>& slopes) {
    fluid::CellGrid grid;
    grid.build(place, domain, reach);
    const fluid::NearestImage nearest(domain);
    parallel::for_each_uneven(static_cast<std::int64_t>(place.size()), 64, [&](std::int64_t i) {
        Vec3 slope{};
        grid.for_each_near(place[at(i)], [&](std::int64_t j) {
            const Vec3 d = nearest(place[at(i)] - place[at(j)]);
            slope += samples.volume[members[at(j)]] * kernel.slope_over_r(norm(d)) * d;
        });
        slopes[members[at(i)]] = slope;
    });
}

}  // namespace

std::vector<Vec3> solid_slopes(const SampleSet& samples, const body::Motion& motion,
                               std::span<const std::uint8_t> is_still, const fluid::WendlandC2& kernel, double reach,
                               const fluid::Domain& domain) {
    std::vector<Vec3> slopes(at(samples.size()));
    fluid::Domain open;
    open.dimension = domain.dimension;
    std::vector<std::size_t> members, still;
    std::vector<Vec3> place;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
        const BodyId body = samples.body[i];
        if (is_still[at(body.value)] != 0) {
            still.push_back(i);
            continue;
        }
        members.push_back(i);
        place.push_back(samples.anchor[i]);
        if (i + 1 == slopes.size() || samples.body[i + 1] != body) {
            find_slopes(samples, members, place, kernel, reach, open, slopes);
            members.clear();
            place.clear();
        }
    }
    for (const std::size_t i : still) {
        const Pose& pose = motion.pose[at(samples.body[i].value)];
        place.push_back(pose.position + rotate(pose.orientation, samples.anchor[i]));
    }
    find_slopes(samples, still, place, kernel, reach, domain, slopes);
    return slopes;
}

}  // namespace riprap::coupling
