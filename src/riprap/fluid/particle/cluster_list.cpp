// SPDX-License-Identifier: Apache-2.0
#include "riprap/fluid/particle/cluster_list.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/cell_grid.hpp"

namespace riprap::fluid {

// --- places
// ------------------------------------------------------------------------------------------------------------

namespace {

using LongFour [[gnu::vector_size(sizeof(DoubleFour))]] = std::int64_t;

/// Four particles, x y z x y z x y z x y z, as whole numbers: x x x x, y y y y, z z z z.
struct FourPlaces {
    std::array<DoubleFour, 3> origin, per_quantum;

    explicit FourPlaces(const FixedPoint& fixed) {
        for (int k = 0; k < 12; ++k) {
            origin[static_cast<std::size_t>(k / 4)][k % 4] = fixed.origin()[k % 3];
            per_quantum[static_cast<std::size_t>(k / 4)][k % 4] = fixed.per_quantum()[k % 3];
        }
    }
    std::array<IntFour, 3> operator()(const Vec3* four) const {
        std::array<IntFour, 3> v;
        for (std::size_t k = 0; k < 3; ++k) {
            DoubleFour x;
            std::memcpy(&x, reinterpret_cast<const char*>(four) + k * sizeof x, sizeof x);
            // What is added puts the unit into the last place of the mantissa, so that its low bits are the whole
            // number in two's complement, modulo 2^32. Places beyond 2^51 small lengths, and not finite ones, are
            // anywhere.
            const DoubleFour rounded = (x - origin[k]) * per_quantum[k] + 0x1.8p52;
            v[k] = __builtin_convertvector(reinterpret_cast<LongFour>(rounded), IntFour);
        }
        const IntFour x = __builtin_shufflevector(v[0], v[1], 0, 3, 6, 6),
                      y = __builtin_shufflevector(v[0], v[1], 1, 4, 7, 7),
                      z = __builtin_shufflevector(v[0], v[1], 2, 5, 5, 5);
        return {__builtin_shufflevector(x, v[2], 0, 1, 2, 5), __builtin_shufflevector(y, v[2], 0, 1, 2, 6),
                __builtin_shufflevector(z, v[2], 0, 1, 4, 7)};
    }
};

using Motion = ClusterPlaces::Motion;

Motion join(Motion a, Motion b) { return a < b ? a : b; }

const Motion no_motion = Motion{} + std::numeric_limits<float>::infinity();

/// The most by which a particle of one set and one of the other may have come closer [m].
float approach(Motion a, Motion b) {
    float square = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float most = std::max(-a[axis + 4] - b[axis], -b[axis + 4] - a[axis]);
        square += most * most;
    }
    return std::sqrt(square);
}

}  // namespace

template <int Dim>
ClusterPlaces::Motion ClusterPlaces::place_block(std::span<const Vec3> position, std::int64_t block,
                                                 bool is_comparable) {
    constexpr std::int64_t stride = std::int64_t{Dim} * cluster_size;
    const FourPlaces four_places(fixed_);
    const FloatFour far = FloatFour{} + std::numeric_limits<float>::infinity();
    std::array<FloatFour, Dim> low, high;
    low.fill(far);
    high.fill(-far);
    for (std::int64_t c = block * block_size; c < std::min(cluster_count(), (block + 1) * block_size); ++c) {
        const std::int64_t first = c * cluster_size;
        std::array<IntFour, 3> here;
        if (first + cluster_size <= size_) {
            here = four_places(&position[static_cast<std::size_t>(first)]);
        } else {
            std::array<Vec3, cluster_size> four;
            for (std::int64_t member = 0; member < cluster_size; ++member) {
                four[static_cast<std::size_t>(member)] =
                    position[static_cast<std::size_t>(std::min(first + member, size_ - 1))];
            }
            here = four_places(four.data());
        }
        std::memcpy(&places_[static_cast<std::size_t>(c * stride)], here.data(), stride * sizeof(std::int32_t));
        if (is_comparable) {
            std::array<IntFour, Dim> then;
            std::memcpy(then.data(), &remembered_[static_cast<std::size_t>(c * stride)], sizeof then);
            for (std::size_t axis = 0; axis < Dim; ++axis) {
                const FloatFour way =
                    difference(here[axis], then[axis]) * static_cast<float>(fixed_.quantum()[static_cast<int>(axis)]);
                low[axis] = way < low[axis] ? way : low[axis];
                high[axis] = way > high[axis] ? way : high[axis];
            }
        }
    }
    Motion motion{};
    for (int axis = 0; axis < Dim; ++axis) {
        const FloatFour l = low[static_cast<std::size_t>(axis)], h = high[static_cast<std::size_t>(axis)];
        motion[axis] = std::min({l[0], l[1], l[2], l[3]});
        motion[axis + 4] = -std::max({h[0], h[1], h[2], h[3]});
    }
    return motion;
}

void ClusterPlaces::update(std::span<const Vec3> position, const FixedPoint& fixed, int dimension) {
    size_ = static_cast<std::int64_t>(position.size());
    fixed_ = fixed;
    stride_ = static_cast<std::int64_t>(dimension) * cluster_size;
    places_.resize(static_cast<std::size_t>(cluster_count() * stride_));
    is_motion_known_ = remembered_.size() == places_.size() && remembered_fixed_ == fixed_;
    const std::int64_t blocks = (cluster_count() + block_size - 1) / block_size;
    motions_.resize(static_cast<std::size_t>(blocks));
    parallel::for_each_uneven(blocks, 16, [&](std::int64_t b) {
        motions_[static_cast<std::size_t>(b)] = dimension == 2 ? place_block<2>(position, b, is_motion_known_)
                                                               : place_block<3>(position, b, is_motion_known_);
    });
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
        const std::int64_t blocks = (count + branches - 1) / branches;
        Block nobody;
        nobody.centre.fill(FloatVector{});
        nobody.half.fill(FloatVector{} - 1e30F);  // near nothing
        std::vector<Block> level(static_cast<std::size_t>(blocks), nobody);
        for (std::int64_t b = 0; b < count; ++b) {
            const GrowingBox& grown = boxes[static_cast<std::size_t>(b)];
            Block& block = level[static_cast<std::size_t>(b / branches)];
            for (int axis = 0; axis < 3 && !grown.is_empty; ++axis) {
                const auto k = static_cast<std::size_t>(axis);
                const double centre = grown.base[axis] + 0.5 * (grown.low[axis] + grown.high[axis]);
                block.centre[k][b % branches] = static_cast<float>(centre);
                block.half[k][b % branches] = static_cast<float>(0.5 * (grown.high[axis] - grown.low[axis]));
                largest = std::max({largest, std::abs(centre), grown.high[axis] - grown.low[axis]});
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

BoxTree::Box BoxTree::box(std::size_t level, std::int64_t entry) const {
    const Block& block = levels_[level][static_cast<std::size_t>(entry / branches)];
    Box box{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.centre[axis] = block.centre[axis][entry % branches];
        box.half[axis] = block.half[axis][entry % branches];
    }
    return box;
}

BoxTree::Box BoxTree::box_of_block(std::int64_t block) const {
    if (levels_.size() > 1) {
        return box(1, block);
    }
    return {{}, {1e30F, 1e30F, 1e30F}};  // the only block: everything is near
}

void BoxTree::find_blocks(const Box& box, float distance, std::vector<std::int32_t>& found) const {
    if (levels_.size() > 1) {
        visit(levels_.size() - 1, 0, box, distance, found);
    } else if (!levels_.empty()) {
        found.push_back(0);
    }
}

void BoxTree::visit(std::size_t level, std::int64_t block, const Box& box, float distance,
                    std::vector<std::int32_t>& found) const {
    std::uint32_t hits = near(levels_[level][static_cast<std::size_t>(block)], box, distance);
    for (; hits != 0; hits &= hits - 1) {
        const std::int64_t entry = block * branches + __builtin_ctz(hits);
        if (level == 1) {
            found.push_back(static_cast<std::int32_t>(entry));
        } else {
            visit(level - 1, entry, box, distance, found);
        }
    }
}

std::uint32_t BoxTree::near(const Block& block, const Box& box, float distance) const {
    Lanes square(0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Lanes d = Lanes(block.centre[axis]) - Lanes(box.centre[axis]);
        Lanes apart = max(d, -d);
        if (period_[axis] > 0) {
            // centres lie in the period or half a box outside, so less than two periods apart
            for (int turn = 0; turn < 2; ++turn) {
                const Lanes other = apart - Lanes(period_[axis]);
                apart = min(apart, max(other, -other));
            }
        }
        const Lanes gap = max(apart - Lanes(block.half[axis]) - Lanes(box.half[axis]), Lanes(0));
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
    bool has_pair_within(const std::int32_t* candidates, float within) const {
        Lanes square(0);
        for (int axis = 0; axis < dimension; ++axis) {
            const auto k = static_cast<std::size_t>(axis);
            const Lanes d = difference(places[k], candidates_in_lanes(candidates + static_cast<std::ptrdiff_t>(axis) *
                                                                                       cluster_size)) *
                            quantum[k];
            square += d * d;
        }
        return bits_below(square, within * within) != 0;
    }
};

}  // namespace

namespace {
/// Blocks whose motion is watched lie so many skins farther away than lists reach. What lies beyond them cannot have
/// come within reach as long as nothing anywhere has come closer than by these skins and one more.
constexpr double watched_skins = 4;
}  // namespace

/// Finds what is near clusters of targets, sixteen clusters of targets at a time. No branch depends on a single box:
/// the finds are written one behind the other, and the misses overwritten.
class ClusterList::Search {
 public:
    Search(const ClusterList& list, const BoxTree& targets, int dimension, float distance, float watched)
        : list_(list),
          targets_(targets),
          candidates_(list.candidate_boxes_),
          dimension_(dimension),
          distance_(distance),
          watched_(watched),
          box_distance_(distance + targets.slack() + candidates_.slack()) {}

    void fill(std::int64_t target_block, Chunk& chunk) {
        blocks_.clear();
        candidates_.find_blocks(targets_.box_of_block(target_block), box_distance_ + watched_, blocks_);
        chunk.blocks.assign(blocks_.begin(), blocks_.end());
        block_boxes_.assign((blocks_.size() + BoxTree::branches - 1) / BoxTree::branches, {});
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            const BoxTree::Box box = candidates_.box_of_block(blocks_[b]);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                block_boxes_[b / BoxTree::branches].centre[axis][static_cast<int>(b % BoxTree::branches)] =
                    box.centre[axis];
                block_boxes_[b / BoxTree::branches].half[axis][static_cast<int>(b % BoxTree::branches)] =
                    box.half[axis];
            }
        }
        near_blocks_.resize(blocks_.size() + BoxTree::branches);
        near_clusters_.resize((blocks_.size() + 1) * BoxTree::branches);
        chunk.candidates.clear();
        chunk.start.fill(0);
        const std::int64_t first = target_block * chunk_size;
        const std::int64_t count = std::min(chunk_size, list_.targets_.cluster_count() - first);
        for (std::int64_t local = 0; local < chunk_size; ++local) {
            if (local < count) {
                find(first + local, chunk.candidates);
            }
            chunk.start[static_cast<std::size_t>(local) + 1] = static_cast<std::int32_t>(chunk.candidates.size());
        }
        chunk.candidates.shrink_to_fit();
    }

 private:
    void find(std::int64_t target, std::vector<std::int32_t>& found) {
        const BoxTree::Box box = targets_.box_of_cluster(target);
        IntVector steps;
        for (int lane = 0; lane < lane_count; ++lane) {
            steps[lane] = lane;
        }
        int block_count = 0;
        for (std::size_t k = 0; k < block_boxes_.size(); ++k) {
            const std::size_t here = k * BoxTree::branches;
            const std::size_t rest = std::min<std::size_t>(BoxTree::branches, blocks_.size() - here);
            const std::uint32_t hits = candidates_.near(block_boxes_[k], box, box_distance_) & ((1U << rest) - 1U);
            for (std::uint32_t left = hits; left != 0; left &= left - 1) {
                near_blocks_[static_cast<std::size_t>(block_count++)] =
                    blocks_[here + static_cast<std::size_t>(__builtin_ctz(left))];
            }
        }
        int cluster_count = 0;
        for (int k = 0; k < block_count; ++k) {
            const std::int32_t block = near_blocks_[static_cast<std::size_t>(k)];
            cluster_count += write_selected(candidates_.near(candidates_.clusters_of(block), box, box_distance_),
                                            steps + block * BoxTree::branches,
                                            &near_clusters_[static_cast<std::size_t>(cluster_count)]);
        }
        const TargetPlaces here(list_.targets_.cluster(target), list_.fixed_, dimension_);
        std::size_t size = found.size();
        found.resize(size + static_cast<std::size_t>(cluster_count));
        for (int k = 0; k < cluster_count; ++k) {
            const std::int32_t c = near_clusters_[static_cast<std::size_t>(k)];
            found[size] = c;
            size += here.has_pair_within(list_.candidates().cluster(c), distance_) ? 1 : 0;
        }
        found.resize(size);
    }

    const ClusterList& list_;
    const BoxTree& targets_;
    const BoxTree& candidates_;
    int dimension_;
    float distance_, watched_, box_distance_;
    std::vector<std::int32_t> blocks_, near_blocks_, near_clusters_;
    std::vector<BoxTree::Block> block_boxes_;
};

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
    targets_.update(targets, fixed_, dimension);
    if (!is_same_) {
        candidates_.update(candidates, fixed_, dimension);
    }
    ++sweeps_;
    const bool is_known =
        is_complete_ && was_same == is_same_ && targets_.is_motion_known() && this->candidates().is_motion_known();
    const double in_lists = is_known ? closer_in_lists() : 0, anywhere = is_known ? closer_anywhere() : 0;
    if (is_known && in_lists <= skin_ && anywhere <= (1 + watched_skins) * skin_) {
        return;
    }
    choose_skin(reach.support_radius, is_known ? std::max(in_lists, anywhere / (1 + watched_skins)) : -1);
    build(reach, targets, candidates);
}

float ClusterList::closer_in_lists() const {
    const auto closer = [&](std::int64_t k) {
        const Chunk& chunk = chunks_[static_cast<std::size_t>(k)];
        Motion around = no_motion;
        for (const std::int32_t block : chunk.blocks) {
            around = join(around, candidates().motions()[static_cast<std::size_t>(block)]);
        }
        return chunk.blocks.empty() ? 0.0F : approach(targets_.motions()[static_cast<std::size_t>(k)], around);
    };
    return parallel::reduce(
        chunk_count(), 0.0F, closer, [](float a, float b) { return std::max(a, b); }, 64);
}

float ClusterList::closer_anywhere() const {
    Motion of_targets = no_motion, of_candidates = no_motion;
    for (const Motion& motion : targets_.motions()) {
        of_targets = join(of_targets, motion);
    }
    for (const Motion& motion : candidates().motions()) {
        of_candidates = join(of_candidates, motion);
    }
    return approach(of_targets, of_candidates);
}

/// @param closer  by which particles came closer since the last build [m]; negative: not known
void ClusterList::choose_skin(double support_radius, double closer) {
    // A skin s makes a sweep dearer by 3 s/(2 h + 1) of it and lets it last s/u sweeps at a motion of u per sweep until
    // the lists, which cost about half a sweep, are made anew: least in sum at s^2 = u (2 h)/6.
    constexpr double least = 0.01, most = 0.12;
    const double per_sweep =
        closer >= 0 ? closer / static_cast<double>(std::max<std::int64_t>(1, sweeps_)) : 0.005 * support_radius;
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
    chunks_.resize(static_cast<std::size_t>(chunk_count()));
    parallel::for_ranges(chunk_count(), 16, [&](std::int64_t begin, std::int64_t end) {
        Search search(*this, boxes, dimension, distance, static_cast<float>(watched_skins * skin_));
        for (std::int64_t k = begin; k < end; ++k) {
            search.fill(k, chunks_[static_cast<std::size_t>(k)]);
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
