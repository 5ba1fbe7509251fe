// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "riprap/core/quat.hpp"
#include "riprap/fluid/gauge/water_reader.hpp"
#include "riprap/fluid/particle/particle_settings.hpp"
#include "riprap/fluid/particle/particle_state.hpp"

namespace riprap::fluid {

/// Place that an instrument looks at, and with it the keys that a case gives.
enum class GaugeExtent : std::uint8_t {
    point,    ///< `point` alone
    face,     ///< the face of a body next to `point`
    line,     ///< from `point` to `end`; what lies in its way hides nothing behind it
    way,      ///< from `point` to `end`, as far as nothing is in the way
    section,  ///< the rectangle between `point` and `end`, across an axis
    box,      ///< the box between `point` and `end`
};
constexpr bool has_end(GaugeExtent extent) { return extent >= GaugeExtent::line; }
/// Sections and boxes keep to the axes.
constexpr bool may_move(GaugeExtent extent) { return extent < GaugeExtent::section; }

struct Gauge;

/// One number, or three of a vector.
using GaugeReading = std::array<double, 3>;

/// Kind of an instrument, one of `all_gauges` (fluid/gauge/gauge_kinds.hpp).
struct GaugeKind {
    std::string_view word;  ///< as a case names it
    std::string_view unit;
    int components;
    GaugeExtent extent;
    unsigned needs;         ///< readings of the water that it is made of
    std::string_view help;  ///< what it reads, without a full stop
    GaugeReading (*read)(const Gauge& gauge, const WaterReader& water);
};

/// One instrument: Model.
struct Gauge {
    std::string name;
    const GaugeKind* kind{nullptr};
    Vec3 point{};           ///< where; start of a line; lower corner of a box or rectangle; see `carrier` [m]
    Vec3 end{};             ///< end of a line; upper corner of a box or rectangle; see `carrier` [m]
    Vec3 up{0, 0, 1};       ///< unit vector against gravity; in the world, carried or not [-]
    std::int32_t face{-1};  ///< of an instrument in a face: number among the faces that the reader knows
    /// Number of the body that it moves with, whose frame `point` and `end` are in then; -1 = it stays where it is and
    /// they are in the world. Not for sections and boxes, which keep to the axes, nor for faces, which say it.
    std::int32_t carrier{-1};
    double response{0};  ///< theta of an instrument that shows readings late [s]; 0 = at once
};

/// The gauge where its carrier is now, in the world and without a carrier; itself where it has none.
/// @param position, orientation  of all bodies
Gauge carried(const Gauge& gauge, std::span<const Vec3> position, std::span<const Quat> orientation);

/// Returns what an instrument that shows readings late shows a step later,
///
///     y + (1 - exp(-dt/theta)) (p - y),
///
/// of first order: the integral of y over time is that of p less theta times the change of y.
/// @param shown, now  y before and the reading p after the step
/// @param response    theta > 0 [s]
double lagged(double shown, double now, double dt, double response);

/// All kinds, in the order of the manual.
std::span<const GaugeKind* const> gauge_kinds();
/// nullptr when there is no such kind.
const GaugeKind* find_gauge_kind(std::string_view word);

/// Reads a gauge from particles alone: of any kind but those on faces (fluid/gauge/particle_reader.hpp).
GaugeReading read_gauge(const Gauge& gauge, const ParticleSettings& settings, const ParticleState& state);

}  // namespace riprap::fluid
