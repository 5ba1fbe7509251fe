// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/broadphase/multilevel_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "riprap/core/parallel.hpp"

namespace riprap::contact {

namespace {

/// Parts tested against the giants by one task.
constexpr std::size_t giant_block = 4096;

/// Entries [begin, end) of the cell order.
struct Range {
    std::size_t begin, end;
};

/// The occupied ones among a few ranges.
struct Ranges {
    std::array<Range, 9> range{};
    std::size_t count{0};
    std::size_t entries{0};

    void clear() { count = entries = 0; }
    void add(Range r) {
        range[count] = r;
        count += r.begin < r.end ? 1 : 0;
        entries += r.end - r.begin;
    }
};

/// Writes the pairs of one entry with others to `out`, which has room for all
/// of them. Every candidate is written and kept only if it counts: a branch
/// here would often be predicted wrongly.
inline PartPair* scan(const CellOrder::Entry self, const CellOrder::Owner own, const CellOrder::Entry* entry,
                      const CellOrder::Owner* owner, std::size_t count, double skin, PartPair* out) {
    for (std::size_t j = 0; j < count; ++j) {
        const auto is_near =
            static_cast<unsigned>(spheres_within(self.center, self.radius, entry[j].center, entry[j].radius, skin));
        const auto is_allowed = static_cast<unsigned>(own.group != owner[j].group);
        const std::int32_t lower = std::min(own.part, owner[j].part);
        *out = {lower, own.part ^ owner[j].part ^ lower};  // by min and max GCC makes it a branch, half of them wrong
        out += is_near & is_allowed;
    }
    return out;
}

/// Leaves out the immobile parts that no mobile one can be near: most of a large ground. They are those beyond a box
/// around the bounding spheres of all mobile parts.
void leave_out_far(const PartBounds& bounds, double skin, std::vector<std::uint8_t>& is_left_out) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    struct Box {
        Vec3 low, high;
    };
    const Box box = parallel::reduce(
        bounds.size(), Box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}},
        [&](std::int64_t part) {
            const auto i = static_cast<std::size_t>(part);
            const double r = bounds.is_mobile[i] != 0 ? bounds.radius[i] : -infinity;
            const Vec3 reach{r, r, r};
            return Box{bounds.center[i] - reach, bounds.center[i] + reach};
        },
        // min and max take their second argument when the first is NaN: such a part bounds nothing.
        [](const Box& a, const Box& b) {
            return Box{min(b.low, a.low), max(b.high, a.high)};
        });
    constexpr double margin = 1e-9;  // far above round-off
    parallel::for_each(bounds.size(), [&](std::int64_t part) {
        const auto i = static_cast<std::size_t>(part);
        const double reach = bounds.radius[i] + skin;
        bool is_far = false;
        for (int axis = 0; axis < 3; ++axis) {
            const double x = bounds.center[i][axis];
            const double slack = reach + margin * (reach + std::abs(x));
            is_far = is_far || x + slack < box.low[axis] || x - slack > box.high[axis];
        }
        if (is_far && bounds.is_mobile[i] == 0) {
            is_left_out[i] = 1;
        }
    });
}

/// Entries in cells (x-1 .. x+1, y, z) of a level.
Range find_row(const CellOrder& order, const GridLevel& level, const CellIndex& middle) {
    const std::int32_t x_low = std::max(middle.x - 1, level.low.x), x_high = std::min(middle.x + 1, level.high.x);
    if (middle.y < level.low.y || middle.y > level.high.y || middle.z < level.low.z || middle.z > level.high.z ||
        x_low > x_high) {
        return {0, 0};
    }
    const std::size_t begin = order.first_cell(level, level.key({x_low, middle.y, middle.z}));
    const std::uint64_t last_key = level.key({x_high, middle.y, middle.z});
    const std::size_t end = begin + order.count_cells<3>(begin, last_key + 1);
    return {order.cell_start()[begin], order.cell_start()[end]};
}

}  // namespace

void MultilevelGrid::find_pairs(const PartBounds& bounds, std::span<const Giant> giants, double skin, double factor,
                                std::vector<PartPair>& pairs) {
    planes_.assign(bounds, giants);
    is_apart_.assign(static_cast<std::size_t>(bounds.size()), 0);
    for (const Giant& giant : giants) {
        is_apart_[static_cast<std::size_t>(giant.part)] = 1;
    }
    leave_out_far(bounds, skin, is_apart_);
    order_.build(bounds, is_apart_, skin, factor);
    cut_into_pieces();

    const std::size_t giant_blocks = giants.empty() ? 0 : 1 + order_.members().size() / giant_block;
    const std::size_t list_count = pieces_.size() + giant_blocks;
    found_.resize(std::max(found_.size(), list_count));
    around_.resize(std::max(around_.size(), pieces_.size()));
    parallel::for_each_uneven(static_cast<std::int64_t>(list_count), 1, [&](std::int64_t list) {
        const auto k = static_cast<std::size_t>(list);
        found_[k].clear();
        if (k < pieces_.size() && pieces_[k].is_query) {
            search_coarser_levels(pieces_[k], skin, around_[k], found_[k]);
        } else if (k < pieces_.size()) {
            search_own_level(pieces_[k], skin, found_[k]);
        } else {
            search_giants(bounds, skin, k - pieces_.size(), found_[k]);
        }
    });
    sorter_.sort(found_, list_count, bounds.size(), pairs);
}

void MultilevelGrid::cut_into_pieces() {
    pieces_.clear();
    const std::size_t cells = std::max<std::size_t>(256, order_.cell_key().size() / 512);
    for (std::size_t k = 0; k < order_.levels().size(); ++k) {
        const GridLevel& level = order_.levels()[k];
        for (std::size_t cell = level.cell_begin; cell < level.cell_end; cell += cells) {
            pieces_.push_back({k, cell, std::min(cell + cells, level.cell_end), false});
        }
    }
    const std::size_t queries = std::max<std::size_t>(1024, order_.query().size() / 512);
    for (std::size_t q = 0; q < order_.query().size(); q += queries) {
        pieces_.push_back({0, q, std::min(q + queries, order_.query().size()), true});
    }
}

void MultilevelGrid::search_own_level(const Piece& piece, double skin, PairList& found) const {
    const GridLevel& level = order_.levels()[piece.level];
    const auto keys = order_.cell_key();
    const auto starts = order_.cell_start();
    const auto* const entry = order_.entry().data();
    const auto* const owner = order_.owner().data();
    Ranges rows;
    for (std::size_t cell = piece.begin; cell < piece.end; ++cell) {
        const CellIndex index = level.cell_of_key(keys[cell]);
        const bool has_next = index.x < level.high.x && cell + 1 < level.cell_end && keys[cell + 1] == keys[cell] + 1;
        const std::size_t own_end = starts[cell + 1], next_end = starts[cell + (has_next ? 2 : 1)];
        rows.clear();
        rows.add(find_row(order_, level, {index.x, index.y + 1, index.z}));
        rows.add(find_row(order_, level, {index.x, index.y - 1, index.z + 1}));
        rows.add(find_row(order_, level, {index.x, index.y, index.z + 1}));
        rows.add(find_row(order_, level, {index.x, index.y + 1, index.z + 1}));
        for (std::size_t i = starts[cell]; i < own_end; ++i) {
            PartPair* out = found.reserve(rows.entries + next_end - i);
            out = scan(entry[i], owner[i], entry + i + 1, owner + i + 1, next_end - i - 1, skin, out);
            for (std::size_t row = 0; row < rows.count; ++row) {
                const Range r = rows.range[row];
                out = scan(entry[i], owner[i], entry + r.begin, owner + r.begin, r.end - r.begin, skin, out);
            }
            found.advance_to(out);
        }
    }
}

void MultilevelGrid::Neighbourhood::append(const CellOrder& order, std::size_t begin, std::size_t end) {
    // Most rows hold a few: those are copied, needed or not, without a branch on how many there are.
    constexpr std::size_t few = CellOrder::slack;
    if (entry.size() < count + (end - begin) + few) {
        entry.resize(2 * entry.size() + (end - begin) + few);
        owner.resize(entry.size());
    }
    const CellOrder::Entry* const from = order.entry().data() + begin;
    const CellOrder::Owner* const from_owner = order.owner().data() + begin;
    std::copy_n(from, few, entry.data() + count);
    std::copy_n(from_owner, few, owner.data() + count);
    for (std::size_t j = few; j < end - begin; ++j) {
        entry[count + j] = from[j];
        owner[count + j] = from_owner[j];
    }
    count += end - begin;
}

void MultilevelGrid::search_coarser_levels(const Piece& piece, double skin, Neighbourhood& around,
                                           PairList& found) const {
    const auto entry = order_.entry();
    const auto owner = order_.owner();
    for (std::size_t q = piece.begin; q < piece.end; ++q) {
        const std::uint64_t key = order_.query_key()[q];
        if (q == piece.begin || key != order_.query_key()[q - 1]) {
            const GridLevel& level = order_.level_of_key(key);
            const CellIndex index = level.cell_of_key(key);
            around.count = 0;
            for (std::int32_t row = 0; row < 9; ++row) {
                const Range r = find_row(order_, level, {index.x, index.y + row % 3 - 1, index.z + row / 3 - 1});
                around.append(order_, r.begin, r.end);
            }
        }
        const std::size_t i = order_.query()[q], count = around.count;
        found.advance_to(
            scan(entry[i], owner[i], around.entry.data(), around.owner.data(), count, skin, found.reserve(count)));
    }
}

void MultilevelGrid::search_giants(const PartBounds& bounds, double skin, std::size_t block, PairList& found) const {
    const auto members = order_.members();
    const std::size_t end = std::min(members.size(), (block + 1) * giant_block);
    for (std::int32_t giant = 0; giant < planes_.size(); ++giant) {
        const std::int32_t part = planes_.part(giant);
        for (std::size_t m = block * giant_block; m < end; ++m) {
            if (giant_within(planes_, bounds, giant, part, -1, members[m], skin)) {
                found.push({std::min(part, members[m]), std::max(part, members[m])});
            }
        }
        for (std::int32_t other = block == 0 ? giant + 1 : planes_.size(); other < planes_.size(); ++other) {
            const std::int32_t other_part = planes_.part(other);
            if (giant_within(planes_, bounds, giant, part, other, other_part, skin)) {
                found.push({std::min(part, other_part), std::max(part, other_part)});
            }
        }
    }
}

std::size_t MultilevelGrid::bytes() const {
    std::size_t total = order_.bytes() + sorter_.bytes() + is_apart_.capacity() + pieces_.capacity() * sizeof(Piece);
    for (const PairList& list : found_) {
        total += list.bytes();
    }
    for (const Neighbourhood& around : around_) {
        total +=
            around.entry.capacity() * sizeof(CellOrder::Entry) + around.owner.capacity() * sizeof(CellOrder::Owner);
    }
    return total;
}

}  // namespace riprap::contact
