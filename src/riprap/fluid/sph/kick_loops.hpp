// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "riprap/fluid/particle/columns.hpp"
#include "riprap/fluid/particle/sweep/numbers.hpp"
#include "riprap/fluid/sph/sph_numbers.hpp"

namespace riprap::fluid {

/// Sums of a kick over the particles.
struct KickSums {
    double kinetic{0}, heat{0}, exchange{0}, earlier_exchange{0}, external{0};
    double speed_squared{0}, acceleration_squared{0};
    Vec3 momentum{}, extra{}, mass_moment{};

    template <class By>
    RIPRAP_HD static void join(KickSums& a, const KickSums& b, const By& by) {
        by.add(a.kinetic, b.kinetic);
        by.add(a.heat, b.heat);
        by.add(a.exchange, b.exchange);
        by.add(a.earlier_exchange, b.earlier_exchange);
        by.add(a.external, b.external);
        by.largest(a.speed_squared, b.speed_squared);
        by.largest(a.acceleration_squared, b.acceleration_squared);
        by.add(a.momentum, b.momentum);
        by.add(a.extra, b.extra);
        by.add(a.mass_moment, b.mass_moment);
    }
};

/// Kicks one particle, v += dt (V force + extra force)/m + dt g. `Extra` gives the extra force on particle i [N].
template <class Extra>
struct KickParticle {
    double particle_mass, dt;
    Vec3 gravity, along;  ///< all of it, and the part along periodic axes, which has no potential
    ParticleColumns water;
    NumbersView<1> volume;
    ForceSums sum;
    Extra extra_force;

    RIPRAP_HD KickSums operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        const double m = particle_mass, v = volume[i];
        const Vec3 extra = extra_force[i];
        const Vec3 acceleration = (v * sum.force.vector(i) + extra) / m + gravity;
        const Vec3 before = water.velocity[i], after = before + dt * acceleration;
        water.velocity[i] = after;
        KickSums sums;
        sums.kinetic = 0.5 * m * dot(before, after);
        sums.mass_moment = m * water.position[i];
        sums.heat = v * (0.5 * sum.heat[i] + sum.wall_heat[i]);
        // half of it along the velocity before the kick, half along that after it
        const Vec3 hold = v * sum.wall_hold.vector(i);
        sums.exchange = dot(hold, after) - v * sum.wall_hold_power[i];
        sums.earlier_exchange = 0.5 * dot(hold, before - after);
        sums.external = 0.5 * dot(extra + m * along, before + after);
        sums.speed_squared = norm_squared(after);
        sums.acceleration_squared = norm_squared(acceleration);
        sums.momentum = m * after;
        sums.extra = extra;
        return sums;
    }
};

}  // namespace riprap::fluid
