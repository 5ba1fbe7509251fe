// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "riprap/geometry/planar/planar_cut.hpp"
#include "riprap/geometry/polyhedra/random_bits.hpp"

namespace riprap::geometry {

namespace {

/// Parts of the line through `point` along the unit vector `along` that lie inside the region, as distances from it.
std::vector<std::pair<double, double>> inside_parts(std::span<const Vec2> region, const Vec2& point,
                                                    const Vec2& along) {
    std::vector<double> cuts;
    for (std::size_t k = 0; k < region.size(); ++k) {
        const Vec2 a = region[k] - point, b = region[(k + 1) % region.size()] - point;
        const double da = cross(along, a), db = cross(along, b);
        if ((da > 0) != (db > 0)) {
            const double t = da / (da - db);
            cuts.push_back(dot(along, a + t * (b - a)));
        }
    }
    std::sort(cuts.begin(), cuts.end());
    std::vector<std::pair<double, double>> parts;
    for (std::size_t k = 0; k + 1 < cuts.size(); k += 2) {
        parts.emplace_back(cuts[k], cuts[k + 1]);
    }
    return parts;
}

}  // namespace

std::vector<PlanarJoint> outline_of(std::span<const Vec2> region, std::int32_t type) {
    std::vector<PlanarJoint> joints;
    for (std::size_t k = 0; k < region.size(); ++k) {
        joints.push_back({region[k], region[(k + 1) % region.size()], type});
    }
    return joints;
}

std::vector<PlanarJoint> traces_of(const PlanarJointSet& set, std::span<const Vec2> region, std::uint64_t seed) {
    const Vec2 along{std::cos(set.dip), std::sin(set.dip)}, across{-along.y, along.x};
    double low = dot(region.front(), across), high = low;
    for (const Vec2& corner : region) {
        low = std::min(low, dot(corner, across));
        high = std::max(high, dot(corner, across));
    }
    std::uint64_t draws = 0;
    const auto draw = [&draws, seed] { return unit_interval(mix_bits(seed, draws++)); };
    std::vector<PlanarJoint> traces;
    double place = set.offset + std::floor((low - set.offset) / set.spacing) * set.spacing;
    for (; place < high; place += set.spacing * (1 + set.spacing_scatter * (2 * draw() - 1))) {
        const Vec2 origin = place * across;
        for (const auto& [begin, end] : inside_parts(region, origin, along)) {
            if (set.length <= 0) {
                traces.push_back({origin + begin * along, origin + end * along, set.type});
                continue;
            }
            const double period = set.length + set.bridge;
            for (double at_trace = begin - draw() * period; at_trace < end; at_trace += period) {
                const double from = std::max(begin, at_trace), to = std::min(end, at_trace + set.length);
                if (to > from) {
                    traces.push_back({origin + from * along, origin + to * along, set.type});
                }
            }
        }
    }
    return traces;
}

}  // namespace riprap::geometry
