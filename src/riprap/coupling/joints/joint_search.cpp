// SPDX-License-Identifier: Apache-2.0
#include "riprap/coupling/joints/joint_search.hpp"

#include <algorithm>

#include "riprap/core/error.hpp"
#include "riprap/core/index.hpp"

namespace riprap::coupling {

namespace {

constexpr std::int32_t range_size = 64;  ///< numbers of fours

std::uint8_t lanes_of(const JointFour& four, std::int32_t solid) {
    unsigned lanes = 0;
    for (std::size_t lane = 0; lane < four_size; ++lane) {
        lanes |= four.solid[lane] == solid ? 1U << lane : 0U;
    }
    return static_cast<std::uint8_t>(lanes);
}

/// Bits of the pairs of some samples of both fours.
std::uint32_t pairs_of(std::uint32_t own, std::uint32_t other) {
    std::uint32_t pairs = 0;
    for (std::size_t lane = 0; lane < four_size; ++lane) {
        pairs |= (own >> lane & 1U) != 0 ? other << (four_size * lane) : 0;
    }
    return pairs;
}

/// A find, ascending by solid, own four and other four.
struct Find {
    std::uint64_t key;
    Find(std::int32_t solid, std::size_t own, std::int32_t other, bool may_join)
        : key(static_cast<std::uint64_t>(solid - still_solid) << 40U | static_cast<std::uint64_t>(own) << 33U |
              static_cast<std::uint64_t>(other) << 1U | (may_join ? 1U : 0U)) {}
    std::int32_t solid() const { return static_cast<std::int32_t>(key >> 40U) + still_solid; }
    std::int32_t own() const { return static_cast<std::int32_t>(key >> 33U & 127U); }
    std::int32_t other() const { return static_cast<std::int32_t>(key >> 1U & 0xFFFFFFFFU); }
    bool may_join() const { return (key & 1U) != 0; }
};

/// Makes a unit of the finds of one solid.
void add_unit(const FourRange& range, std::span<const JointFour> fours, std::span<const Find> finds,
              FoundUnits& found) {
    JointUnit unit{
        range.solid,           finds.front().solid(),   -1, static_cast<std::int32_t>(found.slots.size()), 0, 0,
        std::ssize(found.met), std::ssize(found.joined)};
    std::vector<std::int32_t> others;
    others.reserve(finds.size());
    std::int32_t own_before = -1;
    for (const Find& find : finds) {
        others.push_back(find.other());
        if (find.own() != own_before) {
            own_before = find.own();
            const std::int32_t four = range.first + own_before;
            found.slots.push_back({four, -1, -1, lanes_of(fours[at(four)], range.solid)});
            ++unit.own_count;
        }
    }
    std::ranges::sort(others);
    others.erase(std::unique(others.begin(), others.end()), others.end());
    unit.other_count = static_cast<std::int32_t>(others.size());
    for (const std::int32_t four : others) {
        found.slots.push_back({four, -1, -1, lanes_of(fours[at(four)], unit.other_solid)});
    }
    RIPRAP_ASSERT(others.size() < std::size_t{1} << 25U, "an entry has 25 bits for the other four");
    std::uint32_t own = 0;
    own_before = finds.front().own();
    for (const Find& find : finds) {
        own += find.own() != own_before ? 1 : 0;
        own_before = find.own();
        const auto other = static_cast<std::uint32_t>(std::ranges::lower_bound(others, find.other()) - others.begin());
        const JointEntry entry{own << 25U | other};
        found.met.push_back(entry);
        if (find.may_join()) {
            found.joined.push_back(entry);
        }
    }
    found.units.push_back(unit);
}

}  // namespace

std::vector<FourRange> ranges_of_fours(std::span<const JointFour> fours) {
    std::vector<FourRange> ranges;
    std::int32_t block = -1;
    for (std::size_t k = 0; k < fours.size(); ++k) {
        for (std::size_t lane = 0; lane < four_size; ++lane) {
            const std::int32_t solid = fours[k].solid[lane];
            if (solid < 0) {
                continue;
            }
            if (ranges.empty() || ranges.back().solid != solid || block != fours[k].number / range_size) {
                ranges.push_back({solid, static_cast<std::int32_t>(k), 0});
                block = fours[k].number / range_size;
            }
            ranges.back().last = static_cast<std::int32_t>(k);
        }
    }
    return ranges;
}

void JointSearch::find(const FourRange& range, FoundUnits& found) const {
    using fluid::BoxTree;
    std::array<Sixteen<float>, 3> quantum;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        quantum[axis] = Sixteen<float>(fixed_.quantum()[static_cast<int>(axis)]);
    }
    const float distance = reach_.met + boxes_.slack();
    std::vector<std::int32_t> blocks;
    std::vector<Find> finds;
    for (std::int32_t own = range.first; own <= range.last; ++own) {
        const PlacedFour<float>& here = placed_[at(own)];
        const std::uint32_t own_lanes = lanes_of(fours_[at(own)], range.solid);
        std::array<fluid::IntLanes, 3> place;
        std::array<Sixteen<float>, 3> normal;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            place[axis] = fluid::targets_in_lanes(here.place[axis].data());
            normal[axis] = own_in_lanes<float>(here.normal[axis]);
        }
        const auto look_at = [&](std::int32_t other) {
            const JointFour& there = fours_[at(other)];
            const auto is_lower = [&](std::int32_t solid) { return solid != no_solid && solid < range.solid; };
            if (std::ranges::none_of(there.solid, is_lower)) {
                return;
            }
            Sixteen<float> square(0), cosine(0);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const fluid::IntLanes at_other = fluid::candidates_in_lanes(placed_[at(other)].place[axis].data());
                const Sixteen<float> d = fluid::difference(place[axis], at_other) * quantum[axis];
                square += d * d;
                cosine += normal[axis] * others_in_lanes<float>(placed_[at(other)].normal[axis]);
            }
            const std::uint32_t met = bits_below(square, Sixteen<float>(reach_.met * reach_.met));
            const std::uint32_t joined = bits_below(square, Sixteen<float>(reach_.joined * reach_.joined)) |
                                         bits_below(cosine, Sixteen<float>(reach_.facing));
            for (std::size_t lane = 0; lane < four_size; ++lane) {
                const std::int32_t solid = there.solid[lane];
                if (!is_lower(solid) ||
                    std::find(there.solid.begin(), there.solid.begin() + lane, solid) != there.solid.begin() + lane) {
                    continue;
                }
                const std::uint32_t pairs = met & pairs_of(own_lanes, lanes_of(there, solid));
                if (pairs != 0) {
                    finds.emplace_back(solid, at(own - range.first), other, (pairs & joined) != 0);
                }
            }
        };
        const BoxTree::Box box = boxes_.box_of_cluster(own);
        blocks.clear();
        boxes_.find_blocks(box, distance, blocks);
        for (const std::int32_t block : blocks) {
            std::uint32_t near = boxes_.near(boxes_.clusters_of(block), box, distance);
            for (; near != 0; near &= near - 1) {
                look_at(block * BoxTree::branches + __builtin_ctz(near));
            }
        }
    }
    std::ranges::sort(finds, {}, &Find::key);
    for (std::size_t begin = 0, end = 0; begin < finds.size(); begin = end) {
        while (end < finds.size() && finds[end].solid() == finds[begin].solid()) {
            ++end;
        }
        add_unit(range, fours_, std::span(finds).subspan(begin, end - begin), found);
    }
}

}  // namespace riprap::coupling
