// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/particle_walls/near_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"

namespace riprap::coupling {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::int64_t part_grain = 32;
/// Share of the distance that round-off of places can be, at most.
constexpr double slack = 1e-6;

}  // namespace

void NearParts::build_tree(std::span<const Vec3> particles) {
    const auto size = static_cast<std::int64_t>(particles.size());
    std::int64_t count = (size + block_size - 1) / block_size;
    levels_.resize(1);
    levels_[0].resize(at(count));
    parallel::for_each_uneven(count, 16, [&](std::int64_t b) {
        Bounds box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
        for (std::int64_t i = b * block_size; i < std::min(size, (b + 1) * block_size); ++i) {
            box.low = min(particles[at(i)], box.low);
            box.high = max(particles[at(i)], box.high);
        }
        levels_[0][at(b)] = box;
    });
    for (std::size_t level = 0; count > 1; ++level) {
        const std::vector<Bounds>& below = levels_[level];
        std::vector<Bounds> above;
        for (std::int64_t first = 0; first < count; first += branches) {
            Bounds box = below[at(first)];
            for (std::int64_t k = first + 1; k < std::min(count, first + branches); ++k) {
                box = {min(below[at(k)].low, box.low), max(below[at(k)].high, box.high)};
            }
            above.push_back(box);
        }
        count = static_cast<std::int64_t>(above.size());
        levels_.push_back(std::move(above));
    }
}

/// Tells whether some face plane has the whole box in front of it, farther than the distance.
bool NearParts::is_beyond_a_face(const PlacedPart& part, const Vec3& centre, const Vec3& half) const {
    for (std::int32_t j = 0; j < part.shape.face_count; ++j) {
        const Vec3 n = rotate(part.pose.orientation, part.shape.normal(j));
        double least = dot(n, centre - part.pose.position) - part.shape.offset[j];
        for (int axis = 0; axis < 3; ++axis) {
            const double along = std::abs(n[axis]);
            // Images stand a period apart: a plane across them is in front of none.
            least -= period_[axis] == 0 ? along * half[axis] : along > 1e-12 ? infinity : 0;
        }
        if (least > (1 + slack) * within_) {
            return true;
        }
    }
    return false;
}

bool NearParts::may_touch(const PlacedPart& part, const Bounds& box, bool is_block) const {
    if (!(part.reach >= 0)) {
        return false;
    }
    const Vec3 centre = 0.5 * (box.low + box.high), half = 0.5 * (box.high - box.low);
    double square = 0;
    for (int axis = 0; axis < 3 && std::isfinite(part.reach); ++axis) {
        double apart = part.pose.position[axis] - centre[axis];
        apart -= period_[axis] > 0 ? period_[axis] * std::round(apart / period_[axis]) : 0;
        const double gap = std::max(0.0, std::abs(apart) - half[axis]);
        square += gap * gap;
    }
    const double most = part.reach + slack * within_;
    if (square > most * most) {
        return false;
    }
    // Faces tell more only of what is large beside the box.
    const bool is_large = !(part.reach < 4 * norm(half));
    return !is_large || !(is_block || std::isinf(part.reach)) || !is_beyond_a_face(part, centre, half);
}

void NearParts::visit(const PlacedPart& part, std::size_t level, std::int64_t entry,
                      std::vector<std::int32_t>& hits) const {
    if (!may_touch(part, levels_[level][at(entry)], level == 0)) {
        return;
    }
    if (level == 0) {
        hits.push_back(static_cast<std::int32_t>(entry));
        return;
    }
    const auto below = static_cast<std::int64_t>(levels_[level - 1].size());
    for (std::int64_t k = entry * branches; k < std::min(below, (entry + 1) * branches); ++k) {
        visit(part, level - 1, k, hits);
    }
}

void NearParts::find(std::span<const PlacedPart> parts, std::span<const Vec3> particles, const fluid::Domain& domain,
                     double within) {
    within_ = within;
    for (int axis = 0; axis < 3; ++axis) {
        const bool is_periodic = axis < domain.dimension && domain.is_periodic[at(axis)];
        period_[axis] = is_periodic ? domain.high[axis] - domain.low[axis] : 0;
    }
    build_tree(particles);
    begin_.assign(levels_[0].size() + 1, 0);
    parts_.clear();
    if (levels_[0].empty()) {
        return;
    }
    hits_.resize(std::max(hits_.size(), parts.size()));
    parallel::for_each_uneven(static_cast<std::int64_t>(parts.size()), part_grain, [&](std::int64_t p) {
        hits_[at(p)].clear();
        visit(parts[at(p)], levels_.size() - 1, 0, hits_[at(p)]);
    });
    const std::span found(hits_.data(), parts.size());
    for (const std::vector<std::int32_t>& hits : found) {
        for (const std::int32_t block : hits) {
            ++begin_[at(block) + 1];
        }
    }
    for (std::size_t b = 1; b < begin_.size(); ++b) {
        begin_[b] += begin_[b - 1];
    }
    parts_.resize(at(begin_.back()));
    std::vector<std::int64_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t p = 0; p < found.size(); ++p) {
        for (const std::int32_t block : found[p]) {
            parts_[at(next[at(block)]++)] = static_cast<std::int32_t>(p);
        }
    }
}

}  // namespace riprap::coupling
