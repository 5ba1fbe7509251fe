// SPDX-License-Identifier: Apache-2.0
#pragma once

// Functors for host and device: they find at one wall particle what follows from its sums over the water.

#include <algorithm>
#include <cstdint>

#include "riprap/fluid/particle/columns.hpp"
#include "riprap/fluid/particle/sweep/numbers.hpp"

namespace riprap::fluid {

/// Mirrors the velocity of the water in the face of a wall, see SphForces::load.
struct MirrorVelocity {
    WallColumns walls;
    NumbersView<1> weight;
    NumbersView<3> velocity;
    NumbersView<3> mirrored_velocity;
    NumbersView<1> grip;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto w = static_cast<std::size_t>(entry);
        const double sum = weight[w];
        const Vec3& v = walls.foot_velocity[w];
        mirrored_velocity.set_vector(w, sum > 0 ? 2.0 * v - velocity.vector(w) / sum : v);
        grip.set(w, walls.is_slippery[w] != 0 ? 0 : 1);
    }
};

/// Mean pressure of the water about a wall particle, carried to it under a pull [m/s^2]; 0 where it is dry [Pa].
struct PressureAtWall {
    NumbersView<1> weight, pressure;
    NumbersView<3> moment;

    RIPRAP_HD double operator()(std::size_t w, const Vec3& pull) const {
        const double sum = weight[w];
        const double head = dot(pull, moment.vector(w));
        return sum > 0 ? std::max(0.0, (pressure[w] + head) / sum) : 0;
    }
};

/// Describes the water about a wall particle under this gravity, as WaterAtWalls has it.
struct DescribeWall {
    PressureAtWall at_wall;
    NumbersView<3> slope;
    Vec3 gravity;
    double* weight_there;
    double* pressure_there;
    Vec3* slope_there;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto w = static_cast<std::size_t>(entry);
        weight_there[w] = at_wall.weight[w];
        slope_there[w] = slope.vector(w);
        pressure_there[w] = at_wall(w, gravity);
    }
};

/// Extrapolates the pressure of the water to a wall particle that accelerates.
struct ExtrapolateToWall {
    WallColumns walls;
    PressureAtWall at_wall;
    Vec3 gravity;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto w = static_cast<std::size_t>(entry);
        const bool is_given = walls.given_pressure != nullptr && walls.given_pressure[w] >= 0;
        walls.pressure[w] = is_given ? walls.given_pressure[w] : at_wall(w, gravity - walls.acceleration[w]);
    }
};

/// Makes a force zero, before sums are added to it.
struct ClearForce {
    Vec3* force;
    RIPRAP_HD void operator()(std::int64_t w) const { force[w] = Vec3{}; }
};

/// Finds the force of pressure from the sums of PressureOnWalls, and that of viscosity from the one per volume [N].
struct ForceOnWall {
    WallColumns walls;
    NumbersView<3> slope, push;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto w = static_cast<std::size_t>(entry);
        walls.pressure_force[w] = -walls.volume[w] * (walls.pressure[w] * slope.vector(w) + push.vector(w));
        walls.viscous_force[w] *= walls.volume[w];
    }
};

}  // namespace riprap::fluid
