// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/mps/mps_neighbours.hpp"

#include <algorithm>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/mps_operators/mps_weight.hpp"

namespace riprap::fluid::mps {

void Neighbours::find(const MpsSettings& settings, std::span<const Vec3> targets, std::span<const Vec3> points,
                      bool is_same) {
    constexpr std::int64_t chunk_size = 256;
    const auto count = static_cast<std::int64_t>(targets.size());
    grid_.build(points, settings.domain, settings.support_radius());
    const NearestImage nearest(settings.domain);
    const MpsWeight weight = settings.weight();
    const double reach_squared = settings.support_radius() * settings.support_radius();
    const bool is_planar = settings.domain.dimension == 2;
    start_.assign(targets.size() + 1, 0);
    chunks_.resize(static_cast<std::size_t>((count + chunk_size - 1) / chunk_size));
    parallel::for_each_uneven(static_cast<std::int64_t>(chunks_.size()), 1, [&](std::int64_t chunk) {
        std::vector<Found>& found = chunks_[static_cast<std::size_t>(chunk)];
        found.clear();
        for (std::int64_t i = chunk * chunk_size; i < std::min(count, (chunk + 1) * chunk_size); ++i) {
            const auto before = static_cast<std::int64_t>(found.size());
            const Vec3 place = targets[static_cast<std::size_t>(i)];
            grid_.for_each_near(place, [&](std::int64_t j) {
                Vec3 d = nearest(place - points[static_cast<std::size_t>(j)]);
                d.z = is_planar ? 0 : d.z;
                const double r2 = norm_squared(d);
                if (r2 < reach_squared && !(is_same && i == j)) {
                    found.push_back({static_cast<std::int32_t>(j), weight.value(r2)});
                }
            });
            std::sort(found.begin() + before, found.end(),
                      [](const Found& a, const Found& b) { return a.index < b.index; });
            start_[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(found.size()) - before;
        }
    });
    const std::int64_t total = parallel::exclusive_scan<std::int64_t>(start_, start_);
    index_.resize(static_cast<std::size_t>(total));
    weight_.resize(static_cast<std::size_t>(total));
    parallel::for_each_uneven(static_cast<std::int64_t>(chunks_.size()), 1, [&](std::int64_t chunk) {
        auto entry = static_cast<std::size_t>(start_[static_cast<std::size_t>(chunk * chunk_size)]);
        for (const Found& found : chunks_[static_cast<std::size_t>(chunk)]) {
            index_[entry] = found.index;
            weight_[entry++] = found.weight;
        }
    });
}

}  // namespace riprap::fluid::mps
