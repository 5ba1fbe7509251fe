// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "riprap/core/vec3.hpp"

namespace riprap::fluid {

/// Readings of the water, as bits: those that a kind of gauge needs, and those that a fluid offers.
namespace reading {
inline constexpr unsigned pressure = 1, velocity = 2, level = 4, surface = 8, run_up = 16, flow = 32, volume = 64,
                          wall_pressure = 128, centre = 256, mean_velocity = 512, flow_error = 1024, changed = 2048,
                          turbulent_energy = 4096, none = 0, all = 8191,
                          of_particles = all & ~(flow_error | changed | turbulent_energy);
}  // namespace reading

/// The water of any fluid at one moment, as instruments read it: SI, in the world. A fluid overrides the readings that
/// it offers. A dry place reads 0.
class WaterReader {
 public:
    virtual ~WaterReader() = default;
    /// At a point [Pa].
    virtual double pressure(const Vec3& /*x*/) const { return unknown; }
    /// At a point [m/s].
    virtual Vec3 velocity(const Vec3& /*x*/) const { return {unknown, unknown, unknown}; }
    /// Height of the water column above a point at the bed, voids left out [m].
    virtual double level(const Vec3& /*x*/, const Vec3& /*up*/) const { return unknown; }
    /// Distance from the start of a line to its last crossing of the surface [m].
    virtual double surface(const Vec3& /*start*/, const Vec3& /*end*/) const { return unknown; }
    /// Distance from the start of a line to the first place where water from there ends [m].
    virtual double run_up(const Vec3& /*start*/, const Vec3& /*end*/) const { return unknown; }
    /// Through a rectangle across an axis, positive along it [m^3/s], in 2D [m^2/s].
    virtual double flow(const Vec3& /*low*/, const Vec3& /*high*/) const { return unknown; }
    /// Of the water in a box [m^3], in 2D [m^2].
    virtual double volume(const Vec3& /*low*/, const Vec3& /*high*/) const { return unknown; }
    /// Mean place of the water in a box [m].
    virtual Vec3 centre(const Vec3& /*low*/, const Vec3& /*high*/) const { return {unknown, unknown, unknown}; }
    /// Mean velocity of the water in a box [m/s].
    virtual Vec3 mean_velocity(const Vec3& /*low*/, const Vec3& /*high*/) const { return {unknown, unknown, unknown}; }
    /// Root of the mean square of each component of the velocity less that of the flow of the case, in a box [m/s].
    virtual Vec3 flow_error(const Vec3& /*low*/, const Vec3& /*high*/) const { return {unknown, unknown, unknown}; }
    /// Volume in a box that has got water since the start, and that has lost it [m^3], in 2D [m^2].
    virtual double changed(const Vec3& /*low*/, const Vec3& /*high*/) const { return unknown; }
    /// Turbulent energy k of the water in a box, summed over its volume [m^5/s^2], in 2D [m^4/s^2]; 0 where the flow is
    /// laminar.
    virtual double turbulent_energy(const Vec3& /*low*/, const Vec3& /*high*/) const { return unknown; }
    /// On the face of the gauge that is read: force over area in the last step [Pa].
    virtual double wall_pressure() const { return unknown; }

 protected:
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace riprap::fluid
