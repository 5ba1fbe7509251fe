// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "riprap/core/parallel_host.hpp"
#include "riprap/fluid/particle/sweep/cell_grid.hpp"
#include "riprap/fluid/particle/sweep/fixed_point.hpp"

namespace riprap::fluid {

/// A place of FixedPoint, as wide as a device reads at once.
struct alignas(16) PackedPlace {
    std::int32_t along[4];
};

/// Writes places in the order of cells.
struct PackPlace {
    FixedPoint fixed;
    const Vec3* position;
    const std::uint32_t* order;
    PackedPlace* packed;

    RIPRAP_HD void operator()(std::int64_t place) const {
        const Vec3& x = position[order[place]];
        packed[place] = {{fixed(x, 0), fixed(x, 1), fixed(x, 2), 0}};
    }
};

/// One set of particles in cells, with their places in the order of cells, in memory of `Where`.
template <class Where>
class CellPlaces {
 public:
    /// @param position  in memory of `Where`
    void place(const CellGridView& cells, const FixedPoint& fixed, std::span<const Vec3> position) {
        const auto count = static_cast<std::int64_t>(position.size());
        cells_ = cells;
        fixed_ = fixed;
        key_.resize(position.size());
        order_.resize(position.size());
        packed_.resize(position.size());
        start_.resize(static_cast<std::size_t>(cells.cell_count()) + 1);
        Where::for_each(count, FindCell{cells, position.data(), key_.data(), order_.data()});
        Where::sort_by_key(key_, order_);
        Where::for_each(cells.cell_count() + 1, FindStart{key_.data(), count, start_.data()});
        Where::for_each(count, PackPlace{fixed, position.data(), order_.data(), packed_.data()});
        cells_.start = start_.data();
        cells_.points = order_.data();
    }
    const CellGridView& view() const { return cells_; }
    const FixedPoint& fixed() const { return fixed_; }
    const std::uint32_t* order() const { return order_.data(); }
    const PackedPlace* places() const { return packed_.data(); }
    std::size_t bytes() const {
        return key_.capacity() * sizeof(std::uint64_t) +
               (order_.capacity() + start_.capacity()) * sizeof(std::int32_t) +
               packed_.capacity() * sizeof(PackedPlace);
    }

 private:
    CellGridView cells_{};
    FixedPoint fixed_;
    typename Where::template Array<std::uint64_t> key_;
    typename Where::template Array<std::uint32_t> order_;
    typename Where::template Array<std::int32_t> start_;
    typename Where::template Array<PackedPlace> packed_;
};

/// Two sets that meet in a sum, and room for the fields of the candidates.
template <class Where>
struct CellPairs {
    const CellPlaces<Where>* targets;
    const CellPlaces<Where>* candidates;
    typename Where::template Array<float>* packed;
};

/// Cells of fluid and walls for the sums over them: what SweepLists is to sweep(), for one thread per target.
template <class Where>
class CellLists {
 public:
    CellLists() = default;
    CellLists(const CellLists&) = delete;
    CellLists& operator=(const CellLists&) = delete;

    /// Tells the sums that follow where the particles are: to be called after every move of either set.
    /// @param box_of_fluid,box_of_walls  around all that are finite
    void place(const SweepReach& reach, const Box& box_of_fluid, std::span<const Vec3> fluid, const Box& box_of_walls,
               std::span<const Vec3> walls) {
        const Box both{min(box_of_fluid.low, box_of_walls.low), max(box_of_fluid.high, box_of_walls.high)};
        const FixedPoint fixed(reach, max(both.high - both.low, Vec3{}));
        const auto cells = [&](const Box& box, std::size_t count) {
            return lay_out_cells(box, count, reach.domain, reach.support_radius, cell_edge * reach.support_radius);
        };
        fluid_.place(cells(box_of_fluid, fluid.size()), fixed, fluid);
        walls_.place(cells(box_of_walls, walls.size()), fixed, walls);
    }
    std::size_t bytes() const { return fluid_.bytes() + walls_.bytes() + packed_.capacity() * sizeof(float); }

 private:
    /// Over the reach: narrower cells follow the sphere in reach more closely, at the cost of more runs to look up.
    /// Part of the definition of a result, as sums follow the cells.
    static constexpr double cell_edge = 1.0 / 3;

    CellPlaces<Where> fluid_, walls_;
    typename Where::template Array<float> packed_;

 public:
    CellPairs<Where> fluid_fluid{&fluid_, &fluid_, &packed_}, fluid_walls{&fluid_, &walls_, &packed_},
        walls_fluid{&walls_, &fluid_, &packed_};
};

}  // namespace riprap::fluid
