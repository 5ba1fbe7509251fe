// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "riprap/fluid/gauge/gauge.hpp"

// Kinds of gauges. Each makes its numbers of readings of the water, whatever the fluid; one line in `all_gauges`
// registers it. Words, units, help, checks and columns of a case are made from that list, and a fluid reads a kind
// where it offers the readings that the kind needs.

namespace riprap::fluid {

inline constexpr GaugeKind pressure_gauge{
    "pressure",
    "Pa",
    1,
    GaugeExtent::point,
    reading::pressure,
    "at a point in the water",
    [](const Gauge& gauge, const WaterReader& water) -> GaugeReading { return {water.pressure(gauge.point)}; }};

inline constexpr GaugeKind velocity_gauge{"velocity",
                                          "m/s",
                                          3,
                                          GaugeExtent::point,
                                          reading::velocity,
                                          "at a point in the water",
                                          [](const Gauge& gauge, const WaterReader& water) -> GaugeReading {
                                              const Vec3 u = water.velocity(gauge.point);
                                              return {u.x, u.y, u.z};
                                          }};

inline constexpr GaugeKind level_gauge{
    "level",
    "m",
    1,
    GaugeExtent::point,
    reading::level,
    "height of the water column above a point at the bed, voids left out",
    [](const Gauge& gauge, const WaterReader& water) -> GaugeReading { return {water.level(gauge.point, gauge.up)}; }};

inline constexpr GaugeKind surface_gauge{
    "surface",
    "m",
    1,
    GaugeExtent::line,
    reading::surface,
    "distance along the line from point to end at which water ends for the last time",
    [](const Gauge& gauge, const WaterReader& water) -> GaugeReading {
        return {water.surface(gauge.point, gauge.end)};
    }};

inline constexpr GaugeKind run_up_gauge{"run_up",
                                        "m",
                                        1,
                                        GaugeExtent::way,
                                        reading::run_up,
                                        "likewise, for the first time; lay the line one spacing above the slope",
                                        [](const Gauge& gauge, const WaterReader& water) -> GaugeReading {
                                            return {water.run_up(gauge.point, gauge.end)};
                                        }};

inline constexpr GaugeKind flow_gauge{
    "flow",
    "m^3/s",
    1,
    GaugeExtent::section,
    reading::flow,
    "through the rectangle between point and end, positive along its axis",
    [](const Gauge& gauge, const WaterReader& water) -> GaugeReading { return {water.flow(gauge.point, gauge.end)}; }};

inline constexpr GaugeKind volume_gauge{"volume",
                                        "m^3",
                                        1,
                                        GaugeExtent::box,
                                        reading::volume,
                                        "of the water in the box between point and end",
                                        [](const Gauge& gauge, const WaterReader& water) -> GaugeReading {
                                            return {water.volume(gauge.point, gauge.end)};
                                        }};

inline constexpr GaugeKind centre_gauge{"centre",
                                        "m",
                                        3,
                                        GaugeExtent::box,
                                        reading::centre,
                                        "mean place of the water in the box between point and end",
                                        [](const Gauge& gauge, const WaterReader& water) -> GaugeReading {
                                            const Vec3 x = water.centre(gauge.point, gauge.end);
                                            return {x.x, x.y, x.z};
                                        }};

inline constexpr GaugeKind mean_velocity_gauge{"mean_velocity",
                                               "m/s",
                                               3,
                                               GaugeExtent::box,
                                               reading::mean_velocity,
                                               "of the water in the box between point and end, by volume",
                                               [](const Gauge& gauge, const WaterReader& water) -> GaugeReading {
                                                   const Vec3 u = water.mean_velocity(gauge.point, gauge.end);
                                                   return {u.x, u.y, u.z};
                                               }};

inline constexpr GaugeKind flow_error_gauge{
    "flow_error",
    "m/s",
    3,
    GaugeExtent::box,
    reading::flow_error,
    "velocity of the water less that of fluid.flow at the time: root of the mean square of each component over the "
    "faces of cells in the box between point and end",
    [](const Gauge& gauge, const WaterReader& water) -> GaugeReading {
        const Vec3 u = water.flow_error(gauge.point, gauge.end);
        return {u.x, u.y, u.z};
    }};

inline constexpr GaugeKind changed_gauge{
    "changed",
    "m^3",
    1,
    GaugeExtent::box,
    reading::changed,
    "volume in the box between point and end that has got water since the start, and that has lost it, added up",
    [](const Gauge& gauge, const WaterReader& water) -> GaugeReading {
        return {water.changed(gauge.point, gauge.end)};
    }};

inline constexpr GaugeKind wall_pressure_gauge{
    "wall_pressure",
    "Pa",
    1,
    GaugeExtent::face,
    reading::wall_pressure,
    "on the face of a body nearest to the point, a spacing away at most: force over area in the last step, as a "
    "transducer in it reads it; the gauge stays with the body. It reads 0 while another body covers it, and has no "
    "value before the first step",
    [](const Gauge& /*gauge*/, const WaterReader& water) -> GaugeReading { return {water.wall_pressure()}; }};

inline constexpr GaugeKind overhang_gauge{
    "overhang",
    "m",
    1,
    GaugeExtent::line,
    reading::surface | reading::run_up,
    "length of the line from where water from its point on first ends to where water ends for the last time: an "
    "upright "
    "line passes air below water in a breaker or a jet",
    [](const Gauge& gauge, const WaterReader& water) -> GaugeReading {
        return {water.surface(gauge.point, gauge.end) - water.run_up(gauge.point, gauge.end)};
    }};

inline constexpr GaugeKind turbulent_energy_gauge{
    "turbulent_energy",
    "m^5/s^2",
    1,
    GaugeExtent::box,
    reading::turbulent_energy,
    "k of the water in the box between point and end, summed over its volume; times the density it is the energy",
    [](const Gauge& gauge, const WaterReader& water) -> GaugeReading {
        return {water.turbulent_energy(gauge.point, gauge.end)};
    }};

/// Every kind, in the order of the manual.
inline constexpr std::array all_gauges{
    &pressure_gauge, &velocity_gauge,      &level_gauge,    &surface_gauge,         &run_up_gauge,
    &flow_gauge,     &volume_gauge,        &centre_gauge,   &mean_velocity_gauge,   &flow_error_gauge,
    &changed_gauge,  &wall_pressure_gauge, &overhang_gauge, &turbulent_energy_gauge};

}  // namespace riprap::fluid
