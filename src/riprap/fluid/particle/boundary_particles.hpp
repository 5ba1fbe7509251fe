// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "riprap/core/bytes.hpp"
#include "riprap/core/vec3.hpp"

namespace riprap::fluid {

/// Length of the normals of particles that no way is along the faces of: see BoundaryParticles::normal [-].
constexpr double length_in_vertex = 2;

/// Particles that stand for walls and blocks inside the kernel sums, as the fluid sees them: where they are, how they
/// move, what they take. Whoever moves the solids fills the inputs and carries the forces back; the fluid knows no
/// body. One entry per particle; the order never changes, so sums follow it.
struct BoundaryParticles {
    std::vector<Vec3> position;             ///< [m]
    std::vector<Vec3> velocity;             ///< of the solid there [m/s]
    std::vector<Vec3> foot_velocity;        ///< of the solid at its foot on the face; empty: as `velocity` [m/s]
    std::vector<Vec3> acceleration;         ///< of the solid there [m/s^2]
    std::vector<double> volume;             ///< [m^3]; in 2D [m^2]
    std::vector<std::uint8_t> is_slippery;  ///< free slip: no viscous force
    std::vector<double> given_pressure;     ///< instead of that of the fluid; none where negative, or empty [Pa]

    /// Outward normal n of the face that each of them lies under; times the root of 1 - s where the share s of it lies
    /// in solid that two bodies with faces of their own share, whose water slides along both. Times length_in_vertex
    /// where solids meet whose faces have no way along all of them. Empty where no fluid asks for it [-].
    std::vector<Vec3> normal;
    std::vector<Vec3> outward_area;  ///< area of solid that a particle stands for, along the outward normal, zero
                                     ///< below the outermost layer; empty where no fluid asks for it [m^2]

    std::vector<double> pressure;  ///< of the fluid there, found by the fluid [Pa]

    /// Forces of the fluid on each particle, pair by pair the opposite of what the fluid felt [N]. That of pressure
    /// acts at the particle, that of viscosity at its foot.
    std::vector<Vec3> pressure_force, viscous_force;

    std::size_t bytes() const {
        return bytes_of(position, velocity, foot_velocity, acceleration, volume, is_slippery, given_pressure, normal,
                        outward_area, pressure, pressure_force, viscous_force);
    }
    std::int64_t size() const { return static_cast<std::int64_t>(position.size()); }
    /// Velocity that water which sticks has on the face before each of them.
    std::span<const Vec3> at_face() const { return foot_velocity.empty() ? velocity : foot_velocity; }
};

/// The water about every boundary particle, whatever the solids do: for the water in joints between them.
struct WaterAtWalls {
    std::vector<double> weight;    ///< sum W; 0 where there is no water within the support [1/m^3]
    std::vector<double> pressure;  ///< mean pressure, carried to the particle as in water at rest; never negative [Pa]
    std::vector<Vec3> slope;       ///< sum V B grad W, towards the water [1/m]
    std::size_t bytes() const { return bytes_of(weight, pressure, slope); }
};

}  // namespace riprap::fluid
