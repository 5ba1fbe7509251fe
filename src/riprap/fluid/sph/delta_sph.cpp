// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "riprap/core/parallel.hpp"
#include "riprap/fluid/particle/linear_law.hpp"
#include "riprap/fluid/sph/acoustic_damping.hpp"
#include "riprap/fluid/sph/continuity.hpp"
#include "riprap/fluid/sph/forces.hpp"
#include "riprap/fluid/sph/kick.hpp"
#include "riprap/fluid/sph/pair_sums.hpp"
#include "riprap/fluid/sph/schemes.hpp"
#include "riprap/fluid/sph/shifting.hpp"
#include "riprap/fluid/sph/sph_scratch.hpp"
#include "riprap/fluid/sph/tearing.hpp"
#include "riprap/fluid/sph/wall_pressure.hpp"

namespace riprap::fluid {
namespace {

WendlandC2 kernel_of(const SphSettings& s) { return WendlandC2(s.smoothing_length(), s.domain.dimension); }

/// Calls work(pair) with the viscosity of the case between pairs of particles.
template <class Work>
void with_viscosity(const SphSettings& settings, const Work& work) {
    settings.viscosity.visit([&](const auto& law) { work(law.pair(settings, kernel_of(settings))); });
}

/// sqrt(2 S:S) from the second sum of Continuity
double strain_rate(const SphSettings& settings, double sum) {
    return std::sqrt(std::max(0.0, (settings.domain.dimension + 2) * sum));
}

/// Account of shifting in a step.
struct Shifting {
    double potential{0};        ///< energy of place that it took away [J]
    double longest_squared{0};  ///< [m^2]
};

/// Moves particles and notes the share of density that this takes.
Shifting shift_particles(const SphSettings& settings, ParticleState& state, const Vec3& gravity, double dt,
                         const ContinuitySums& sums, const WaterFields& water, const ForceSums& forces) {
    if (settings.shifting == 0) {
        return {};
    }
    const auto shift_one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        const Vec3 gradient = sums.concentration_gradient.vector(i);
        const Vec3 shift = shift_of_particle(settings, gradient, forces.pushes.vector(i, ForceSums::at_surface),
                                             water.bareness[i], strain_rate(settings, sums.strain[i]), dt);
        state.position[i] += shift;
        state.dilution[i] = dilution_by_shift(shift, gradient, water.correction_share[i]);
        return Shifting{settings.particle_mass * dot(gravity, shift), norm_squared(shift)};
    };
    return parallel::reduce(state.owned(), Shifting{}, shift_one, [](const Shifting& a, const Shifting& b) {
        return Shifting{a.potential + b.potential, std::max(a.longest_squared, b.longest_squared)};
    });
}

GradientCorrection correction_of(const SphSettings& settings, const Symmetric& moments) {
    return settings.gradient_correction ? gradient_correction(settings.domain.dimension, moments)
                                        : GradientCorrection{unit_tensor, 0};
}

/// Energy that leaves the compression as density is updated, by diffusion and tearing and by shifting [J].
struct Losses {
    double diffusion{0}, shifting{0};
};

double trace(int dimension, const Symmetric& tensor) {
    return tensor[0] + tensor[1] + (dimension == 3 ? tensor[3] : 0);
}

/// Notes from the water alone, before walls are added: tr M, and how much of a particle is inside it, away from
/// surfaces and walls, with neighbours evenly all around.
void look_around(int dimension, double h, const ContinuitySums& sums, WaterFields& water) {
    parallel::for_each(static_cast<std::int64_t>(water.correction.size()), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        const double moments = trace(dimension, water.correction.all(i));
        const double lopsidedness = h * norm(sums.concentration_gradient.vector(i));
        water.correction_share.set(i, moments);
        water.damped_share.set(i, interior_share(moments / dimension) * even_share(lopsidedness));
    });
}

/// Finds the sums of Continuity and ContinuityAtWalls.
void sum_continuity(const SphSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
                    const Vec3& gravity, WaterFields& water, SweepLists& lists, ContinuitySums& sums) {
    const auto count = state.density.size();
    sums.diffusion.resize(count, settings.is_plain);
    sums.strain.resize(count, settings.is_plain);
    sums.rates.resize(count, settings.is_plain);
    sums.concentration_gradient.resize(count, settings.is_plain);
    const WendlandC2 kernel = kernel_of(settings);
    const Vec3 weight = settings.rest_density * gravity;
    const double h = settings.smoothing_length();
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    const auto m = [&](std::size_t k) { return water.correction.sink(k); };
    const auto g = [&](std::size_t k) { return sums.rates.sink(k); };
    const auto c = [&](std::size_t axis) { return sums.concentration_gradient.sink(axis); };
    add_pair_sums_within(settings, Continuity{kernel, {weight.x, weight.y, weight.z}, 1e-4 * h * h},
                         {state.position, {v(0), v(1), v(2), water.pressure.view(), water.volume.view()}},
                         fresh<17>({sums.diffusion.sink(), sums.strain.sink(), m(0), m(1), m(2), m(3), m(4), m(5), g(0),
                                    g(1), g(2), g(3), g(4), g(5), c(0), c(1), c(2)}),
                         lists.fluid_fluid);
    look_around(settings.domain.dimension, h, sums, water);
    add_pair_sums(settings, ContinuityAtWalls{kernel}, {state.position, {v(0), v(1), v(2)}},
                  {walls.position,
                   {component(walls.velocity, 0), component(walls.velocity, 1), component(walls.velocity, 2),
                    field(walls.volume)}},
                  {m(0), m(1), m(2), m(3), m(4), m(5), g(0), g(1), g(2), g(3), g(4), g(5), c(0), c(1), c(2)},
                  lists.fluid_walls);
}

void make_room_for_density(const SphSettings& settings, std::size_t particles, WaterFields& water) {
    water.correction.resize(particles, settings.is_plain);
    for (Numbers<1>* numbers :
         {&water.bareness, &water.correction_share, &water.damped_share, &water.compression_rate}) {
        numbers->resize(particles, settings.is_plain);
    }
}

void update_density(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                    const Vec3& gravity, double dt, SphScratchData& s, FluidReport& report) {
    WaterFields& water = s.water;
    if (s.continuity.rates.size() == 0) {
        s.exchange_memory_of_rate();
        s.exchange_memory();
    }
    s.lists.place({settings.support_radius(), settings.domain}, state.position, walls.position);
    find_pressure(settings, state, water);
    make_room_for_density(settings, state.density.size(), water);
    sum_continuity(settings, state, walls, gravity, water, s.lists, s.continuity);
    const ContinuitySums& sums = s.continuity;
    const int dimension = settings.domain.dimension;
    const double h = settings.smoothing_length();
    const PressureLaw pressure_at(settings);
    const double diffusivity = 2 * settings.density_diffusion * h / (settings.sound_speed * settings.rest_density);
    const auto advance_one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        const Symmetric moments = water.correction.all(i);
        const double divergence = trace(dimension, moments), alone = water.correction_share[i];
        const double bareness = bareness_of_particle(dimension, divergence);
        const bool leaves_wall =
            may_leave_walls(bareness, bareness_of_particle(dimension, alone), divergence / dimension);
        const GradientCorrection correction = correction_of(settings, moments);
        const double caught = caught_share(alone / dimension, divergence / dimension);
        for (std::size_t k = 0; k < correction.tensor.size(); ++k) {
            water.correction.set(i, k, (1 - caught) * correction.tensor[k]);
        }
        water.bareness.set(i, bareness);
        water.correction_share.set(i, correction.share);
        water.damped_share.set(i, water.damped_share[i] * correction.share);
        const double before = state.density[i];
        const double diluted = density_after_shift(before, state.dilution[i], settings.rest_density);
        const double spread = dt * diluted * diffusivity * sums.diffusion[i];
        const double compression_rate = contract(dimension, water.correction.all(i), sums.rates.all(i));
        water.compression_rate.set(i, compression_rate);
        const double flown = diluted + dt * diluted * compression_rate + spread;
        const double torn =
            density_by_tearing(bareness, leaves_wall, flown, settings.rest_density) +
            density_by_escape(caught, flown, settings.rest_density, settings.sound_speed * dt / settings.spacing);
        const double after = flown + torn;
        const double mean = 0.5 * (before + after);
        state.density[i] = after;
        // what each takes out of compression, m p/rho^2 d rho, halfway between the densities that forces see
        const double per_density = settings.particle_mass * pressure_at(mean) / (mean * mean);
        return Losses{-per_density * (spread + torn), per_density * (before - diluted)};
    };
    const Losses losses = parallel::reduce(state.owned(), Losses{}, advance_one, [](Losses a, const Losses& b) {
        return Losses{a.diffusion + b.diffusion, a.shifting + b.shifting};
    });
    report.dissipated_diffusion = losses.diffusion;
    report.shifted = losses.shifting;
}

/// Finds the fields that the sums of forces read, from densities and the sums of Continuity: volume, the pressure with
/// damping and its heat, and the viscosity.
void prepare_forces(const SphSettings& settings, const ParticleState& state, const ContinuitySums& sums,
                    WaterFields& water, ForceSums& forces) {
    const auto count = state.density.size();
    water.pressure.resize(count, settings.is_plain);
    water.volume.resize(count, settings.is_plain);
    forces.wall_heat.resize(count, settings.is_plain);
    const PressureLaw pressure_at(settings);
    const double resistance = resistance_of_damping(settings);
    settings.viscosity.visit([&]<class Law>(const Law& law) {
        water.dynamic_viscosity.resize(Law::follows_strain ? count : 1, settings.is_plain);
        const auto viscosity = [&](double strain_sum) {
            return settings.rest_density * law.kinematic(settings, strain_rate(settings, strain_sum));
        };
        if (!Law::follows_strain) {
            water.dynamic_viscosity.set(0, viscosity(0));
        }
        parallel::for_each(static_cast<std::int64_t>(count), [&](std::int64_t entry) {
            const auto i = static_cast<std::size_t>(entry);
            if constexpr (Law::follows_strain) {
                water.dynamic_viscosity.set(i, viscosity(sums.strain[i]));
            }
            water.volume.set(i, settings.particle_mass / state.density[i]);
            const double damping = resistance * water.damped_share[i] * water.compression_rate[i];
            forces.wall_heat.set(i, damping * water.compression_rate[i]);
            water.pressure.set(i, pressure_at(state.density[i]) + damping);
        });
    });
}

void begin_forces(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                  SphScratchData& s) {
    s.exchange_memory();
    s.lists.place({settings.support_radius(), settings.domain}, state.position, walls.position);
    prepare_forces(settings, state, s.continuity, s.water, s.forces);
    s.exchange_memory_of_rate();
    make_room_for_forces(settings, state.position.size(), s.forces);
    sum_at_walls(settings, kernel_of(settings), state, walls, s);
    with_viscosity(settings, [&](const auto& law) { add_fluid_forces(settings, kernel_of(settings), state, law, s); });
    settings.viscosity.visit([&](const auto& law) {
        if constexpr (requires { law.add_stress(settings, state, walls, s); }) {
            law.add_stress(settings, state, walls, s);
        }
    });
}

void load_walls(const SphSettings& settings, const ParticleState& state, BoundaryParticles& walls, const Vec3& gravity,
                SphScratchData& s) {
    extrapolate_to_walls(settings, s.at_walls, gravity, walls, s.walls);
    with_viscosity(settings,
                   [&](const auto& law) { find_forces_on_walls(settings, kernel_of(settings), state, walls, law, s); });
    settings.viscosity.visit([&](const auto& law) {
        if constexpr (requires { law.add_stress_on_walls(settings, state, walls, s); }) {
            law.add_stress_on_walls(settings, state, walls, s);
        }
    });
}

void kick_fluid(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                double dt, SphScratchData& s, FluidReport& report, const SparseVectors& extra_force) {
    with_viscosity(
        settings, [&](const auto& law) { add_forces_from_walls(settings, kernel_of(settings), state, walls, law, s); });
    settings.viscosity.visit([&](const auto& law) {
        if constexpr (requires { law.add_stress_from_walls(settings, state, walls, s); }) {
            law.add_stress_from_walls(settings, state, walls, s);
        }
    });
    const Shifting shifting = shift_particles(settings, state, without_periodic(gravity, settings.domain), dt,
                                              s.continuity, s.water, s.forces);
    report.shifted += shifting.potential;
    report.max_shift = std::sqrt(shifting.longest_squared);
    kick(settings, state, gravity, dt, s.water.volume, s.forces, extra_force, report);
    book_walls(walls, dt, report);
}

}  // namespace

const Scheme delta_sph_scheme{update_density, begin_forces, load_walls, kick_fluid};

}  // namespace riprap::fluid
