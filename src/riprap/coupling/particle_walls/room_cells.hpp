// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "riprap/body/motion.hpp"
#include "riprap/coupling/particle_walls/near_parts.hpp"
#include "riprap/fluid/particle/sweep/domain.hpp"
#include "riprap/geometry/polyhedra/shape_set.hpp"

namespace riprap::coupling {

/// Bodies as the walls of the water at one moment.
struct RoomWalls {
    const geometry::ShapeSet& shapes;
    const body::BodySet& bodies;
    std::span<const std::uint8_t> is_dry;  ///< per body: water passes it; empty = none
    const body::Motion& motion;            ///< of all bodies
};

/// Space outside of all solids that hangs together.
struct Room {
    double volume{0};      ///< [m^3]; in 2D [m^2]
    double widest_gap{0};  ///< from a place in it to the nearest solid, at most 2 spacings [m]
    bool is_closed{true};  ///< walled in on all sides, or going round over periodic ones
};

/// A body at the surface of a room.
struct RoomWall {
    std::int32_t body;
    double area;    ///< [m^2]; in 2D [m]
    double inflow;  ///< at which it takes room away [m^3/s]; in 2D [m^2/s]
};

/// The rooms about the water: cells of half a spacing, each with its share of solid, that hang together through places
/// more than a quarter of a spacing away from every face. So gaps narrower than half a spacing, which no particle
/// passes, part two rooms. A cell that a face cuts counts by the share of it in front of the plane of the face, which
/// is exact for planes along the axes and to second order in the size of the cells for others.
///
/// Where the water is spread so thinly that there would be too many cells, these are larger; above one spacing there
/// are none, nor rooms.
class RoomCells {
 public:
    RoomCells(const RoomWalls& walls, std::span<const Vec3> water, const fluid::Domain& domain, double spacing);

    std::span<const Room> rooms() const { return rooms_; }
    /// The room of a particle, also where it stands a little inside a wall; -1 = none.
    std::int32_t room_at(const Vec3& x) const;
    /// The bodies about a room, in their order.
    std::vector<RoomWall> walls_of(std::int32_t room) const;

 private:
    using Cell = std::array<std::int64_t, 3>;
    struct WallCell {
        float gap;          ///< from its middle to the nearest solid, negative inside [m]
        float solid;        ///< share of it [-]
        std::int32_t part;  ///< the nearest of parts_; -1 = none near
    };
    struct BoxedPart {
        PlacedPart part;
        Vec3 low, high;  ///< box of what it may matter to [m]
    };

    bool lay_out(std::span<const Vec3> water, const fluid::Domain& domain);
    void place_parts(const fluid::Domain& domain);
    void fill_slab(std::int64_t slab);
    void find_rooms();
    void flood(std::int64_t first, std::vector<std::int64_t>& front);
    void share_cut_cells();
    bool is_core(std::int64_t cell) const;
    Vec3 middle(const Cell& cell) const;
    Cell cell_of(std::int64_t entry) const;
    std::int64_t entry(const Cell& cell) const { return (cell[2] * count_[1] + cell[1]) * count_[0] + cell[0]; }
    /// Moves a cell along an axis; false where that leads out of all cells.
    bool step(Cell& cell, int axis, std::int64_t by) const;
    template <class Visit>
    void visit_around(const Cell& cell, const Visit& visit) const;

    RoomWalls walls_;
    int dimension_;
    double spacing_;
    Vec3 low_{}, size_{1, 1, 1};  ///< of all cells; of one [m]
    Cell count_{1, 1, 1};
    std::array<bool, 3> wraps_{};
    std::vector<BoxedPart> parts_;  ///< by body
    std::vector<WallCell> cells_;
    std::vector<std::int32_t> room_;  ///< of each cell; -1 = none
    std::vector<Room> rooms_;
};

}  // namespace riprap::coupling
