// SPDX-License-Identifier: Apache-2.0
#include "riprap/view/pack_water.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace riprap::view {

namespace {

constexpr double finest_step = 1.0 / 32;   // of the spacing
constexpr double coarsest_step = 1.0 / 2;  // of the spacing: then a particle is at most a quarter of it out of place
constexpr std::size_t most_drawn = 1'000'000;   // particles that a laptop can still draw
constexpr std::size_t values_per_frame = 4000;  // looked at for the bounds of colours
constexpr double outliers = 0.002;              // share of the values beyond each bound

/// Every frame, once, for bounds.
struct Bounds {
    Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    std::vector<float> pressure, speed;
    std::array<std::vector<float>, 3> place;  // [m], along each axis
    std::size_t most_particles{0};
    std::size_t not_numbers{0};  ///< pressures and speeds that bound nothing

    void add(const WaterFrame& frame) {
        most_particles = std::max(most_particles, frame.id.size());
        for (const Vec3& x : frame.position) {
            low = min(low, x);
            high = max(high, x);
        }
        const std::size_t stride = frame.id.size() / values_per_frame + 1;
        for (std::size_t i = 0; i < frame.position.size(); i += stride) {
            const Vec3& x = frame.position[i];
            place[0].push_back(static_cast<float>(x.x));
            place[1].push_back(static_cast<float>(x.y));
            place[2].push_back(static_cast<float>(x.z));
        }
        note(frame.pressure, stride, pressure);
        note(frame.speed, stride, speed);
    }

 private:
    void note(const std::vector<float>& values, std::size_t stride, std::vector<float>& noted) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (!std::isfinite(values[i])) {
                ++not_numbers;
            } else if (i % stride == 0) {
                noted.push_back(values[i]);
            }
        }
    }
};

double quantile(std::vector<float>& values, double share) {
    if (values.empty()) {
        return 0;
    }
    const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + k, values.end());
    return static_cast<double>(values[static_cast<std::size_t>(k)]);
}

/// In the order of ids, every stride-th id.
WaterFrame sorted(const WaterFrame& frame, std::size_t stride) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < frame.id.size(); ++i) {
        if (static_cast<std::size_t>(frame.id[i]) % stride == 0) {
            order.push_back(i);
        }
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return frame.id[a] < frame.id[b]; });
    WaterFrame out;
    for (const std::size_t i : order) {
        out.id.push_back(frame.id[i]);
        out.position.push_back(frame.position[i]);
        out.pressure.push_back(frame.pressure[i]);
        out.speed.push_back(frame.speed[i]);
    }
    return out;
}

std::string pack_group(const WaterSource& source, std::size_t begin, std::size_t end, const WaterScale& scale,
                       std::size_t stride) {
    std::vector<WaterNumbers> numbers;
    for (std::size_t f = begin; f < end; ++f) {
        numbers.push_back(to_numbers(sorted(source(f), stride), scale));
    }
    return encode_group(numbers);
}

/// Frames of a group: a page unpacks a group whole before it shows the first frame of it.
std::size_t group_frames_of(std::size_t particles) {
    constexpr std::size_t unpacked_at_once = 1'000'000;  // of particles, in all frames of a group
    return std::clamp(unpacked_at_once / std::max<std::size_t>(particles, 1), fewest_group_frames, frames_per_group);
}

/// All groups, or as many as fit into the budget.
bool pack_groups(const WaterSource& source, std::size_t frame_count, std::size_t budget, PackedWater& water) {
    water.groups.clear();
    std::size_t bytes = 0;
    for (std::size_t begin = 0; begin < frame_count; begin += water.group_frames) {
        water.groups.push_back(
            pack_group(source, begin, std::min(begin + water.group_frames, frame_count), water.scale, water.stride));
        bytes += water.groups.back().size();
        if (bytes > budget) {
            return false;
        }
    }
    return true;
}

/// Tells whether the group in the middle promises that all of them fit: a cheap answer before an expensive one.
bool may_fit(const WaterSource& source, std::size_t frame_count, std::size_t budget, const PackedWater& water) {
    const std::size_t groups = (frame_count + water.group_frames - 1) / water.group_frames;
    const std::size_t begin = groups / 2 * water.group_frames;
    const std::size_t end = std::min(begin + water.group_frames, frame_count);
    const std::size_t sample = pack_group(source, begin, end, water.scale, water.stride).size();
    return sample * frame_count / (end - begin) <= budget;
}

}  // namespace

std::size_t PackedWater::bytes() const {
    return std::accumulate(groups.begin(), groups.end(), std::size_t{0},
                           [](std::size_t sum, const std::string& group) { return sum + group.size(); });
}

PackedWater pack_water(const WaterSource& source, std::size_t frame_count, double spacing, std::size_t budget) {
    Bounds bounds;
    for (std::size_t f = 0; f < frame_count; ++f) {
        bounds.add(source(f));
    }
    PackedWater water;
    if (bounds.most_particles == 0) {
        return water;
    }
    water.not_numbers = bounds.not_numbers;
    const Vec3 size = bounds.high - bounds.low;
    const double extent = std::max({size.x, size.y, size.z});
    water.stride = (bounds.most_particles + most_drawn - 1) / most_drawn;
    water.scale.origin = bounds.low;
    const auto typical = [&bounds](double share) {
        return Vec3{quantile(bounds.place[0], share), quantile(bounds.place[1], share),
                    quantile(bounds.place[2], share)};
    };
    water.low = typical(outliers);
    water.high = typical(1 - outliers);
    water.scale.pressure_low = std::min(0.0, quantile(bounds.pressure, outliers));
    water.scale.pressure_high = std::max(quantile(bounds.pressure, 1 - outliers), water.scale.pressure_low + 1e-9);
    water.scale.speed_high = std::max(quantile(bounds.speed, 1 - outliers), 1e-9);
    // Without a spacing, or with one that says nothing: a grain that the eye cannot see.
    double wanted = spacing > 0 ? finest_step * spacing : extent / 4096;
    const double coarsest = wanted * coarsest_step / finest_step;
    while (true) {
        water.group_frames = group_frames_of(bounds.most_particles / water.stride);
        const bool is_short = frame_count <= 2 * water.group_frames;
        // A scene without extent needs a step as well.
        water.scale.step = std::max(coordinate_step(extent, wanted), std::numeric_limits<double>::min());
        const bool promises = is_short || may_fit(source, frame_count, budget, water);
        if (promises && pack_groups(source, frame_count, budget, water)) {
            break;
        }
        if (wanted < coarsest && 2 * wanted <= coarsest) {  // doubling moves neither 0 nor infinity
            wanted *= 2;
        } else if (water.stride < bounds.most_particles) {
            water.stride *= 2;
        } else {  // one particle is left: nothing more can be saved
            pack_groups(source, frame_count, std::numeric_limits<std::size_t>::max(), water);
            break;
        }
    }
    water.most_particles = (bounds.most_particles + water.stride - 1) / water.stride;
    return water;
}

}  // namespace riprap::view
