// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "riprap/body/gravity.hpp"
#include "riprap/coupling/fill.hpp"
#include "riprap/fluid/flow/flows.hpp"
#include "riprap/fluid/grid/settings.hpp"
#include "riprap/fluid/particle/sweep/domain.hpp"
#include "riprap/wave/irregular_wave.hpp"

namespace riprap::coupling {

/// A level of the water at one time.
struct LevelAt {
    double time;   ///< [s]
    double level;  ///< height along `up` from the origin [m]
};

/// Waves that a case lets in through a side of the domain, and out.
struct WavesAtSide {
    enum class Kind : std::uint8_t {
        none,          ///< lets waves out alone
        regular,       ///< steady waves of finite height, by the stream function
        second_order,  ///< the same by Stokes' second order
        solitary,      ///< one solitary wave, by the stream function
        boussinesq,    ///< one solitary wave by the second-order formulas of [Ding2021, eqs. 6.2, 6.3]
        irregular,     ///< a sea
    };
    int side{0};  ///< twice the axis, plus 1 for the high side
    Kind kind{Kind::none};
    double height{0};         ///< H, of a sea H_m0 [m]
    double period{0};         ///< T, of a sea T_p [s]
    double depth{0};          ///< of still water [m]
    double crest_time{-1};    ///< at which the (first) crest comes in [s]; negative: as soon as it can from still water
    double ramp{0};           ///< in which regular waves and seas grow [s]
    double gamma{3.3};        ///< peak enhancement of a sea [-]
    std::uint64_t seed{1};    ///< of the phases of a sea
    wave::Spectrum spectrum;  ///< of a sea; empty: JONSWAP
    bool absorbs{false};      ///< lets out what arrives
};

/// A part of a side of the domain through which water enters or leaves.
struct OpenSide {
    enum class Kind : std::uint8_t {
        inflow,  ///< water enters at a given speed
        drawn,   ///< what is there is drawn off at a given speed
        level,   ///< still water stands beyond
        free,    ///< nothing is beyond: water falls
    };
    int side{0};  ///< twice the axis, plus 1 for the high side
    Kind kind{Kind::inflow};
    Vec3 low{}, high{};   ///< corners of the opening [m]
    double speed{0};      ///< [m/s]
    double ramp{0};       ///< in which it grows [s]
    double level{1e300};  ///< up to which water enters, or stands beyond [m]
};

/// States what a case asks of a whole side of the domain.
struct SideRule {
    enum class Kind : std::uint8_t {
        slip,           ///< a wall without friction
        no_slip,        ///< a wall that the water sticks to
        wall_function,  ///< a wall with the shear of a turbulent layer
        endless,        ///< the flow goes on beyond as it is inside, without a difference of pressure
        flow,           ///< water comes in and goes out with the velocity of FieldScene::flow
    };
    int side{0};  ///< twice the axis, plus 1 for the high side
    Kind kind{Kind::slip};
    Vec3 velocity{};  ///< of a wall, along itself [m/s]
};

/// Stones that water flows through.
struct Stones {
    std::vector<geometry::Polyhedron> pieces;  ///< convex, world axes [m]
    fluid::grid::PorousMedium medium;
};

/// A box in which water is slowed down ever more along one direction.
struct CalmBox {
    Vec3 low{}, high{};  ///< [m]
    int axis{0};
    bool is_towards_high{true};
    double rate{0};  ///< at its end; 0: that of a long wave [1/s]
};

/// Place of a fluid without particles as the case gives it: handed to the `prepare` of its settings, once, while the
/// case is read.
struct FieldScene {
    fluid::Domain domain;
    std::vector<FillRegion> regions;
    std::optional<fluid::Flow> flow;  ///< velocity at the start, instead of that of the regions
    std::vector<SideRule> sides;
    std::vector<LevelAt> levels;  ///< in rising order of time; empty where the level does not change
    Vec3 up{0, 0, 1};             ///< against gravity [-]
    body::Gravity gravity{};
    std::vector<WavesAtSide> waves;
    std::vector<OpenSide> openings;
    std::vector<Stones> stones;
    std::vector<CalmBox> calm;
    std::vector<std::uint8_t> is_dry;  ///< per body: not there for the water; bodies beyond the end are wet
};

}  // namespace riprap::coupling
