// SPDX-License-Identifier: Apache-2.0
#pragma once

// Functors for host and device: they do to one particle of water what delta_sph does between its sums over neighbours.

#include <cstdint>

#include "riprap/fluid/particle/columns.hpp"
#include "riprap/fluid/particle/flow_work.hpp"
#include "riprap/fluid/particle/linear_law.hpp"
#include "riprap/fluid/particle/sweep/numbers.hpp"
#include "riprap/fluid/particle/volume_book.hpp"
#include "riprap/fluid/sph/acoustic_damping.hpp"
#include "riprap/fluid/sph/gradient_correction.hpp"
#include "riprap/fluid/sph/roughness.hpp"
#include "riprap/fluid/sph/shifting.hpp"
#include "riprap/fluid/sph/sph_numbers.hpp"
#include "riprap/fluid/sph/tearing.hpp"

namespace riprap::fluid {

/// sqrt(2 S:S) from the second sum of Continuity [1/s]
RIPRAP_HD inline double strain_rate(int dimension, double sum) {
    return std::sqrt(std::max(0.0, (dimension + 2) * sum));
}

/// Finds the roughness of the flow about particles from the sums of Continuity, where a viscosity goes by it.
struct FindRoughness {
    int dimension;
    DensitySums sums;
    NumbersView<1> strain, roughness;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        const double m = trace(dimension, sums.moments.all(i)) / dimension;
        roughness.set(i, fluid::roughness(dimension, sums.rates.all(i), (dimension + 2) * strain[i], m));
    }
};

/// Finds pressure and volume from the density.
struct FindPressure {
    PressureLaw pressure_at;
    double particle_mass;
    const double* density;
    NumbersView<1> pressure, volume;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        pressure.set(i, pressure_at(density[i]));
        volume.set(i, particle_mass / density[i]);
    }
};

/// Notes from the water alone, before walls are added: tr M and tr G, and how much of a particle is inside it, away
/// from surfaces and walls, with neighbours evenly all around.
struct LookAround {
    int dimension;
    double h;
    NumbersView<3> concentration_gradient;
    DensitySums sums;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        const double sum = trace(dimension, sums.moments.all(i));
        const double lopsidedness = h * norm(concentration_gradient.vector(i));
        sums.moments_alone.set(i, sum);
        sums.rates_alone.set(i, trace(dimension, sums.rates.all(i)));
        sums.inside.set(i, interior_share(sum / dimension) * even_share(lopsidedness));
    }
};

/// Tells what leaves the compression as density is updated, and what becomes of the volume.
struct DensityUpdate {
    DensityLosses losses;  ///< [J]
    double shifting{0};    ///< the same by shifting [J]
    VolumeBook volume;     ///< [m^3]
    FlowWork flow;         ///< of a step with a geometry of its own
    double damping{0};     ///< of sound, by the stress of the last kick and the velocities after it [W]

    template <class By>
    RIPRAP_HD static void join(DensityUpdate& a, const DensityUpdate& b, const By& by) {
        by.add(a.losses, b.losses);
        by.add(a.shifting, b.shifting);
        by.add(a.volume, b.volume);
        FlowWork::join(a.flow, b.flow, by);
        by.add(a.damping, b.damping);
    }
};

/// Returns the power of the damping that acted in the last kick, whose other half is due now, and keeps what will act
/// in the next one.
/// @param of_last  ParticleState::damping of the particle; nullptr where sound is not damped
/// @param next     V a s h rho_0 c_0 (-div v) [J], @param rate  -div v [1/s]
RIPRAP_HD inline double turn_damping(double* of_last, double next, double rate) {
    if (of_last == nullptr) {
        return 0;
    }
    const double last = *of_last;
    *of_last = next;
    return last * rate;
}

/// Parts of an update of the density of a particle, in the order in which they act [kg/m^3].
struct DensityParts {
    double before, diluted;  ///< density at first; without what shifting takes
    double after;            ///< at the end
    double spread;           ///< gained by diffusion
    double torn, escaped;    ///< gained by the rules of surfaces and of water caught between walls
    bool leaves_wall;        ///< the first of these is that of water that leaves a wall
    double refused{0};       ///< lost less than the shift says
};

/// Books an update of density: each part takes m p/rho^2 d rho out of compression, halfway between the densities that
/// forces see, and has -m d rho/(rho rho') of the volume; flow has what is left of that.
/// @param pressure          at the mean of the densities before and after [Pa]
/// @param diffusion_volume  of diffusion, by the volume that a pair exchanges [m^3]
RIPRAP_HD inline DensityUpdate book_density(const DensityParts& parts, double particle_mass, double pressure,
                                            double diffusion_volume) {
    const double before = parts.before, after = parts.after, mean = 0.5 * (before + after);
    const double per_density = particle_mass * pressure / (mean * mean), per_gain = -particle_mass / (before * after);
    DensityUpdate update{{-per_density * parts.spread, -per_density * parts.torn, -per_density * parts.escaped, 0},
                         per_density * (before - parts.diluted),
                         {},
                         {},
                         0};
    VolumeBook& volume = update.volume;
    (parts.leaves_wall ? volume.walls : volume.tearing) = per_gain * parts.torn;
    volume.escape = per_gain * parts.escaped;
    volume.shifting = per_gain * (parts.diluted - before);
    volume.refused = per_gain * parts.refused;
    volume.diffusion = diffusion_volume;
    volume.flow = per_gain * (after - before) - volume.sum();
    return update;
}

/// Carries the density over a step by the sums of Continuity, and corrects the gradients (docs/theory/sph.md, 4).
struct AdvanceDensity {
    int dimension;
    bool corrects_gradients;
    double dt, diffusivity, gone;  ///< [s]; 2 delta h/(c_0 rho_0) [m^3 s/kg]; of density_by_escape [-]
    double rest_density, particle_mass;
    PressureLaw pressure_at;
    double* density;
    const double* dilution;
    double* damping;    ///< nullptr: sound is not damped
    double resistance;  ///< of the damping of sound [Pa s]
    DensitySums sums;
    Corrections corrections;  ///< may have the places of the sums
    NumbersView<1> bareness;

    RIPRAP_HD DensityUpdate operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        const Symmetric moments = sums.moments.all(i);
        const double divergence = trace(dimension, moments), alone = sums.moments_alone[i];
        const double bare = bareness_of_particle(dimension, divergence);
        const bool leaves_wall = may_leave_walls(bare, bareness_of_particle(dimension, alone), divergence / dimension);
        const double caught = caught_share(alone / dimension, divergence / dimension);
        correct(i, moments, caught);
        bareness.set(i, bare);
        const double before = density[i];
        const double diluted = density_after_shift(before, dilution[i], rest_density);
        const double spread = dt * diluted * diffusivity * sums.diffusion[i];
        const double rate = contract(dimension, corrections.tensor.all(i), sums.rates.all(i));
        corrections.compression_rate.set(i, rate);
        const double flown = diluted + dt * diluted * rate + spread;
        const double torn = density_by_tearing(bare, leaves_wall, flown, rest_density);
        const double escaped = density_by_escape(caught, flown, rest_density, gone);
        const double after = flown + (torn + escaped);
        const double mean = 0.5 * (before + after);
        density[i] = after;
        DensityParts parts{before, diluted, after, spread, torn, escaped, leaves_wall};
        parts.refused = before * (1 - dilution[i]) - diluted;
        // pairs take what they give to round-off
        DensityUpdate update =
            book_density(parts, particle_mass, pressure_at(mean), -particle_mass / (before * diluted) * spread);
        // by the mean of B's diagonal: where walls are near, B is next to 1
        const double of_walls = trace(dimension, corrections.tensor.all(i)) / dimension *
                                (trace(dimension, sums.rates.all(i)) - sums.rates_alone[i]);
        update.flow = work_of_flow(before, after, dt * diluted, rate - of_walls, of_walls);
        const double next = damping != nullptr ? resistance * corrections.damped[i] * particle_mass / after * rate : 0;
        update.damping = turn_damping(damping != nullptr ? damping + i : nullptr, next, rate);
        return update;
    }

 private:
    /// Finds what flow stores and what forces do: they see the volumes of both sides as they are at their time, an
    /// update those before it; walls keep theirs. The volume of a neighbour is taken to change as the particle's own.
    /// @param gain  by which density grows, over the rate [kg s/m^3]
    RIPRAP_HD FlowWork work_of_flow(double before, double after, double gain, double of_water, double of_walls) const {
        const double mean = 0.5 * (before + after);
        return {particle_mass * pressure_at(mean) / (mean * mean) * gain * (of_water + of_walls),
                particle_mass / before * pressure_at(before) * (of_water + of_walls),
                particle_mass / after * pressure_at(after) * (of_water * before / after + of_walls)};
    }

    RIPRAP_HD void correct(std::size_t i, const Symmetric& moments, double caught) const {
        const GradientCorrection found =
            corrects_gradients ? gradient_correction(dimension, moments) : GradientCorrection{make_unit_tensor(), 0};
        for (std::size_t k = 0; k < found.tensor.size(); ++k) {
            corrections.tensor.set(i, k, (1 - caught) * found.tensor[k]);
        }
        corrections.share.set(i, found.share);
        corrections.damped.set(i, sums.inside[i] * found.share);
    }
};

/// Finds the fields that the sums of forces read: volume, the pressure with damping and the half of its heat that the
/// velocities before the kick make, and the viscosity.
template <class Law>
struct PrepareForces {
    ParticleSettings settings;
    Law law;
    PressureLaw pressure_at;
    double resistance;  ///< of the damping of sound [Pa s]
    const double* density;
    NumbersView<1> strain;
    Corrections corrections;
    NumbersView<1> dynamic_viscosity, volume, pressure, heat;

    RIPRAP_HD void operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        if constexpr (Law::follows_strain) {
            const double rate = strain_rate(settings.domain.dimension, strain[i]);
            dynamic_viscosity.set(i, settings.rest_density * law.kinematic(settings, rate));
        }
        volume.set(i, settings.particle_mass / density[i]);
        const double damping = resistance * corrections.damped[i] * corrections.compression_rate[i];
        heat.set(i, 0.5 * damping * corrections.compression_rate[i]);
        pressure.set(i, pressure_at(density[i]) + damping);
    }
};

/// Account of shifting in a step.
struct Shifted {
    double potential{0};        ///< energy of place that it took away [J]
    double longest_squared{0};  ///< [m^2]

    template <class By>
    RIPRAP_HD static void join(Shifted& a, const Shifted& b, const By& by) {
        by.add(a.potential, b.potential);
        by.largest(a.longest_squared, b.longest_squared);
    }
};

/// Moves a particle towards even surroundings and notes the share of density that this takes.
struct ShiftParticle {
    int dimension;
    double strength, h, dt, particle_mass;
    Vec3 gravity;
    Vec3* position;
    double* dilution;
    NumbersView<3> concentration_gradient;
    NumbersView<1> strain, bareness, correction_share;
    NumbersView<3> to_surface;

    RIPRAP_HD Shifted operator()(std::int64_t entry) const {
        const auto i = static_cast<std::size_t>(entry);
        const Vec3 gradient = concentration_gradient.vector(i);
        const Vec3 shift = shift_of_particle(strength, h, gradient, to_surface.vector(i), bareness[i],
                                             strain_rate(dimension, strain[i]), dt);
        position[i] += shift;
        dilution[i] = dilution_by_shift(shift, gradient, correction_share[i]);
        return {particle_mass * dot(gravity, shift), norm_squared(shift)};
    }
};

}  // namespace riprap::fluid
