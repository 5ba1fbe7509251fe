// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/cluster_list.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/cell_grid.hpp"

namespace riprap::fluid {

// --- places
// ------------------------------------------------------------------------------------------------------------

double ClusterPlaces::update(std::span<const Vec3> position, const FixedPoint& fixed, int dimension) {
    size_ = static_cast<std::int64_t>(position.size());
    stride_ = static_cast<std::int64_t>(dimension) * cluster_size;
    fixed_ = fixed;
    places_.resize(static_cast<std::size_t>(cluster_count() * stride_));
    parallel::for_each(cluster_count(), [&](std::int64_t c) {
        std::int32_t* place = &places_[static_cast<std::size_t>(c * stride_)];
        for (std::int64_t member = 0; member < cluster_size; ++member) {
            const Vec3& x = position[static_cast<std::size_t>(std::min(c * cluster_size + member, size_ - 1))];
            for (int axis = 0; axis < dimension; ++axis) {
                place[axis * cluster_size + member] = fixed(x, axis);
            }
        }
    });
    if (remembered_.size() != places_.size() || remembered_fixed_ != fixed_) {
        return std::numeric_limits<double>::infinity();
    }
    return parallel::reduce(
        cluster_count(), 0.0,
        [&](std::int64_t c) {
            double farthest = 0;
            for (std::int64_t member = 0; member < cluster_size; ++member) {
                double square = 0;
                for (int axis = 0; axis < dimension; ++axis) {
                    const auto k = static_cast<std::size_t>(c * stride_ + axis * cluster_size + member);
                    const auto moved = static_cast<std::int32_t>(static_cast<std::uint32_t>(places_[k]) -
                                                                 static_cast<std::uint32_t>(remembered_[k]));
                    const double length = fixed_.quantum()[axis] * moved;
                    square += length * length;
                }
                farthest = std::max(farthest, square);
            }
            return farthest;
        },
        [](double a, double b) { return std::max(a, b); });
}

void ClusterPlaces::remember() {
    remembered_ = places_;
    remembered_fixed_ = fixed_;
}

// --- boxes
// -------------------------------------------------------------------------------------------------------------

namespace {

/// A box while it grows: low and high relative to a first point, so that boxes across a periodic side stay small.
struct GrowingBox {
    Vec3 base{}, low{}, high{};
    bool is_empty{true};

    void include(const Vec3& lowest, const Vec3& highest, const NearestImage& nearest) {
        const Vec3 centre = 0.5 * (lowest + highest);
        const Vec3 half = 0.5 * (highest - lowest);
        if (is_empty) {
            base = centre;
            low = -half;
            high = half;
            is_empty = false;
            return;
        }
        const Vec3 d = nearest(centre - base);
        low = min(low, d - half);
        high = max(high, d + half);
    }
};

}  // namespace

void BoxTree::build(std::span<const Vec3> position, const Domain& domain) {
    const NearestImage nearest(domain);
    const auto n = static_cast<std::int64_t>(position.size());
    std::int64_t count = (n + cluster_size - 1) / cluster_size;
    levels_.clear();
    if (count == 0) {
        return;
    }
    double largest = 0;
    Vec3 periods;
    for (int axis = 0; axis < 3; ++axis) {
        const bool is_periodic = axis < domain.dimension && domain.is_periodic[static_cast<std::size_t>(axis)];
        const double period = is_periodic ? domain.high[axis] - domain.low[axis] : 0;
        period_[static_cast<std::size_t>(axis)] = static_cast<float>(period);
        periods[axis] = period;
    }
    std::vector<GrowingBox> boxes(static_cast<std::size_t>(count));
    parallel::for_each(count, [&](std::int64_t c) {
        for (std::int64_t i = c * cluster_size; i < std::min(n, (c + 1) * cluster_size); ++i) {
            Vec3 x = position[static_cast<std::size_t>(i)] - domain.low;
            for (int axis = 0; axis < 3; ++axis) {
                const double period = periods[axis];
                x[axis] = axis >= domain.dimension ? 0
                          : period > 0             ? x[axis] - period * std::floor(x[axis] / period)
                                                   : x[axis];
            }
            if (is_finite(x)) {
                boxes[static_cast<std::size_t>(c)].include(x, x, nearest);
            }
        }
    });
    for (;;) {
        Level level;
        const std::int64_t blocks = (count + branches - 1) / branches;
        level.centre.assign(static_cast<std::size_t>(3 * blocks), FloatVector{});
        level.half.assign(static_cast<std::size_t>(3 * blocks), FloatVector{} - 1e30F);  // nothing is near
        for (std::int64_t b = 0; b < count; ++b) {
            const GrowingBox& box = boxes[static_cast<std::size_t>(b)];
            for (int axis = 0; axis < 3 && !box.is_empty; ++axis) {
                const auto k = static_cast<std::size_t>(3 * (b / branches) + axis);
                const double centre = box.base[axis] + 0.5 * (box.low[axis] + box.high[axis]);
                level.centre[k][b % branches] = static_cast<float>(centre);
                level.half[k][b % branches] = static_cast<float>(0.5 * (box.high[axis] - box.low[axis]));
                largest = std::max({largest, std::abs(centre), box.high[axis] - box.low[axis]});
            }
        }
        levels_.push_back(std::move(level));
        if (blocks == 1) {
            break;
        }
        std::vector<GrowingBox> parents(static_cast<std::size_t>(blocks));
        parallel::for_each(blocks, [&](std::int64_t p) {
            for (std::int64_t b = p * branches; b < std::min(count, (p + 1) * branches); ++b) {
                const GrowingBox& child = boxes[static_cast<std::size_t>(b)];
                if (!child.is_empty) {
                    parents[static_cast<std::size_t>(p)].include(child.base + child.low, child.base + child.high,
                                                                 nearest);
                }
            }
        });
        boxes.swap(parents);
        count = blocks;
    }
    slack_ = static_cast<float>(largest * 0x1p-20);
}

BoxTree::Box BoxTree::box(std::int64_t cluster) const {
    Box box{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(3 * (cluster / branches)) + axis;
        box.centre[axis] = levels_[0].centre[k][cluster % branches];
        box.half[axis] = levels_[0].half[k][cluster % branches];
    }
    return box;
}

std::uint32_t BoxTree::near(const Level& level, std::int64_t block, const Box& box, float distance) const {
    Lanes square(0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(3 * block) + axis;
        const Lanes d = Lanes(level.centre[k]) - Lanes(box.centre[axis]);
        Lanes apart = max(d, -d);
        if (period_[axis] > 0) {
            // centres lie in the period or half a box outside, so less than two periods apart
            for (int turn = 0; turn < 2; ++turn) {
                const Lanes other = apart - Lanes(period_[axis]);
                apart = min(apart, max(other, -other));
            }
        }
        const Lanes gap = max(apart - Lanes(level.half[k]) - Lanes(box.half[axis]), Lanes(0));
        square += gap * gap;
    }
    return bits_below(square, distance * distance);
}

// --- lists
// -------------------------------------------------------------------------------------------------------------

namespace {

/// The places of a target cluster in lanes.
struct TargetPlaces {
    std::array<IntVector, 3> places;
    std::array<Lanes, 3> quantum;
    int dimension;

    TargetPlaces(const std::int32_t* four, const FixedPoint& fixed, int dim) : dimension(dim) {
        for (int axis = 0; axis < dimension; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            places[k] = targets_in_lanes(four + static_cast<std::ptrdiff_t>(axis) * cluster_size);
            quantum[k] = Lanes(fixed.quantum()[axis]);
        }
    }
    bool has_pair_within(const std::int32_t* candidates, float distance) const {
        Lanes square(0);
        for (int axis = 0; axis < dimension; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            const Lanes d = difference(places[k], candidates_in_lanes(candidates + static_cast<std::ptrdiff_t>(axis) *
                                                                                       cluster_size)) *
                            quantum[k];
            square += d * d;
        }
        return bits_below(square, distance * distance) != 0;
    }
};

}  // namespace

void ClusterList::update(const SweepReach& reach, std::span<const Vec3> targets, std::span<const Vec3> candidates) {
    check_periods(reach.domain, reach.support_radius);
    const bool was_same = is_same_;
    is_same_ = targets.data() == candidates.data() && targets.size() == candidates.size();
    riprap::fluid::Box box = box_of(targets);
    if (!is_same_) {
        const riprap::fluid::Box other = box_of(candidates);
        box = {min(box.low, other.low), max(box.high, other.high)};
    }
    fixed_ = FixedPoint(reach, max(box.high - box.low, Vec3{}));
    const int dimension = reach.domain.dimension;
    const double moved = std::sqrt(targets_.update(targets, fixed_, dimension)) +
                         (is_same_ ? 0 : std::sqrt(candidates_.update(candidates, fixed_, dimension)));
    ++sweeps_;
    const double both_moved = is_same_ ? 2 * moved : moved;
    if (is_complete_ && was_same == is_same_ && both_moved <= skin_) {
        return;
    }
    choose_skin(reach.support_radius, both_moved);
    build(reach, targets, candidates);
}

void ClusterList::choose_skin(double support_radius, double moved) {
    // A skin s makes a sweep dearer by 3 s/(2 h + 1) of it and lets it last s/u sweeps at a motion of u per sweep until
    // the lists, which cost about half a sweep, are made anew: least in sum at s^2 = u (2 h)/6.
    constexpr double least = 0.01, most = 0.12;
    const double per_sweep =
        std::isfinite(moved) ? moved / static_cast<double>(std::max<std::int64_t>(1, sweeps_)) : 0.005 * support_radius;
    skin_ = std::clamp(std::sqrt(per_sweep * support_radius / 6), least * support_radius, most * support_radius);
}

void ClusterList::build(const SweepReach& reach, std::span<const Vec3> targets, std::span<const Vec3> candidates) {
    const int dimension = reach.domain.dimension;
    candidate_boxes_.build(candidates, reach.domain);
    if (!is_same_) {
        target_boxes_.build(targets, reach.domain);
    }
    const BoxTree& boxes = is_same_ ? candidate_boxes_ : target_boxes_;
    const double fixed_slack = 4 * std::max({fixed_.quantum().x, fixed_.quantum().y, fixed_.quantum().z});
    const auto distance = static_cast<float>((reach.support_radius + skin_) * (1 + 1e-5) + fixed_slack);
    const float box_distance = distance + boxes.slack() + candidate_boxes_.slack();
    chunks_.resize(static_cast<std::size_t>(chunk_count()));
    parallel::for_each_uneven(chunk_count(), 1, [&](std::int64_t k) {
        Chunk& chunk = chunks_[static_cast<std::size_t>(k)];
        chunk.candidates.clear();
        chunk.start.fill(0);
        const std::int64_t first = k * chunk_size;
        for (std::int64_t local = 0; local < chunk_size; ++local) {
            const std::int64_t t = first + local;
            if (t < targets_.cluster_count()) {
                const TargetPlaces here(targets_.cluster(t), fixed_, dimension);
                candidate_boxes_.for_each_near(boxes.box(t), box_distance, [&](std::int64_t c) {
                    if (here.has_pair_within(this->candidates().cluster(c), distance)) {
                        chunk.candidates.push_back(static_cast<std::int32_t>(c));
                    }
                });
            }
            chunk.start[static_cast<std::size_t>(local) + 1] = static_cast<std::int32_t>(chunk.candidates.size());
        }
    });
    targets_.remember();
    if (!is_same_) {
        candidates_.remember();
    }
    is_complete_ = true;
    sweeps_ = 0;
    ++builds_;
}

std::int64_t ClusterList::cluster_pairs() const {
    std::int64_t pairs = 0;
    for (const Chunk& chunk : chunks_) {
        pairs += static_cast<std::int64_t>(chunk.candidates.size());
    }
    return pairs;
}

}  // namespace riprap::fluid
