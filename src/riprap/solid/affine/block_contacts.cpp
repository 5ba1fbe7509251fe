// SPDX-License-Identifier: Apache-2.0
#include "riprap/solid/affine/block_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "riprap/contact/narrowphase/hull_size.hpp"
#include "riprap/core/index.hpp"
#include "riprap/core/parallel.hpp"
#include "riprap/solid/affine/ground_contacts.hpp"
#include "riprap/solid/affine/layer_plane.hpp"
#include "riprap/solid/affine/renamed_points.hpp"
#include "riprap/solid/affine/round_blocks.hpp"
#include "riprap/solid/affine/seams.hpp"

namespace riprap::solid::affine {

namespace {

constexpr std::int64_t grain = 64;  ///< pairs that one thread works through at a time

std::uint64_t key_of(const contact::PartPair& pair) { return contact::pair_key(pair); }

/// Finds the rows of pairs in the history. Pairs come in its order, so that it walks along instead of bisecting.
class RowsOfPairs {
 public:
    RowsOfPairs(const BlockContactHistory& history, const contact::PartPair& first)
        : pair_(history.pair),
          row_(static_cast<std::size_t>(std::lower_bound(pair_.begin(), pair_.end(), key_of(first)) - pair_.begin())) {}

    /// Begin and end of the rows of a pair that comes after those asked for before.
    std::pair<std::size_t, std::size_t> of(const contact::PartPair& pair) {
        const std::uint64_t key = key_of(pair);
        while (row_ < pair_.size() && pair_[row_] < key) {
            ++row_;
        }
        std::size_t end = row_;
        while (end < pair_.size() && pair_[end] == key) {
            ++end;
        }
        return {std::exchange(row_, end), end};
    }

 private:
    const std::vector<std::uint64_t>& pair_;
    std::size_t row_;
};

/// Half of the thickness of a disc, 0 = a ball [m].
double half_thickness(const BlockSystem& system, const Shape& shape) {
    return system.is_planar && shape.round_radius > 0 ? std::abs(shape.vertices[0].z) : 0;
}

/// Appends the contact points of one pair with ground.
void find_in_ground_pair(const BlockSystem& system, const BlockState& state, const PlacedBlocks& placed,
                         const contact::PartPair& pair, const BlockContactHistory& history, RowsOfPairs& rows,
                         double reach, NearGround& near, std::vector<BlockContact>& found) {
    const bool is_first = system.shape_of(pair.a).is_ground();
    const std::int32_t ground = is_first ? pair.a : pair.b, block = is_first ? pair.b : pair.a;
    const Surface& surface = system.surface_of(pair.a, pair.b);
    const auto [begin, end] = rows.of(pair);
    const contact::PlacedHull hull = placed.hull(system, state, block);
    const Shape& shape = system.shape_of(block);
    find_on_ground(
        {system.shape_of(ground).ground.get(), state.position[at(ground)], rows_at(state.deformation, at(ground)), hull,
         pair, is_first, surface.is_per_area || surface.has_bond(),
         RoundSide{hull, rows_at(state.deformation, at(block)), shape.round_radius}, half_thickness(system, shape)},
        history, begin, end, reach, near, found);
}

/// Appends the contact points of one pair where a block of it is a ball (one) or a disc (two). @returns whether one is
bool find_in_round_pair(const BlockSystem& system, const BlockState& state, const PlacedBlocks& placed,
                        const contact::PartPair& pair, const BlockContactHistory& history, RowsOfPairs& rows,
                        double reach, std::vector<BlockContact>& found) {
    const Shape &of_a = system.shape_of(pair.a), &of_b = system.shape_of(pair.b);
    if (of_a.round_radius == 0 && of_b.round_radius == 0) {
        return false;
    }
    const RoundSide a{placed.hull(system, state, pair.a), rows_at(state.deformation, at(pair.a)), of_a.round_radius};
    const RoundSide b{placed.hull(system, state, pair.b), rows_at(state.deformation, at(pair.b)), of_b.round_radius};
    const auto middle = find_at_ball(pair, a, b, reach);
    if (!middle) {
        return true;
    }
    const double half = std::max(half_thickness(system, of_a), half_thickness(system, of_b));
    const auto [begin, end] = rows.of(pair);
    for (const bool is_far : {false, true}) {
        if (is_far && half == 0) {
            continue;
        }
        BlockContact contact = half > 0 ? at_end_of_disc(*middle, half, is_far) : *middle;
        for (std::size_t row = begin; row < end; ++row) {
            contact.old = history.feature[row] == contact.feature ? static_cast<std::int64_t>(row) : contact.old;
        }
        found.push_back(contact);
    }
    return true;
}

/// Appends the contact points of one pair; remembers in `separating` what keeps it apart.
void find_in_pair(const contact::PartPair& pair, const contact::PlacedHull& a, const contact::PlacedHull& b,
                  const BlockContactHistory& history, RowsOfPairs& rows, double reach, const Seams& seams,
                  Vec3& separating, std::vector<BlockContact>& found) {
    if (norm_squared(separating) > 0 && plane_gap(a, b, separating) > reach) {
        return;
    }
    const auto [begin, end] = rows.of(pair);
    const contact::PlaneFeature before =
        begin < end ? contact::unpack_feature(history.plane[begin]) : contact::PlaneFeature{};
    contact::CommonPlane plane = plane_between(a, b, before, reach);
    if (plane.gap > reach) {
        separating = plane.normal;
        return;
    }
    const double widest = 0.1 * std::min(contact::size_of(a), contact::size_of(b));
    contact::PlaneContacts points;
    // Takes what may close within the reach of a step too, not only what touches now.
    const auto find_points = [&] {
        find_plane_contacts(a, b, plane, std::max(contact_tolerance(a, b, plane), std::min(reach, widest)), points);
    };
    find_points();
    if (seams.open_plane(pair, points, plane)) {
        find_points();
    }
    const std::size_t first = found.size();
    for (int k = 0; k < points.count; ++k) {
        const contact::PlaneContact& point = points.contacts[at(k)];
        if (point.gap > reach) {
            continue;
        }
        BlockContact contact{pair.a,     pair.b,     point.feature, pack(plane.feature), points.normal,
                             point.on_a, point.on_b, point.gap,     point.area,          -1};
        for (std::size_t row = begin; row < end; ++row) {
            if (history.feature[row] == point.feature) {
                contact.old = static_cast<std::int64_t>(row);
            }
        }
        found.push_back(contact);
    }
    const auto own = std::span(found).subspan(first);
    std::sort(own.begin(), own.end(),
              [](const BlockContact& p, const BlockContact& q) { return p.feature < q.feature; });
    carry_renamed(history, begin, end, own);
}

}  // namespace

void BlockContactHistory::clear() {
    pair.clear();
    feature.clear();
    plane.clear();
    normal.clear();
    slip.clear();
    mode.clear();
    is_intact.clear();
    plastic_slip.clear();
    energy.clear();
    bonded.clear();
}

Vec3 turn_with_plane(const Vec3& v, const Vec3& old_normal, const Vec3& normal) {
    const Vec3 axis = cross(old_normal, normal);  // sine times the axis
    const double cosine = dot(old_normal, normal);
    if (cosine < -0.5) {
        return v - dot(v, normal) * normal;  // no shortest rotation worth the name
    }
    return v + cross(axis, v) + (1 / (1 + cosine)) * cross(axis, cross(axis, v));
}

void ContactFinder::find_pairs(const BlockSystem& system, const BlockState& state, const PlacedBlocks& placed,
                               double reach) {
    const auto count = at(system.size());
    if (radius_.size() != count) {
        radius_.assign(count, 0);
        body_.resize(count);
        is_mobile_.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            body_[i] = static_cast<std::int32_t>(i);
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t is_mobile = system.is_fixed[i] == 0 ? 1 : 0;
        if (is_mobile_[i] != is_mobile) {  // a block is released: pairs with what is fixed were left out until now
            is_mobile_[i] = is_mobile;
            cache_ = {};
        }
    }
    parallel::for_each(system.size(), [&](std::int64_t i) {
        double square = 0;
        for (const Vec3& x : placed.hull(system, state, static_cast<std::int32_t>(i)).vertices) {
            square = std::max(square, norm_squared(x - state.position[at(i)]));
        }
        // A radius that stays lets the pairs stay: it grows by a twentieth at a time with the block.
        const double radius = std::sqrt(square) + 0.5 * reach;
        radius_[at(i)] = radius > radius_[at(i)] ? 1.05 * radius : radius_[at(i)];
    });
    const contact::PartBounds bounds{state.position, radius_, body_, is_mobile_};
    const std::int64_t before = cache_.rebuild_count();
    std::vector<double> sizes;
    for (const double r : radius_) {
        if (r > reach) {
            sizes.push_back(r);
        }
    }
    cache_.update(bounds, {}, {0.1 * contact::median_radius(sizes), 2});
    if (cache_.rebuild_count() != before) {
        pairs_.assign(cache_.pairs().begin(), cache_.pairs().end());
        std::erase_if(pairs_, [&](const contact::PartPair& p) {
            return !system.shape_of(p.a).is_convex() || !system.shape_of(p.b).is_convex();
        });
        add_unbounded(system);
        separating_.assign(pairs_.size(), Vec3{});
    }
}

void ContactFinder::add_unbounded(const BlockSystem& system) {
    const std::size_t found = pairs_.size();
    for (std::int32_t plane = 0; plane < system.size(); ++plane) {
        if (system.shape_of(plane).is_convex()) {
            continue;
        }
        for (std::int32_t block = 0; block < system.size(); ++block) {
            if (system.is_fixed[at(block)] == 0 && system.shape_of(block).is_convex()) {
                pairs_.push_back({std::min(plane, block), std::max(plane, block)});
            }
        }
    }
    if (pairs_.size() > found) {
        std::sort(pairs_.begin(), pairs_.end());
    }
    near_.clear();
    near_of_pair_.assign(pairs_.size(), -1);
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
        if (system.shape_of(pairs_[p].a).is_ground() || system.shape_of(pairs_[p].b).is_ground()) {
            near_of_pair_[p] = static_cast<std::int32_t>(near_.size());
            near_.emplace_back();
        }
    }
}

const std::vector<BlockContact>& ContactFinder::find(const BlockSystem& system, const BlockState& state,
                                                     const PlacedBlocks& placed, const BlockContactHistory& history,
                                                     double reach) {
    find_pairs(system, state, placed, reach);
    const std::int64_t count = pair_count();
    chunks_.resize(at((count + grain - 1) / grain));
    const Seams seams(system, state, placed, pairs_, reach);
    parallel::for_ranges(count, grain, [&](std::int64_t begin, std::int64_t end) {
        std::vector<BlockContact>& chunk = chunks_[at(begin / grain)];
        chunk.clear();
        RowsOfPairs rows(history, pairs_[at(begin)]);
        for (std::int64_t p = begin; p < end; ++p) {
            const contact::PartPair pair = pairs_[at(p)];
            if (near_of_pair_[at(p)] >= 0) {
                find_in_ground_pair(system, state, placed, pair, history, rows, reach, near_[at(near_of_pair_[at(p)])],
                                    chunk);
                continue;
            }
            if (system.shape_of(pair.a).is_convex() && system.shape_of(pair.b).is_convex()) {
                const double apart = norm(state.position[at(pair.a)] - state.position[at(pair.b)]);
                if (apart > radius_[at(pair.a)] + radius_[at(pair.b)]) {
                    continue;
                }
            }
            if (find_in_round_pair(system, state, placed, pair, history, rows, reach, chunk)) {
                continue;
            }
            find_in_pair(pair, placed.hull(system, state, pair.a), placed.hull(system, state, pair.b), history, rows,
                         reach, seams, separating_[at(p)], chunk);
        }
    });
    contacts_.clear();
    for (const std::vector<BlockContact>& chunk : chunks_) {
        contacts_.insert(contacts_.end(), chunk.begin(), chunk.end());
    }
    return contacts_;
}

}  // namespace riprap::solid::affine
