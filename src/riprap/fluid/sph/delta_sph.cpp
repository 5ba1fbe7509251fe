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

/// What shifting did in a step.
struct Shifting {
    double potential{0};        ///< energy of place that it took away [J]
    double longest_squared{0};  ///< [m^2]
};

/// Moves particles and notes the share of density that this takes.
Shifting shift_particles(const SphSettings& settings, ParticleState& state, const Vec3& gravity, double dt,
                         const SphScratchData& s) {
    if (settings.shifting == 0) {
        return {};
    }
    const auto shift_one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        const Vec3 shift = shift_of_particle(settings, s.concentration_gradient[i], s.surface_direction[i],
                                             s.bareness[i], strain_rate(settings, s.strain[i]), dt);
        state.position[i] += shift;
        state.dilution[i] = dilution_by_shift(shift, s.concentration_gradient[i], s.correction_share[i]);
        return Shifting{settings.particle_mass * dot(gravity, shift), norm_squared(shift)};
    };
    return parallel::reduce(state.size(), Shifting{}, shift_one, [](const Shifting& a, const Shifting& b) {
        return Shifting{a.potential + b.potential, std::max(a.longest_squared, b.longest_squared)};
    });
}

GradientCorrection correction_of(const SphSettings& settings, const Symmetric& moments) {
    return settings.gradient_correction ? gradient_correction(settings.domain.dimension, moments)
                                        : GradientCorrection{unit_tensor, 0};
}

/// What leaves the energy of compression as density is updated, by diffusion and tearing and by shifting [J].
struct Losses {
    double diffusion{0}, shifting{0};
};

double trace(int dimension, const Symmetric& tensor) {
    return tensor[0] + tensor[1] + (dimension == 3 ? tensor[3] : 0);
}

/// From the water alone: tr M_f, kept in s.bareness until walls are known, and how much of a particle is inside it,
/// away from surfaces and walls, with neighbours evenly all around.
void look_around(int dimension, double h, SphScratchData& s) {
    s.bareness.resize(s.correction.size());
    s.damped_share.resize(s.correction.size());
    parallel::for_each(static_cast<std::int64_t>(s.correction.size()), [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        const double moments = trace(dimension, s.correction[i]);
        s.bareness[i] = moments;
        s.damped_share[i] = interior_share(moments / dimension) * even_share(h * norm(s.concentration_gradient[i]));
    });
}

/// The sums of Continuity and ContinuityAtWalls: moments into s.correction, rates into s.pressure_tensor, the gradient
/// of concentration; into s.bareness and s.damped_share what look_around finds before the walls are added.
void sum_continuity(const SphSettings& settings, const ParticleState& state, const BoundaryParticles& walls,
                    const Vec3& gravity, SphScratchData& s) {
    s.diffusion.resize(state.density.size());
    s.strain.resize(state.density.size());
    s.correction.resize(state.density.size());
    s.pressure_tensor.resize(state.density.size());
    s.concentration_gradient.resize(state.density.size());
    const WendlandC2 kernel = kernel_of(settings);
    const Vec3 weight = settings.rest_density * gravity;
    const double h = settings.smoothing_length();
    const auto v = [&](int axis) { return component(state.velocity, axis); };
    const auto m = [&](std::size_t k) { return sink_tensor(s.correction, k); };
    const auto g = [&](std::size_t k) { return sink_tensor(s.pressure_tensor, k); };
    const auto c = [&](int axis) { return sink_component(s.concentration_gradient, axis); };
    add_pair_sums_within(settings, Continuity{kernel, {weight.x, weight.y, weight.z}, 1e-4 * h * h},
                         {state.position, {v(0), v(1), v(2), field(s.pressure), field(s.volume)}},
                         fresh<17>({sink(s.diffusion), sink(s.strain), m(0), m(1), m(2), m(3), m(4), m(5), g(0), g(1),
                                    g(2), g(3), g(4), g(5), c(0), c(1), c(2)}),
                         s.fluid_fluid);
    look_around(settings.domain.dimension, h, s);
    add_pair_sums(settings, ContinuityAtWalls{kernel}, {state.position, {v(0), v(1), v(2)}},
                  {walls.position,
                   {component(walls.velocity, 0), component(walls.velocity, 1), component(walls.velocity, 2),
                    field(walls.volume)}},
                  {m(0), m(1), m(2), m(3), m(4), m(5), g(0), g(1), g(2), g(3), g(4), g(5), c(0), c(1), c(2)},
                  s.fluid_walls);
}

void update_density(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                    const Vec3& gravity, double dt, SphScratchData& s, FluidReport& report) {
    find_pressure(settings, state, s);
    sum_continuity(settings, state, walls, gravity, s);
    s.correction_share.resize(state.density.size());
    s.squeeze.resize(state.density.size());
    const int dimension = settings.domain.dimension;
    const double h = settings.smoothing_length();
    const PressureLaw pressure_at(settings);
    const double diffusivity = 2 * settings.density_diffusion * h / (settings.sound_speed * settings.rest_density);
    const auto advance_one = [&](std::int64_t entry) {
        const auto i = static_cast<std::size_t>(entry);
        const Symmetric moments = s.correction[i];
        const double divergence = trace(dimension, moments), alone = s.bareness[i];
        const double bareness_alone = bareness_of_particle(dimension, alone);
        s.bareness[i] = bareness_of_particle(dimension, divergence);
        const bool leaves_wall = may_leave_walls(s.bareness[i], bareness_alone, divergence / dimension);
        const GradientCorrection correction = correction_of(settings, moments);
        const double caught = caught_share(alone / dimension, divergence / dimension);
        for (std::size_t k = 0; k < correction.tensor.size(); ++k) {
            s.correction[i][k] = (1 - caught) * correction.tensor[k];
        }
        s.correction_share[i] = correction.share;
        s.damped_share[i] *= correction.share;
        const double before = state.density[i];
        const double diluted = density_after_shift(before, state.dilution[i], settings.rest_density);
        const double spread = dt * diluted * diffusivity * s.diffusion[i];
        s.squeeze[i] = contract(dimension, s.correction[i], s.pressure_tensor[i]);
        const double flown = diluted + dt * diluted * s.squeeze[i] + spread;
        const double torn =
            density_by_tearing(s.bareness[i], leaves_wall, flown, settings.rest_density) +
            density_by_escape(caught, flown, settings.rest_density, settings.sound_speed * dt / settings.spacing);
        const double after = flown + torn;
        const double mean = 0.5 * (before + after);
        state.density[i] = after;
        // what each takes out of compression, m p/rho^2 d rho, halfway between the densities that forces see
        const double per_density = settings.particle_mass * pressure_at(mean) / (mean * mean);
        return Losses{-per_density * (spread + torn), per_density * (before - diluted)};
    };
    const Losses losses = parallel::reduce(state.size(), Losses{}, advance_one, [](Losses a, const Losses& b) {
        return Losses{a.diffusion + b.diffusion, a.shifting + b.shifting};
    });
    report.dissipated_diffusion = losses.diffusion;
    report.shifted = losses.shifting;
}

/// Finds what the sums of forces read, from densities and the sums of Continuity: pressure and volume, the pressure
/// with damping and its tensor p B, and the viscosity.
void prepare_forces(const SphSettings& settings, const ParticleState& state, SphScratchData& s) {
    const auto count = state.density.size();
    s.pressure.resize(count);
    s.volume.resize(count);
    s.dynamic_viscosity.resize(count);
    s.pressure_tensor.resize(count);
    const PressureLaw pressure_at(settings);
    const double resistance = resistance_of_damping(settings);
    settings.viscosity.visit([&](const auto& law) {
        parallel::for_each(static_cast<std::int64_t>(count), [&](std::int64_t entry) {
            const auto i = static_cast<std::size_t>(entry);
            s.dynamic_viscosity[i] =
                settings.rest_density * law.kinematic(settings, strain_rate(settings, s.strain[i]));
            s.volume[i] = settings.particle_mass / state.density[i];
            const double damping = resistance * s.damped_share[i] * s.squeeze[i];
            s.wall_heat[i] = damping * s.squeeze[i];
            s.pressure[i] = pressure_at(state.density[i]) + damping;
            for (std::size_t k = 0; k < s.correction[i].size(); ++k) {
                s.pressure_tensor[i][k] = s.pressure[i] * s.correction[i][k];
            }
        });
    });
}

void begin_forces(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls,
                  SphScratchData& s) {
    make_room_for_forces(state.position.size(), s);
    prepare_forces(settings, state, s);
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
    extrapolate_to_walls(walls, gravity, s);
    with_viscosity(settings,
                   [&](const auto& law) { find_forces_on_walls(settings, kernel_of(settings), state, walls, law, s); });
    settings.viscosity.visit([&](const auto& law) {
        if constexpr (requires { law.add_stress_on_walls(settings, state, walls, s); }) {
            law.add_stress_on_walls(settings, state, walls, s);
        }
    });
}

void kick_fluid(const SphSettings& settings, ParticleState& state, const BoundaryParticles& walls, const Vec3& gravity,
                double dt, SphScratchData& s, FluidReport& report, std::span<const Vec3> extra_force) {
    with_viscosity(
        settings, [&](const auto& law) { add_forces_from_walls(settings, kernel_of(settings), state, walls, law, s); });
    settings.viscosity.visit([&](const auto& law) {
        if constexpr (requires { law.add_stress_from_walls(settings, state, walls, s); }) {
            law.add_stress_from_walls(settings, state, walls, s);
        }
    });
    const Shifting shifting = shift_particles(settings, state, without_periodic(gravity, settings.domain), dt, s);
    report.shifted += shifting.potential;
    report.max_shift = std::sqrt(shifting.longest_squared);
    kick(settings, state, gravity, dt, s, extra_force, report);
    book_walls(walls, dt, report);
}

}  // namespace

const Scheme delta_sph_scheme{update_density, begin_forces, load_walls, kick_fluid};

}  // namespace riprap::fluid
