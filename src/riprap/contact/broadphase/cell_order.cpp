// SPDX-License-Identifier: Apache-2.0
#include "riprap/contact/broadphase/cell_order.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "riprap/core/parallel.hpp"

namespace riprap::contact {

namespace {

/// Cell indices stay within +-index_limit: 20 bits an axis, which leaves four
/// bits of a key for the level.
constexpr double index_limit = (1 << 19) - 2;
/// Relative growth of a cell. An index is at most 2^19 and is formed with three
/// roundings, so it is off by less than 2^19 * 2^-51 = 2.4e-10; two parts
/// within reach then stay in neighbouring cells.
constexpr double cell_margin = 1e-8;

/// floor(v), kept within the limits; NaN goes to the lower end, where it pairs
/// with nothing.
std::int32_t bounded_floor(double v) {
    v = v > -index_limit ? v : -index_limit;
    v = v < index_limit ? v : index_limit;
    return static_cast<std::int32_t>(std::floor(v));
}

int bits_for(std::int32_t low, std::int32_t high) {
    return static_cast<int>(std::bit_width(static_cast<std::uint32_t>(high - low)));
}

/// Per-axis median over at most 255 members: unmoved by a few runaway parts.
Vec3 sample_median(std::span<const Vec3> center, std::span<const std::int32_t> members) {
    constexpr std::size_t sample_size = 255;
    const std::size_t stride = members.size() / sample_size + 1;
    Vec3 median{};
    for (int axis = 0; axis < 3; ++axis) {
        std::array<double, sample_size + 1> sample{};
        std::size_t count = 0;
        for (std::size_t m = 0; m < members.size(); m += stride) {
            const double v = center[static_cast<std::size_t>(members[m])][axis];
            if (std::isfinite(v)) {
                sample[count++] = v;
            }
        }
        if (count > 0) {
            auto* const middle = sample.begin() + static_cast<std::ptrdiff_t>(count / 2);
            std::nth_element(sample.begin(), middle, sample.begin() + static_cast<std::ptrdiff_t>(count));
            median[axis] = *middle;
        }
    }
    return median;
}

struct Box {
    Vec3 low, high;
};

Box bounding_box(std::span<const Vec3> center, std::span<const std::int32_t> members) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Box empty{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
    return parallel::reduce(
        static_cast<std::int64_t>(members.size()), empty,
        [&](std::int64_t m) {
            const Vec3& c = center[static_cast<std::size_t>(members[static_cast<std::size_t>(m)])];
            return Box{c, c};
        },
        // min and max take their first argument when the second is NaN.
        [](const Box& a, const Box& b) {
            return Box{min(b.low, a.low), max(b.high, a.high)};
        });
}

}  // namespace

void CellOrder::build(const PartBounds& bounds, std::span<const std::uint8_t> is_giant, double skin, double factor) {
    classify(bounds, is_giant, factor);
    place_levels(bounds, skin);
    sort_parts(bounds);
    find_cells();
    index_cells();
    copy_entries(bounds);
    sort_queries();
}

void CellOrder::classify(const PartBounds& bounds, std::span<const std::uint8_t> is_giant, double factor) {
    if (factor == classified_factor_ && std::ranges::equal(bounds.radius, classified_radius_) &&
        std::ranges::equal(is_giant, classified_giant_)) {
        return;
    }
    classified_factor_ = factor;
    classified_radius_.assign(bounds.radius.begin(), bounds.radius.end());
    classified_giant_.assign(is_giant.begin(), is_giant.end());
    members_.clear();
    member_level_.clear();
    levels_.clear();

    double largest = 0;
    for (std::size_t i = 0; i < bounds.radius.size(); ++i) {
        if (is_giant[i] == 0) {
            members_.push_back(static_cast<std::int32_t>(i));
            largest = std::max(largest, bounds.radius[i]);
        }
    }
    std::array<double, level_limit> class_radius{};
    std::array<std::size_t, level_limit> class_count{};
    for (const std::int32_t part : members_) {
        const double radius = bounds.radius[static_cast<std::size_t>(part)];
        int level = 0;
        for (double edge = largest / factor; level < level_limit - 1 && radius <= edge && edge > 0; edge /= factor) {
            ++level;
        }
        const auto k = static_cast<std::size_t>(level);
        member_level_.push_back(static_cast<std::uint8_t>(level));
        class_radius[k] = std::max(class_radius[k], radius);
        ++class_count[k];
    }
    // Empty classes are left out.
    std::array<std::uint8_t, level_limit> occupied_level{};
    for (std::size_t k = 0; k < level_limit; ++k) {
        occupied_level[k] = static_cast<std::uint8_t>(levels_.size());
        if (class_count[k] > 0) {
            GridLevel level{};
            level.largest_radius = class_radius[k];
            levels_.push_back(level);
        }
    }
    for (std::uint8_t& level : member_level_) {
        level = occupied_level[level];
    }
}

CellIndex CellOrder::cell_at(const GridLevel& level, const Vec3& center) const {
    const Vec3 q = level.inverse_cell * (center - origin_);
    return {bounded_floor(q.x), bounded_floor(q.y), bounded_floor(q.z)};
}

CellIndex CellOrder::cell_inside(const GridLevel& level, const Vec3& center) const {
    const CellIndex cell = cell_at(level, center);
    // Only a NaN lies outside the box.
    return {std::clamp(cell.x, level.low.x, level.high.x), std::clamp(cell.y, level.low.y, level.high.y),
            std::clamp(cell.z, level.low.z, level.high.z)};
}

void CellOrder::place_levels(const PartBounds& bounds, double skin) {
    origin_ = sample_median(bounds.center, members_);
    const Box box = bounding_box(bounds.center, members_);
    cell_bits_ = 0;
    for (GridLevel& level : levels_) {
        const double cell = (2 * level.largest_radius + skin) * (1 + cell_margin);
        // Points without a skin reach nothing, so any cell will do.
        level.inverse_cell = cell > 0 ? 1 / cell : 1;
        level.low = cell_at(level, box.low);
        level.high = cell_at(level, box.high);
        level.bits_x = bits_for(level.low.x, level.high.x);
        level.bits_y = bits_for(level.low.y, level.high.y);
        cell_bits_ = std::max(cell_bits_, level.bits_x + level.bits_y + bits_for(level.low.z, level.high.z));
    }
    for (std::size_t k = 0; k < levels_.size(); ++k) {
        levels_[k].tag = static_cast<std::uint64_t>(k) << cell_bits_;
    }
}

void CellOrder::sort_parts(const PartBounds& bounds) {
    key_.resize(members_.size());
    part_.resize(members_.size());
    parallel::for_each(static_cast<std::int64_t>(members_.size()), [&](std::int64_t m) {
        const auto i = static_cast<std::size_t>(m);
        const std::int32_t part = members_[i];
        const GridLevel& level = levels_[member_level_[i]];
        key_[i] = level.key(cell_inside(level, bounds.center[static_cast<std::size_t>(part)]));
        part_[i] = static_cast<std::uint32_t>(part);
    });
    parallel::sort_by_key(key_, part_, key_scratch_, part_scratch_);
}

void CellOrder::find_cells() {
    const std::size_t count = key_.size();
    cell_number_.resize(count);
    parallel::for_each(static_cast<std::int64_t>(count), [&](std::int64_t m) {
        const auto i = static_cast<std::size_t>(m);
        cell_number_[i] = i == 0 || key_[i] != key_[i - 1] ? 1 : 0;
    });
    const std::uint32_t cell_count = parallel::exclusive_scan<std::uint32_t>(cell_number_, cell_number_);
    cell_key_.resize(cell_count + padding);
    std::fill(cell_key_.end() - padding, cell_key_.end(), std::numeric_limits<std::uint64_t>::max());
    cell_start_.resize(cell_count + 1);
    parallel::for_each(static_cast<std::int64_t>(count), [&](std::int64_t m) {
        const auto i = static_cast<std::size_t>(m);
        if (i == 0 || key_[i] != key_[i - 1]) {
            cell_key_[cell_number_[i]] = key_[i];
            cell_start_[cell_number_[i]] = static_cast<std::uint32_t>(i);
        }
    });
    cell_start_[cell_count] = static_cast<std::uint32_t>(count);
    for (std::size_t k = 0; k < levels_.size(); ++k) {
        const auto begin = std::ranges::lower_bound(cell_key_, levels_[k].tag);
        levels_[k].cell_begin = static_cast<std::size_t>(begin - cell_key_.begin());
        levels_[k].cell_end = cell_count;
        if (k > 0) {
            levels_[k - 1].cell_end = levels_[k].cell_begin;
        }
    }
}

void CellOrder::index_cells() {
    std::size_t slot_count = 0;
    for (GridLevel& level : levels_) {
        const std::uint64_t last_key = level.key(level.high) & ~level.tag;
        const std::size_t cells = level.cell_end - level.cell_begin;
        level.lookup_shift =
            std::max(0, static_cast<int>(std::bit_width(last_key)) - static_cast<int>(std::bit_width(2 * cells)));
        level.lookup_begin = slot_count;
        slot_count += (last_key >> level.lookup_shift) + 2;
    }
    lookup_.resize(slot_count);
    for (const GridLevel& level : levels_) {
        const std::size_t slots = (level.key(level.high) & ~level.tag) >> level.lookup_shift;
        std::size_t next = 0;
        for (std::size_t cell = level.cell_begin; cell < level.cell_end; ++cell) {
            const std::size_t slot = (cell_key_[cell] & ~level.tag) >> level.lookup_shift;
            for (; next <= slot; ++next) {
                lookup_[level.lookup_begin + next] = static_cast<std::uint32_t>(cell);
            }
        }
        for (; next <= slots + 1; ++next) {
            lookup_[level.lookup_begin + next] = static_cast<std::uint32_t>(level.cell_end);
        }
    }
}

void CellOrder::copy_entries(const PartBounds& bounds) {
    entry_.resize(part_.size() + slack);
    owner_.resize(part_.size() + slack);
    parallel::for_each(static_cast<std::int64_t>(part_.size()), [&](std::int64_t m) {
        const auto i = static_cast<std::size_t>(m);
        const auto part = static_cast<std::size_t>(part_[i]);
        entry_[i] = {bounds.center[part], bounds.radius[part]};
        owner_[i] = {static_cast<std::int32_t>(part), bounds.is_mobile[part] != 0 ? bounds.body[part] : -1};
    });
}

void CellOrder::sort_queries() {
    std::size_t count = 0;
    for (const GridLevel& level : levels_) {
        count += part_.size() - cell_start_[level.cell_end];
    }
    query_key_.resize(count);
    query_.resize(count);
    std::size_t begin = 0;
    for (const GridLevel& level : levels_) {
        const std::size_t first = cell_start_[level.cell_end];
        parallel::for_each(static_cast<std::int64_t>(part_.size() - first), [&](std::int64_t q) {
            const std::size_t i = first + static_cast<std::size_t>(q), slot = begin + static_cast<std::size_t>(q);
            query_key_[slot] = level.key(cell_inside(level, entry_[i].center));
            query_[slot] = static_cast<std::uint32_t>(i);
        });
        begin += part_.size() - first;
    }
    parallel::sort_by_key(query_key_, query_, key_scratch_, part_scratch_);
}

std::size_t CellOrder::bytes() const {
    const auto held = [](const auto&... buffers) { return (0 + ... + (buffers.capacity() * sizeof(buffers[0]))); };
    return held(classified_radius_, classified_giant_, members_, member_level_, levels_, key_, key_scratch_, part_,
                part_scratch_, cell_number_, cell_key_, cell_start_, lookup_, entry_, owner_, query_key_, query_);
}

}  // namespace riprap::contact
