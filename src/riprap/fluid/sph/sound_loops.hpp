// SPDX-License-Identifier: Apache-2.0
#pragma once

// Functors that do to one particle what a scheme of two clocks does between its sums (docs/theory/sph.md, 12).

#include <algorithm>
#include <cstdint>

#include "riprap/fluid/particle/columns.hpp"
#include "riprap/fluid/particle/linear_law.hpp"
#include "riprap/fluid/particle/sparse_vectors.hpp"
#include "riprap/fluid/sph/kick_loops.hpp"
#include "riprap/fluid/sph/water_loops.hpp"

namespace riprap::fluid {

/// Holds what a particle is as long as the geometry lasts, besides its Corrections.
struct Surroundings {
    NumbersView<1> bareness;     ///< b [-]
    NumbersView<1> leaves_wall;  ///< 1 where may_leave_walls, else 0
    NumbersView<1> caught;       ///< lambda of caught_share [-]
    NumbersView<1> volume;       ///< V of the beginning of the flow step [m^3]
    NumbersView<3> wall_slope;   ///< sum V_w F d [1/m]
    NumbersView<3> slow_force;   ///< of viscosity, at the velocities of the beginning [N]
    NumbersView<1> rate;         ///< -div v of the last sound step [1/s]
};

/// Corrects the gradients of a geometry from the sums of Continuity, as AdvanceDensity does in every step, and finds
/// -div v of the velocities at the beginning.
struct CorrectGeometry {
    int dimension;
    bool corrects_gradients;
    DensitySums sums;
    Corrections corrections;  ///< may have the places of the sums
    Surroundings around;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        const Symmetric moments = sums.moments.all(i);
        const double whole = trace(dimension, moments), alone = sums.moments_alone[i];
        const double bare = bareness_of_particle(dimension, whole);
        const double caught = caught_share(alone / dimension, whole / dimension);
        const GradientCorrection found =
            corrects_gradients ? gradient_correction(dimension, moments) : GradientCorrection{make_unit_tensor(), 0};
        for (std::size_t k = 0; k < found.tensor.size(); ++k) {
            corrections.tensor.set(i, k, (1 - caught) * found.tensor[k]);
        }
        corrections.share.set(i, found.share);
        corrections.damped.set(i, sums.inside[i] * found.share);
        around.rate.set(i, contract(dimension, corrections.tensor.all(i), sums.rates.all(i)));
        around.bareness.set(i, bare);
        around.caught.set(i, caught);
        const bool leaves = may_leave_walls(bare, bareness_of_particle(dimension, alone), whole / dimension);
        around.leaves_wall.set(i, leaves ? 1 : 0);
    }
};

/// Keeps the slow forces of a flow step [N].
struct KeepSlowForce {
    NumbersView<1> volume;
    NumbersView<3> force, slow_force;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        slow_force.set_vector(i, volume[i] * force.vector(i));
    }
};

/// Finds the pressure of the density, and no volume.
struct PressureOfDensity {
    PressureLaw pressure_at;
    const double* density;
    NumbersView<1> pressure;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        pressure.set(i, pressure_at(density[i]));
    }
};

/// Carries the density over a sound step between walls that stand still,
///
///     rho += dt (rho^2 V/m) (B:G + v.B sum V_w F d + diffusion),
///
/// then tearing, leaving walls and escape as AdvanceDensity. rho^2 V/m in place of rho: 1/rho changes by what the
/// volumes of the geometry say, so that force and compression are conjugate, and diffusion takes from one side of a
/// pair the volume that it gives to the other.
struct AdvanceOnGeometry {
    double dt, diffusivity, gone;  ///< as in AdvanceDensity
    double rest_density, particle_mass;
    PressureLaw pressure_at;
    double* density;
    const double* dilution;  ///< nullptr: nothing is due
    double* damping;         ///< nullptr: sound is not damped
    double resistance;  ///< of the damping of sound in the next kick; 0 where another update comes before it [Pa s]
    const Vec3* velocity;
    NumbersView<1> diffusion;
    NumbersView<1> damped;  ///< s_i of Sound [-]
    bool has_walls;         ///< the rate has the part of walls
    NumbersView<symmetric_numbers> correction;
    Surroundings around;

    RIPRAP_HD DensityUpdate operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        const double before = density[i];
        const double diluted = dilution != nullptr ? density_after_shift(before, dilution[i], rest_density) : before;
        const double share = dt * diluted * diluted * around.volume[i] / particle_mass;
        const Vec3 slope = around.wall_slope.vector(i);
        double rate = around.rate[i];
        if (!has_walls && slope != Vec3{}) {
            rate += dot(symmetric_apply(correction.all(i), slope), velocity[i]);
            around.rate.set(i, rate);
        }
        const double spread = share * diffusivity * diffusion[i];
        const double flown = diluted + share * rate + spread;
        const bool leaves_wall = around.leaves_wall[i] != 0;
        const double torn = density_by_tearing(around.bareness[i], leaves_wall, flown, rest_density);
        const double escaped = density_by_escape(around.caught[i], flown, rest_density, gone);
        const double after = flown + (torn + escaped), mean = 0.5 * (before + after);
        density[i] = after;
        DensityParts parts{before, diluted, after, spread, torn, escaped, leaves_wall};
        parts.refused = dilution != nullptr ? before * (1 - dilution[i]) - diluted : 0;
        // pairs take what they give to round-off
        DensityUpdate update =
            book_density(parts, particle_mass, pressure_at(mean), -particle_mass / (diluted * diluted) * spread);
        const double next = damping != nullptr ? resistance * damped[i] * around.volume[i] * rate : 0;
        update.damping = turn_damping(damping != nullptr ? damping + i : nullptr, next, rate);
        return update;
    }
};

/// Finds the pressure that forces see, with the damping of sound, and the half of the heat of that which the velocities
/// before the kick make.
struct DampSound {
    PressureLaw pressure_at;
    double resistance;  ///< [Pa s]
    const double* density;
    NumbersView<1> rate, damped;  ///< -div v [1/s]; s_i of Sound [-]
    NumbersView<1> pressure, heat;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        const double damping = resistance * damped[i] * rate[i];
        heat.set(i, 0.5 * damping * rate[i]);
        pressure.set(i, pressure_at(density[i]) + damping);
    }
};

/// Kicks one particle by the forces of sound, the slow ones and walls that stand still. The work of slow forces is heat
/// at the mean of both velocities.
struct KickOnGeometry {
    double particle_mass, dt;
    Vec3 gravity, along;  ///< all of it, and the part along periodic axes, which has no potential
    ParticleColumns water;
    NumbersView<symmetric_numbers> correction;
    Surroundings around;
    NumbersView<1> pressure, heat;
    NumbersView<3> force, pushed;  ///< of the water; sum V_w p_w F d of walls
    WaterInPlace::Extra extra_force;

    RIPRAP_HD KickSums operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        const double m = particle_mass, v = around.volume[i];
        const Vec3 extra = extra_force[i], slow = around.slow_force.vector(i);
        const Vec3 slope = around.wall_slope.vector(i);
        Vec3 push = v * force.vector(i), hold{};
        if (slope != Vec3{}) {  // else there are no walls in reach
            const Symmetric b = correction.all(i);
            hold = v * symmetric_apply(b, pushed.vector(i));
            push -= hold + (v * pressure[i]) * symmetric_apply(b, slope);
        }
        const Vec3 acceleration = (push + slow + extra) / m + gravity;
        const Vec3 before = water.velocity[i], after = before + dt * acceleration;
        water.velocity[i] = after;
        KickSums sums;
        sums.kinetic = 0.5 * m * dot(before, after);
        sums.mass_moment = m * water.position[i];
        sums.heat = v * heat[i] - 0.5 * dot(slow, before + after);
        sums.exchange = dot(hold, after);
        sums.earlier_exchange = 0.5 * dot(hold, before - after);
        sums.external = 0.5 * dot(extra + m * along, before + after);
        sums.speed_squared = norm_squared(after);
        sums.acceleration_squared = norm_squared(acceleration);
        sums.momentum = m * after;
        sums.extra = extra;
        return sums;
    }
};

/// Most that shifting would move water of a geometry: the largest (1 - b) |S| [1/s].
struct UrgeToShift {
    int dimension;
    NumbersView<1> strain, bareness;

    RIPRAP_HD double operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        return (1 - bareness[i]) * strain_rate(dimension, strain[i]);
    }
};
struct Largest {
    RIPRAP_HD double operator()(double a, double b) const { return std::max(a, b); }
};

/// A part of the shift of a flow step: moves a particle, and its place in the geometry with it.
struct ShiftPart {
    ShiftParticle whole;  ///< of the time of the part; its dilution is made anew
    double steps;         ///< sound steps in the part [-]
    bool is_first;
    Vec3* place;

    RIPRAP_HD Shifted operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        const Vec3 gradient = whole.concentration_gradient.vector(i);
        const Vec3 shift =
            shift_of_particle(whole.strength, whole.h, gradient, whole.to_surface.vector(i), whole.bareness[i],
                              strain_rate(whole.dimension, whole.strain[i]), whole.dt, steps);
        whole.position[i] += shift;
        place[i] += shift;
        whole.dilution[i] =
            (is_first ? 0 : whole.dilution[i]) + dilution_by_shift(shift, gradient, whole.correction_share[i]);
        return {whole.particle_mass * dot(whole.gravity, shift), norm_squared(shift)};
    }
};

}  // namespace riprap::fluid
