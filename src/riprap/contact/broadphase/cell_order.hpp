// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/contact/broadphase/broadphase.hpp"

namespace riprap::contact {

/// Three integer cell coordinates within one level.
struct CellIndex {
    std::int32_t x, y, z;
    friend constexpr bool operator==(const CellIndex&, const CellIndex&) = default;
};

/// One level of the hierarchy: the parts of one size class on a uniform grid of
/// their own.
struct GridLevel {
    double largest_radius;             ///< R_max of the class [m]
    double inverse_cell;               ///< 1/l, l = 2 R_max + skin, a little more for round-off
                                       ///< [1/m]
    CellIndex low, high;               ///< cell indices of the corners of the scene's box
    int bits_x, bits_y;                ///< of a cell index less `low`
    std::uint64_t tag;                 ///< number of the level, above the bits of the cell
    std::size_t cell_begin, cell_end;  ///< its occupied cells, in key order
    int lookup_shift;                  ///< bits of a key below those that index the lookup table
    std::size_t lookup_begin;          ///< of this level in the table

    std::uint64_t key(const CellIndex& cell) const {
        const auto x = static_cast<std::uint64_t>(cell.x - low.x), y = static_cast<std::uint64_t>(cell.y - low.y),
                   z = static_cast<std::uint64_t>(cell.z - low.z);
        return tag | (((z << bits_y) | y) << bits_x) | x;
    }
    CellIndex cell_of_key(std::uint64_t key) const {
        const std::uint64_t k = key & ~tag;
        const auto part = [](std::uint64_t v) { return static_cast<std::int32_t>(v); };
        return {low.x + part(k & ((1ULL << bits_x) - 1)), low.y + part((k >> bits_x) & ((1ULL << bits_y) - 1)),
                low.z + part(k >> (bits_x + bits_y))};
    }
};

/// Ordinary parts sorted by size class and cell, with contiguous copies of what
/// a search reads. Keys order cells by z, then y, then x, so that three
/// neighbours in x lie side by side in memory.
///
/// Any coordinates are safe. Cell indices count from the median of a sample of
/// centres and stop at +-2^19 - 2: what lies farther shares the outermost
/// cells. That keeps neighbours neighbours, so no pair is lost and no key
/// overflows; only a crowd a million cells away from the median would be
/// searched slowly.
class CellOrder {
 public:
    static constexpr int level_limit = 16;
    static constexpr std::size_t slack = 4;

    /// @param is_giant  one entry per part; giants, and whatever else is marked, stay out
    /// @param factor    gamma > 1: radii of class k lie in (R/gamma^(k+1),
    /// R/gamma^k], R the largest [-]; the last of
    ///                  at most 16 classes takes all that are smaller; infinity
    ///                  puts all parts in one class
    void build(const PartBounds& bounds, std::span<const std::uint8_t> is_giant, double skin, double factor);

    std::span<const GridLevel> levels() const { return levels_; }

    /// Occupied cells of all levels: cell c holds entries cell_start[c] ..
    /// cell_start[c+1] - 1.
    std::span<const std::uint64_t> cell_key() const { return std::span(cell_key_).first(cell_start_.size() - 1); }
    std::span<const std::uint32_t> cell_start() const { return cell_start_; }
    /// First occupied cell of the level whose key is not below `key`. The leading
    /// bits of the key look up a short run of cells, of which the first few are
    /// counted without a branch, as how many there are is chance.
    std::size_t first_cell(const GridLevel& level, std::uint64_t key) const {
        const std::size_t slot = level.lookup_begin + ((key & ~level.tag) >> level.lookup_shift);
        std::size_t cell = lookup_[slot];
        const std::size_t end = lookup_[slot + 1];
        if (end - cell > 16) {
            return static_cast<std::size_t>(std::lower_bound(cell_key_.begin() + static_cast<std::ptrdiff_t>(cell),
                                                             cell_key_.begin() + static_cast<std::ptrdiff_t>(end),
                                                             key) -
                                            cell_key_.begin());
        }
        cell += count_cells<2>(cell, key);
        while (cell_key_[cell] < key) {
            ++cell;
        }
        return cell;
    }
    /// Counts those of the `most` cells from `cell` on that have keys below `key`; beyond the last cell none has.
    template <int most>
    std::size_t count_cells(std::size_t cell, std::uint64_t key) const {
        std::size_t count = 0;
        for (std::size_t k = 0; k < static_cast<std::size_t>(most); ++k) {
            count += cell_key_[cell + k] < key ? 1 : 0;
        }
        return count;
    }

    struct Entry {
        Vec3 center;
        double radius;
    };
    /// Entries equal in `group` never pair: the body's number, or -1 for every
    /// immobile part.
    struct Owner {
        std::int32_t part, group;
    };
    /// Parts of finer levels as they look into a coarser one, sorted by level and
    /// cell of the coarser one, so that all that look into the same 27 cells
    /// follow each other: the key of the cell they lie in, and their entry.
    std::span<const std::uint64_t> query_key() const { return query_key_; }
    std::span<const std::uint32_t> query() const { return query_; }
    const GridLevel& level_of_key(std::uint64_t key) const { return levels_[key >> cell_bits_]; }

    /// Behind both may be read, though not used, `slack` more.
    std::span<const Entry> entry() const { return std::span(entry_).first(part_.size()); }
    std::span<const Owner> owner() const { return std::span(owner_).first(part_.size()); }
    std::span<const std::int32_t> members() const { return members_; }  ///< parts that are no giants, increasing
    std::size_t bytes() const;

 private:
    void classify(const PartBounds& bounds, std::span<const std::uint8_t> is_giant, double factor);
    void place_levels(const PartBounds& bounds, double skin);
    void sort_parts(const PartBounds& bounds);
    void find_cells();
    void index_cells();
    void copy_entries(const PartBounds& bounds);
    void sort_queries();
    CellIndex cell_at(const GridLevel& level, const Vec3& center) const;
    CellIndex cell_inside(const GridLevel& level, const Vec3& center) const;

    // Size classes; kept while radii, giants and factor stay the same.
    std::vector<double> classified_radius_;
    std::vector<std::uint8_t> classified_giant_;
    double classified_factor_{0};
    std::vector<std::int32_t> members_;
    std::vector<std::uint8_t> member_level_;

    Vec3 origin_{};
    int cell_bits_{0};
    std::vector<GridLevel> levels_;
    std::vector<std::uint64_t> key_, key_scratch_;
    std::vector<std::uint32_t> part_, part_scratch_;
    std::vector<std::uint32_t> cell_number_;
    static constexpr std::size_t padding = 3;  ///< keys above all others, for those who count beyond the last cell
    std::vector<std::uint64_t> cell_key_;
    std::vector<std::uint32_t> cell_start_;
    std::vector<std::uint32_t> lookup_;  ///< first cell with at least the leading bits of the slot
    std::vector<Entry> entry_;
    std::vector<Owner> owner_;
    std::vector<std::uint64_t> query_key_;
    std::vector<std::uint32_t> query_;
};

}  // namespace riprap::contact
