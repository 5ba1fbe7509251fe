// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "riprap/core/quat.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/particle_state.hpp"

namespace riprap::fluid {

/// Quantity that an instrument in the water reads.
enum class GaugeKind : std::uint8_t {
    pressure,  ///< at a point in the water [Pa]
    velocity,  ///< at a point [m/s], 3 numbers
    level,     ///< height of the water column above a point at the bed [m]
    surface,   ///< along a line: distance from its start to the last crossing of the surface [m]
    run_up,  ///< along a line that lies just above a slope: distance from its start to where water from there ends [m]
    flow,    ///< through a rectangle, positive along its normal [m^3/s], in 2D [m^2/s]
    volume,  ///< of water in a box [m^3], in 2D [m^2]; behind a crest: overtopping
    wall_pressure,  ///< of the water on a face, as a transducer in it reads it [Pa]; whoever couples solids reads it
};

/// One instrument: Model.
struct Gauge {
    std::string name;
    GaugeKind kind{GaugeKind::pressure};
    Vec3 point{};           ///< where; start of a line; lower corner of a box or rectangle; see `carrier` [m]
    Vec3 end{};             ///< end of a line; upper corner of a box or rectangle; see `carrier` [m]
    Vec3 up{0, 0, 1};       ///< unit vector against gravity, for `level`; in the world, carried or not [-]
    std::int32_t face{-1};  ///< of wall_pressure: number among the faces that the reader knows
    /// Number of the body that it moves with, whose frame `point` and `end` are in then; -1 = it stays where it is and
    /// they are in the world. Not for `flow` and `volume`, which keep to the axes, nor for wall_pressure, whose face
    /// says it.
    std::int32_t carrier{-1};
};

/// The gauge where its carrier is now, in the world and without a carrier; itself where it has none.
/// @param position, orientation  of all bodies
Gauge carried(const Gauge& gauge, std::span<const Vec3> position, std::span<const Quat> orientation);

/// Word of a kind in a case, its unit and the number of its components.
struct GaugeInfo {
    GaugeKind kind;
    std::string_view name, unit;
    int components;
};
std::span<const GaugeInfo> gauge_kinds();
const GaugeInfo& info_of(GaugeKind kind);
/// nullptr when there is no such kind.
const GaugeInfo* find_gauge_kind(std::string_view name);

/// Reads one gauge of any kind but wall_pressure from the particles, in the order of the State (same bits at any thread
/// count). A dry place reads 0.
///
/// pressure, velocity: moving least squares of first order with the kernel as weight, exact for linear fields also on a
/// wall, where one half of the support is empty; where too few particles lie near, their weighted mean [Liu2006]. Where
/// water hits a wall in single particles, that mean is the pressure in one of them, not what the wall feels.
/// level, flow, volume: with V_j = m/rho_0, what the water takes without the compression that its sound speed, lower
/// than nature's, gives it.
/// level: integral of the water fraction along the vertical, sum_j V_j B(a_j) B(b_j) with a_j, b_j the horizontal
/// distances and B a cubic B-spline one spacing wide: it sees spray and voids as a capacitance gauge does. Within two
/// spacings of a side wall it reads too little. surface, run_up: the fraction sum_j V_j W crosses one half.
/// flow: sum_j V_j (v_j . n) B(s_j), s_j the distance from the plane, over the particles beside the rectangle.
///
/// Across periodic sides a particle counts where its image lies: the nearest one for sums about a place, all of them
/// for the column of `level`, any one of them, once, for `flow` and `volume`.
std::array<double, 3> read_gauge(const Gauge& gauge, const ParticleSettings& settings, const ParticleState& state);

}  // namespace riprap::fluid
