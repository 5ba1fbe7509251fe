// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "riprap/validation/dda/planar_trial.hpp"
#include "riprap/validation/registry.hpp"

namespace riprap::validation::ding {

/// A bed of crushed stone between two walls, at rest under its weight [Ding2021, section 5.4]: convex polygons of 5 to
/// 8 corners, sizes between 31.5 and 63 mm evenly in their logarithm. y = 0 is the floor.
struct BallastBed {
    PlanarTrial trial;
    std::int32_t first_stone{0}, stone_count{0};
    std::int32_t ice_material{0};
    double surface{0};                    ///< mean height of the highest stones in the middle [m]
    double porosity{0};                   ///< below the surface [-]
    std::vector<geometry::Vec2> start{};  ///< of the stones [m]
    std::vector<std::int32_t> rails{};    ///< blocks that stand for rails; none unless added
    std::vector<std::int32_t> walls{};    ///< of the box that the stones were poured into
    double wall_height{0};                ///< of their tops [m]
};

/// Stones of one packing. Sizes, shapes and places follow from the seed alone.
BallastBed make_bed(double length, double thickness, std::uint64_t seed);

/// Effect of one block of ice on a bed.
struct Strike {
    double impact_time{0};    ///< of the first touch [s]
    int flying{0};            ///< stones whose centre rose by more than 47 mm, a mean size
    int above_330{0};         ///< stones whose centre rose by more than 330 mm
    double highest{0};        ///< rise of a stone [m]
    geometry::Vec2 marked{};  ///< largest displacement along x and y of the marked stone, which the ice meets first [m]
    geometry::Vec2 ice{};     ///< displacement of the ice at the end [m]
    double ice_way{0};        ///< largest displacement of the ice after the touch [m]
    double ice_bounce{0};     ///< rise of the ice above the surface after the touch [m]
    double ice_angle{0};      ///< of the ice above the horizontal when it rises fastest; 0 where it never rises [rad]
    double crater_depth{0};   ///< deepest place of a stone's centre below its first one, at the end [m]
    double crater_width{0};   ///< of the bed whose stones end more than half a mean size from their places [m]
    double parabola{0};       ///< 1 - R^2 of the path of the stone longest in the air against a parabola
    std::vector<double> times{};        ///< from the touch on [s]
    std::vector<double> ice_ways{};     ///< of the ice from where it touched, at these times [m]
    std::vector<double> marked_ways{};  ///< of the marked stone from its place [m]
    bool has_hit_rail{false};
    double marked_apex{0};    ///< time at which the marked stone is highest [s]
    double second_strike{0};  ///< time at which ice that had left the bed meets it again; 0 = it does not [s]
    double ledger{0};
};

/// Approach of the ice.
struct Shot {
    geometry::Vec2 velocity{};
    double height{0.6};   ///< of its lowest point above the mean surface; more where a stone stands there [m]
    double place{0};      ///< x of its centre [m]
    int corners{32};      ///< of a regular polygon; 0 = the rectangle of `size`
    bool is_flat{false};  ///< it comes with an edge first, not with a corner
    geometry::Vec2 size{0.05, 0.05};  ///< radius of the polygon, or both sides [m]
    double after{0.3};                ///< time from the touch over which everything is measured [s]
    double watch{0};                  ///< longer time from the touch in which a second strike is looked for [s]
};

/// Throws ice on a copy of the bed. Ice that comes along the bed meets no walls above it: a track has none.
Strike strike(const BallastBed& bed, const Shot& shot);

}  // namespace riprap::validation::ding
